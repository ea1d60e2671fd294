// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "core/raster.h"

namespace frana {

/// High values of a raster. The greatest value is that of a single cell and depends on chance as much as on the flow;
/// the others are exceeded over an area.
struct PeakValues {
    double greatest = k_no_data;  ///< of all cells; NaN if none has a value
    double p999 = k_no_data;      ///< exceeded over a thousandth of the area; NaN if there is no area
    double p99 = k_no_data;       ///< exceeded over a hundredth of it
};

/// Returns the values of the cells that a mask on the same grid marks (neither 0 nor without data) and that have a
/// value; each cell has equal weight. See percentile().
PeakValues high_values(const Raster& raster, const Raster& mask);

/// Returns the value below which a fraction (0 to 1) of some values lies: of the sorted values, counted from 0, the one
/// at index fraction x (count - 1), interpolated linearly. NaN for no values; none of them may be NaN.
double percentile(std::vector<double> values, double fraction);

/// Elevations beyond are impossible: a wrong unit gives a factor of 100 at most [m].
inline constexpr double k_impossible_elevation = 1e5;
/// Those of ground that is not suspicious: Everest 8849 m; the Dead Sea's shore -440 m.
inline constexpr double k_highest_ground = 9000, k_lowest_ground = -500;

/// A cell and a value there.
struct Spot {
    std::int64_t row = 0, column = 0;
    double value = 0;
};

/// Statistics that reveal data that are not ground elevations: a wrong unit, a missing nodata value, single wrong
/// cells.
struct TerrainSanity {
    Spot highest, lowest;             ///< elevations [m]; of finite cells
    double median_slope_deg = 0;      ///< of at most a million cells, evenly sampled
    std::int64_t needles = 0;         ///< cells above, or below, all eight neighbours by more than the limit
    std::vector<Spot> first_needles;  ///< five at most, from the north; value: how much above (below: negative) [m]
};

/// One pass over a terrain with at least one elevation; cells without data are excluded, and so are needles at the edge
/// or beside such cells. `needle` [m].
TerrainSanity terrain_sanity(const Raster& terrain, double needle);

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
