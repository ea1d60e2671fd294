// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "models/voellmy_bingham/stages.h"
#include "models/voellmy_bingham/state.h"
#include "simulation/scene.h"

namespace frana {

/// Which kernels sweep over the particles: the fastest that the processor runs, or the plain ones that say
/// what the fast ones compute.
enum class Kernels { fastest, plain };

/// Where names become types: the stages that a scene asks for. The bed's are chosen in dispatch_bed.cpp.
voellmy_bingham::Stages choose_stages(const Material& material, const MaterialZones& zones,
                                      const Entrainment& entrainment, const Numerics& numerics,
                                      Kernels kernels = Kernels::fastest);

/// The laws with their parameters, in the engine's units.
/// @param gravity normal to the ground plane: numerics.gravity, or that of a tilted frame [m/s2]
voellmy_bingham::Laws make_laws(const Material& material, const MaterialZones& zones, const Entrainment& entrainment,
                                const Numerics& numerics, const NodeGrid& nodes, double gravity);

/// Whether particles and nodes exchange velocities along the bed rather than in map view.
bool follows_bed(const Numerics& numerics);

/// Whether what the bed throws off flies.
bool flies(const Numerics& numerics);

/// The transfer that is really used.
Transfer transfer_of(const Numerics& numerics);

}  // namespace frana
