// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "core/thread_pool.h"
#include "models/structured/fluid/fluid_state.h"

namespace frana::structured {

/// Takes walls, gaps and slopes from the nodes; FluidState's constructor does so too. Where a wall rises in water, the
/// water stays there and does not move.
void set_ground(FluidState& state, const NodeGrid& nodes, const FluidLaws& laws);

/// Adds fluid to cells, in the order given; volume and momentum are added as they are. Between two steps, by one
/// thread. Returns the depths that it could not add because a wall or a gap stands there [m].
double receive(std::span<const FluidSource> sources, FluidState& state, const FluidLaws& laws);

/// Longest step the present state allows (share/doc/structured.md, "Scheme") [s]; infinity where nothing is wet:
///     dt <= cfl / max[ (|u| + c)/dx + (|v| + c)/dx ],  c = sqrt(g h_u);   dt <= 0.1 dx^2 / nu
double stable_step(const FluidState& state, const NodeGrid& nodes, const FluidLaws& laws, const SolidsOnGrid& solid,
                   ThreadPool& pool);

/// Moves the fluid on by dt [s] over the bed of `nodes` and what `solid` holds: pressure and terrain, Manning,
/// viscous and enhanced stress; not the drag, virtual mass and buoyancy that it shares with solids. A dt over
/// stable_step is taken in several steps. The same bits for any number of threads.
///
/// One page: fluid_step.cpp.
FluidReport advance(FluidState& state, const NodeGrid& nodes, const FluidLaws& laws, const SolidsOnGrid& solid,
                    double dt, ThreadPool& pool);

/// Fluid inside [m3], summed tile by tile over what was ever wet.
double fluid_volume(const FluidState& state, const NodeGrid& nodes, ThreadPool& pool);

}  // namespace frana::structured
