// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "core/raster.h"

namespace frana {

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

}  // namespace frana
