// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mpm/nodes_to_particles.h"

namespace frana {

/// The particle sweeps of the default scheme (quadratic splines, APIC, referenced pressure), four particles or a row
/// of nodes at a time. The plain templates of mpm/ say what they compute and serve processors without the
/// instructions; tests compare the two. Results are the same to rounding.
struct VectorKernels {
    void (*particles_to_nodes)(const ParticleTile&, const ParticleSet&, NodeGrid&);
    void (*particles_and_levels_to_nodes)(const ParticleTile&, const ParticleSet&, NodeGrid&);
    void (*pressure_to_nodes)(const ParticleTile&, const ParticleSet&, double gravity, NodeGrid&);
    void (*pressure_and_stress_to_nodes)(const ParticleTile&, const ParticleSet&, double gravity, NodeGrid&);
    using NodesToParticles = ParticleReport (*)(const ParticleTile&, const ParticleUpdate&, const BinghamStress&,
                                                const NodeGrid&, ParticleSet&);
    NodesToParticles nodes_to_particles, nodes_to_particles_with_stress;
    NodesToParticles along_bed, along_bed_with_stress;  ///< the same, following the bed
};

/// The kernels in AVX2 and FMA; null where the processor has not both.
const VectorKernels* vector_kernels();

/// Them as compiled, whatever this processor can run; null on other architectures.
const VectorKernels* compiled_vector_kernels();

}  // namespace frana
