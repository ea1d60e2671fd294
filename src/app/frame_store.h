// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/raster.h"
#include "simulation/result.h"

namespace frana::app {

/// Frames as files: FOLDER/depth_0000.tif, velocity_0000.tif and frames.csv (index, time_s). They are written
/// while a run goes on, so that memory holds one at a time.
class FrameWriter {
  public:
    /// `metadata` goes into every raster.
    explicit FrameWriter(std::string folder, std::map<std::string, std::string> metadata)
        : folder_(std::move(folder)), metadata_(std::move(metadata)) {}
    /// Throws Error(environment).
    void add(const Frame& frame);
    void finish() const;
    [[nodiscard]] double seconds() const noexcept { return seconds_; }  ///< wall time spent here
    [[nodiscard]] int count() const noexcept { return static_cast<int>(times_.size()); }

  private:
    std::string folder_;
    std::map<std::string, std::string> metadata_;
    std::vector<double> times_;
    double seconds_ = 0;
};

struct StoredFrame {
    double time = 0;  ///< [s]
    std::string depth_file;
    std::string velocity_file;
};

/// What frames.csv lists. Throws Error(input) when it is missing or broken.
std::vector<StoredFrame> stored_frames(const std::string& folder);

}  // namespace frana::app
