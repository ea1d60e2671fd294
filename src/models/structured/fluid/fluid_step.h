// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "core/thread_pool.h"
#include "models/structured/fluid/fluid_state.h"

namespace frana::structured {

/// What the sweeps of models/finite_volume read: pressure, terrain and, if they have it, Manning's resistance.
/// @param solid_depth padded; where it is greater than 0 that is left to `resist`; null: no solids
finite_volume::Laws sweeps_of(const FluidLaws& laws, const NodeGrid& nodes, const double* solid_depth = nullptr);

/// The ground has changed, or a saved state was read: what follows from it is read again under the fluid.
void set_ground(FluidState& state, const FluidLaws& laws);

/// Adds fluid to cells, in the order given; volume and momentum are added as they are. Between two steps, by one
/// thread. Returns the depths not added because the cell is a wall or a gap [m].
double receive(std::span<const FluidSource> sources, FluidState& state, const FluidLaws& laws);

/// Longest stable step in the present state (share/doc/structured.md, "Scheme") [s]; infinity if no cell is wet:
///     dt <= cfl dx / max(|u| + c, |v| + c),  c = sqrt(k g h_u);   dt <= 0.1 dx^2 / nu
double stable_step(FluidState& state, const FluidLaws& laws, const SolidsOnGrid& solid, ThreadPool& pool);

/// Advances the fluid by dt [s] over the bed of its nodes and the solids in `solid`: pressure and terrain by the rows
/// of models/finite_volume; Manning, viscous and enhanced stress; without drag, virtual mass and buoyancy
/// (models/structured/coupling). A dt over stable_step is subdivided. The same bits for any number of threads.
FluidReport advance(FluidState& state, const FluidLaws& laws, const SolidsOnGrid& solid, double dt, ThreadPool& pool);

/// Volume of fluid inside [m3].
double fluid_volume(const FluidState& state);

}  // namespace frana::structured
