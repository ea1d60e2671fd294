// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mpm/nodes_to_particles.h"

namespace frana {

/// The particle sweeps of the default scheme (quadratic splines, APIC, referenced pressure) for one instruction set.
/// The plain templates of mpm/ say what they compute; tests compare the two. Results are the same to rounding, and
/// the same bits for the same instruction set.
struct VectorKernels {
    const char* name;
    void (*particles_to_nodes)(const ParticleTile&, const ParticleSet&, NodeGrid&);
    void (*particles_and_levels_to_nodes)(const ParticleTile&, const ParticleSet&, NodeGrid&);
    void (*pressure_to_nodes)(const ParticleTile&, const ParticleSet&, double gravity, NodeGrid&);
    void (*pressure_and_stress_to_nodes)(const ParticleTile&, const ParticleSet&, double gravity, NodeGrid&);
    ParticleReport (*nodes_to_particles)(const ParticleTile&, const ParticleUpdate&, const BinghamStress&,
                                         const NodeGrid&, ParticleSet&);
    ParticleReport (*nodes_to_particles_with_stress)(const ParticleTile&, const ParticleUpdate&,
                                                     const BinghamStress&, const NodeGrid&, ParticleSet&);
};

/// What every processor of the architecture can do, and what AVX2 and FMA can; the latter is null on other
/// architectures.
const VectorKernels& baseline_kernels();
const VectorKernels* avx2_kernels();

/// The best that this processor can run.
const VectorKernels& best_kernels();

}  // namespace frana
