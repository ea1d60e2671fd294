// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "models/structured/fluid/fluid_state.h"
#include "models/structured/solid/solid_state.h"

namespace frana::structured {

/// Volumes of confined fluid set free [m3].
struct Released {
    double inside = 0;   ///< to the grid
    double outside = 0;  ///< where a particle has no cell of the terrain near, or that cell cannot take it
};

/// Gives the confined fluid that particles have set free to the grid, volume and momentum, and clears their accounts.
/// Reads u, v; reads and writes confined and released; in the particles' order.
Released release_fluid(SolidState& solid, const NodeGrid& grid, const FluidLaws& laws, FluidState& fluid);

}  // namespace frana::structured
