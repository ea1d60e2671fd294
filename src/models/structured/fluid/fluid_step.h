// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "core/thread_pool.h"
#include "models/structured/fluid/fluid_state.h"

namespace frana::structured {

/// Forgets the ground of all tiles, as after a change of it, and copies it again where there is fluid. Water in a cell
/// that becomes a wall remains there and does not move.
void set_ground(FluidState& state, const NodeGrid& nodes, const FluidLaws& laws);

/// Adds fluid to cells, in the order given; volume and momentum are added as they are. Between two steps, by one
/// thread. Returns the depths not added because the cell is a wall or a gap [m].
double receive(std::span<const FluidSource> sources, FluidState& state, const NodeGrid& nodes, const FluidLaws& laws);

/// Longest stable step in the present state (share/doc/structured.md, "Scheme") [s]; infinity if no cell is wet:
///     dt <= cfl / max[ (|u| + c)/dx + (|v| + c)/dx ],  c = sqrt(g h_u);   dt <= 0.1 dx^2 / nu
double stable_step(const FluidState& state, const NodeGrid& nodes, const FluidLaws& laws, const SolidsOnGrid& solid,
                   ThreadPool& pool);

/// Advances the fluid by dt [s] over the bed of `nodes` and the solids in `solid`: pressure and terrain, Manning,
/// viscous and enhanced stress, without drag, virtual mass and buoyancy (models/structured/coupling). A dt over
/// stable_step is subdivided. The same bits for any number of threads.
FluidReport advance(FluidState& state, const NodeGrid& nodes, const FluidLaws& laws, const SolidsOnGrid& solid,
                    double dt, ThreadPool& pool);

/// Volume of fluid inside [m3], summed tile by tile over all tiles that were ever wet.
double fluid_volume(const FluidState& state, const NodeGrid& nodes, ThreadPool& pool);

}  // namespace frana::structured
