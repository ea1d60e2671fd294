// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/raster.h"

namespace frana::gis {

enum class StackFormat { netcdf, zarr };

/// Frames as arrays (time, y, x) in one NetCDF-4 file or Zarr (version 2) folder, following the CF conventions (1.8):
/// time as a date (gis/access/table_in.h), coordinates of cell centres with standard names, units, grid mapping,
/// _FillValue -9999. Depth and velocity, Float32, compressed. Frames are written one by one, so that memory contains
/// only one.
class FrameStack {
  public:
    /// Creates the file or folder. `times` [s] of all frames to come; k_depth_item among `metadata`: the direction of
    /// depths. Throws Error(environment).
    FrameStack(std::string path, StackFormat format, const GridSpec& grid, const std::vector<double>& times,
               const std::map<std::string, std::string>& metadata);
    ~FrameStack();
    FrameStack(const FrameStack&) = delete;
    FrameStack& operator=(const FrameStack&) = delete;

    /// Writes one frame at its index in `times`. Throws Error(environment).
    void add(std::size_t index, const Raster& depth, const Raster& velocity);
    /// Writes the rest and closes. Throws Error(environment), also for a full disk.
    void close();

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace frana::gis
