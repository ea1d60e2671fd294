// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <optional>

#include "core/raster.h"

namespace frana {

/// Elevations [m] and slopes [degrees] of the ground on some cells.
struct GroundStatistics {
    double lowest = 0, highest = 0;
    double mean_slope_deg = 0, steepest_slope_deg = 0;  ///< of the cells' own slopes
};

/// Returns the slope of a cell from its eight neighbours [degrees] (Horn 1981, as GIS show it); NaN at the edge and
/// where one of the nine has no elevation.
double slope_deg(const Raster& terrain, std::int64_t row, std::int64_t column);

/// Returns the cosine of the slope of a cell's bed, by central differences, one-sided at the edge and beside missing
/// elevations; 1 where there is none.
double bed_cosine(const Raster& bed, std::int64_t row, std::int64_t column);

/// Returns depths normal to the bed [m] from vertical ones: times bed_cosine of each cell.
Raster normal_depth(const Raster& vertical, const Raster& bed);
/// The inverse of normal_depth.
Raster vertical_depth(const Raster& normal, const Raster& bed);

/// Collects cells. The terrain must outlive it.
class GroundSum {
  public:
    explicit GroundSum(const Raster& terrain) : terrain_(terrain) {}
    /// Ignores a cell outside the terrain or without elevation.
    void add(std::int64_t row, std::int64_t column);
    /// None if no cell has a slope.
    [[nodiscard]] std::optional<GroundStatistics> statistics() const;

  private:
    const Raster& terrain_;
    double lowest_ = std::numeric_limits<double>::infinity(), highest_ = -lowest_, sum_ = 0, steepest_ = 0;
    std::int64_t slopes_ = 0;
};

/// Statistics of the cells where `mask` exceeds a threshold. Its cells may be a part of the terrain's. Throws
/// Error(input) if they are not.
std::optional<GroundStatistics> ground_where(const Raster& terrain, const Raster& mask, double threshold);

}  // namespace frana
