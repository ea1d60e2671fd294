// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "core/raster.h"

namespace frana {

/// What makes a terrain model doubtful as ground. Each is silent on planes, lakes and what was interpolated.
struct GroundDoubts {
    /// Cells that were copied (resampled by nearest neighbour): level blocks beside steps.
    struct Blocks {
        double columns = 0, rows = 0;  ///< mean size of a block [cells]
        double share = 0;              ///< of the cells looked at
    };
    /// Level ground between steps of at least k_terrace_step: whole metres, contours that were not interpolated.
    struct Terraces {
        double step = 0;   ///< median [m]
        double share = 0;  ///< of the cells looked at
        Point place;       ///< one of them, in coordinates of the grid
    };
    /// A straight step between smooth ground on both sides, along rows or columns: between two tiles.
    struct Seam {
        double height = 0;  ///< mean [m]
        double length = 0;  ///< [cells]
        Point place;        ///< its middle
    };
    /// Patches of one value far below all that surrounds them: values that mean no data.
    struct Pits {
        double value = 0;        ///< [m]
        std::int64_t cells = 0;  ///< of this value
        double share = 0;        ///< of the cells looked at
        Point place;             ///< of the first
    };
    /// Cells that stand out of every line through them: trees of a surface model, or noise.
    struct Rough {
        double height = 0;  ///< of these, median [m]
        double share = 0;   ///< of the flow's own path, the lowest part of the cells looked at
        Point place;        ///< of the highest
    };
    /// A narrow dam across the path: a road or a bridge over what carries water.
    struct Dam {
        double height = 0;  ///< that water must rise [m]
        Point place;
    };
    std::optional<Blocks> blocks;
    std::optional<Terraces> terraces;
    std::optional<Seam> seam;
    std::optional<Pits> pits;
    std::optional<Rough> rough;
    std::optional<Dam> dam;
};

inline constexpr double k_terrace_step = 0.25;  ///< [m]

/// @param ground in its file's own cells: resampling hides what is looked for
/// @param path reachable_ground() on the same grid: the cells looked at are those above 0
/// @param cell_size [m]; the grid's own unit may be degrees
GroundDoubts ground_doubts(const Raster& ground, const Raster& path, double cell_size);

/// Marks with 1 what a mass can reach, with 2 where `start` is positive: cells connected to these below its energy
/// line, which begins at the highest of them, `start` metres above the ground, and falls by `friction` per metre.
Raster reachable_ground(const Raster& ground, const Raster& start, double friction);

}  // namespace frana
