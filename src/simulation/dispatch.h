// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "models/voellmy_bingham/stages.h"
#include "models/voellmy_bingham/state.h"
#include "simulation/scene.h"

namespace frana {

/// Which kernels compute the particles: the fastest that the processor supports, or the plain ones, which specify the
/// results of the fast ones.
enum class Kernels { fastest, plain };

/// Converts names to types: returns the stages of a scene. Those of the bed are chosen in dispatch_bed.cpp.
voellmy_bingham::Stages choose_stages(const Material& material, const MaterialZones& zones,
                                      const Entrainment& entrainment, const Numerics& numerics,
                                      Kernels kernels = Kernels::fastest);

/// Returns the laws with their parameters, in the engine's units.
/// @param gravity normal to the ground plane: numerics.gravity, or that of a tilted frame [m/s2]
/// @param nodes whose values by place are filled as their ground is taken
voellmy_bingham::Laws make_laws(const Material& material, const MaterialZones& zones, const Entrainment& entrainment,
                                const Numerics& numerics, NodeGrid& nodes, double gravity);

}  // namespace frana
