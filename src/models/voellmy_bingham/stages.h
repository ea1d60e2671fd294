// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "models/voellmy_bingham/state.h"
#include "mpm/maxima.h"
#include "mpm/node_tiles.h"

namespace frana::voellmy_bingham {

/// The compile-time variants of a step's stages, chosen once at set-up. Each is called once a tile, so
/// choosing by pointer costs nothing inside the streaming loops, and variants multiply only where they share
/// a loop.
struct Stages {
    void (*particles_to_nodes)(const ParticleTile&, const ParticleSet&, NodeGrid&) = nullptr;
    void (*pressure_to_nodes)(const ParticleTile&, const ParticleSet&, double gravity, NodeGrid&) = nullptr;
    void (*hold_nodes)(const NodeRange&, const NodeUpdate&, const VoellmyFriction&, NodeGrid&) = nullptr;
    NodeReport (*update_nodes)(const NodeRange&, const NodeUpdate&, const VoellmyFriction&, double time,
                               NodeGrid&, Maxima&) = nullptr;
    ParticleReport (*nodes_to_particles)(const ParticleTile&, const ParticleUpdate&, const BinghamStress&,
                                         const NodeGrid&, ParticleSet&) = nullptr;
    bool references = false;  ///< pressure is measured against a still level or mean depth per node
    bool leapfrog = false;    ///< velocities live half a step before positions; otherwise at the same time
    bool resamples = false;   ///< particles split and merge
    FieldMask fields;         ///< what the particles carry for all of this
};

}  // namespace frana::voellmy_bingham
