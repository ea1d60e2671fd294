// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mpm/nodes_to_particles.h"

namespace frana {

/// The default scheme's sweeps over particles (quadratic splines, APIC, referenced pressure), four particles or a row
/// of nodes at a time. The plain templates of mpm/ specify their results and serve processors without the instructions;
/// tests compare the two. Results are the same up to rounding.
struct VectorKernels {
    void (*particles_to_nodes)(const ParticleTile&, const ParticleSet&, NodeGrid&);
    void (*particles_and_levels_to_nodes)(const ParticleTile&, const ParticleSet&, NodeGrid&);
    void (*pressure_to_nodes)(const ParticleTile&, const ParticleSet&, double gravity, NodeGrid&);
    void (*pressure_and_stress_to_nodes)(const ParticleTile&, const ParticleSet&, double gravity, NodeGrid&);
    using NodesToParticles = ParticleReport (*)(const ParticleTile&, const ParticleUpdate&, const BinghamStress&,
                                                const NodeGrid&, ParticleSet&);
    NodesToParticles nodes_to_particles, nodes_to_particles_with_stress;
    NodesToParticles along_bed, along_bed_with_stress;  ///< the same, for velocities along the bed
};

/// Returns the kernels in AVX2 and FMA; null if the processor lacks either.
const VectorKernels* vector_kernels();

/// Returns them as compiled, whatever this processor supports; null on other architectures.
const VectorKernels* compiled_vector_kernels();

}  // namespace frana
