// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tuple>

#include "mpm/nodes_to_particles.h"
#include "physics/stress_laws.h"

namespace frana {

/// nodes_to_particles under a law of stress in the plane.
template <class Stress>
struct NodesToParticles {
    ParticleReport (*stage)(const ParticleTile&, const ParticleUpdate&, const Stress&, const NodeGrid&, ParticleSet&);
};

/// Apart from VectorKernels, which more sources use than a law's change should compile.
struct StressKernels {
    StressLaws::ForEach<NodesToParticles, NoStress> by_law;

    template <class Stress>
    [[nodiscard]] auto of() const noexcept {
        return std::get<NodesToParticles<Stress>>(by_law).stage;
    }
};

}  // namespace frana
