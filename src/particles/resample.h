// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "core/grid_spec.h"
#include "core/thread_pool.h"
#include "particles/particle_set.h"
#include "particles/tile_order.h"

namespace frana {

/// Greatest distance that splitting moves a half, in cells: part of the drift since the last sort.
inline constexpr double k_split_reach = 0.5;

/// How many particles a cell has.
struct CellParticles {
    double split_extent;  ///< in cells: a longer particle is split into two along its longer axis, or into four
    double merge_extent;  ///< in cells: two particles merge only if the result is not longer
    int split_below;      ///< only in cells with fewer particles than this: elsewhere neighbours fill the gap
    int most;             ///< more than this in a cell: pairs merge; at least split_below - 1
};

/// Splitting and merging (share/doc/numerics.md, "Splitting and merging").
struct ResampleLimits {
    double cell_size = 1;
    CellParticles flow{0.7, 0.9, 6, 10};
    CellParticles film{1, 1.2, 2, 3};     ///< in cells whose particles have a mean depth below film_depth
    CellParticles tail{0.9, 1.1, 3, 4};   ///< in other cells that are marked as the tail of the flow
    double film_depth = 0;                ///< [m]
    double minimum_depth = 0.001;         ///< thinner particles are not split [m]
    Bounds edges;                         ///< of the terrain, local metres: no half is placed outside
    const std::uint8_t* marks = nullptr;  ///< of the padded nodes; none: no walls
    std::uint8_t wall_mark = 0;           ///< the mark of a wall: no half is placed there
};

struct ResampleCounts {
    std::int64_t split = 0, merged = 0;
};

/// Splits and merges tile by tile, in the particles' order. Volume, area and momentum are conserved; a merged pair
/// loses only the kinetic energy of its relative motion. Needs c_* and q_*, and an order that is planned: moves all
/// particles to their places at the same time.
/// @param left_alone one byte per tile: not 0 where nothing splits or merges; or empty
/// @param tail one byte per padded node: not 0 for the cells of the flow's tail; or null
ResampleCounts resample(ParticleSet& particles, TileOrder& order, const ResampleLimits& limits,
                        const std::vector<std::uint8_t>& left_alone, const std::uint8_t* tail, ThreadPool& pool);

}  // namespace frana
