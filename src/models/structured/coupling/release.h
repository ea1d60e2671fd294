// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "models/structured/fluid/fluid_state.h"
#include "models/structured/solid/solid_state.h"

namespace frana::structured {

/// Volumes of confined fluid released [m3].
struct Released {
    double inside = 0;   ///< to the grid
    double outside = 0;  ///< no terrain cell near the particle, or that cell cannot store fluid
};

/// Adds the confined fluid released by the particles to the grid, volume and momentum, and resets their released
/// volumes. Reads u, v; reads and writes confined and released; in the particles' order.
Released release_fluid(SolidState& solid, const NodeGrid& grid, const FluidLaws& laws, FluidState& fluid);

}  // namespace frana::structured
