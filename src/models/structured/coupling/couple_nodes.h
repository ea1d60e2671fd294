// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "models/structured/coupling/exchange.h"
#include "models/structured/fluid/fluid_state.h"
#include "models/structured/solid/solid_laws.h"
#include "models/structured/solid/solid_nodes.h"

namespace frana::structured {

/// The fluid's inputs at the nodes, as solids_to_fluid sets them.
SolidsOnGrid fluid_inputs(const SolidNodes& nodes);

/// Converts node sums to inputs of the fluid and of the drag: depth and velocity of solids with confined fluid,
/// fractions. For one tile of the solids.
void solids_to_fluid(const NodeRange& range, const NodeGrid& grid, const FluidState* fluid, SolidNodes& nodes);

/// Forces on the solids at the nodes of one of their tiles: terrain; with fluid, buoyancy, virtual mass
/// and drag, whose reactions change the fluid's discharge, and the bed's resistance to the column.
/// @param bed its resistance
/// @param fluid null: none
void push_solids(const NodeRange& range, double dt, const NodeGrid& grid, const SolidLaws& laws,
                 const CouplingLaws& coupling, const FluidLaws& bed, SolidNodes& nodes, FluidState* fluid);

}  // namespace frana::structured
