// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "core/raster.h"

namespace frana {

/// A cell and a number about it.
struct Spot {
    std::int64_t row = 0, column = 0;
    double value = 0;
};

/// What tells ground from data that were taken for ground: a unit mistaken, "no data" forgotten, single wrong
/// cells.
struct TerrainSanity {
    Spot highest, lowest;             ///< elevations [m]; of finite cells
    double median_slope_deg = 0;      ///< of a million cells or fewer, evenly chosen
    std::int64_t needles = 0;         ///< cells that stand over, or lie under, all eight neighbours by more than asked
    std::vector<Spot> first_needles;  ///< five at most, from the north; value: how much over (under: negative) [m]
};

/// One pass over a terrain with at least one elevation; cells without data are left out, and so are needles
/// at the rim or beside such cells. `needle` [m].
TerrainSanity terrain_sanity(const Raster& terrain, double needle);

}  // namespace frana
