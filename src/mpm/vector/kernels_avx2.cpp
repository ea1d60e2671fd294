// SPDX-License-Identifier: Apache-2.0
// Compiled on x86-64 for AVX2 and FMA, and again for AVX-512 (see CMakeLists.txt); called only if the processor has
// them. Everything except the last function is local to this source, so that no other part of the program can run its
// code.
#include "mpm/vector/kernels.h"
#if defined(__AVX2__) && defined(__FMA__)
#include "mpm/vector/nodes_to_particles.h"
#include "mpm/vector/particles_to_nodes.h"
#include "mpm/vector/pressure.h"
#include "mpm/vector/stress_kernels.h"

namespace frana {
namespace {

template <class Stress>
ParticleReport shifting_or_not(const ParticleTile& tile, const ParticleUpdate& update, const Stress& stress,
                               const NodeGrid& nodes, ParticleSet& particles) {
    if (update.shift > 0) return vector_nodes_to_particles<true>(tile, update, stress, nodes, particles);
    return vector_nodes_to_particles<false>(tile, update, stress, nodes, particles);
}

template <class Stress>
struct OfStress : NodesToParticles<Stress> {
    constexpr OfStress() : NodesToParticles<Stress>{shifting_or_not<Stress>} {}
};

constexpr StressKernels k_stress_kernels{StressLaws::ForEach<OfStress, NoStress>{}};

constexpr VectorKernels k_kernels{k_compiled_instructions == Instructions::avx512 ? "AVX-512" : "AVX2 and FMA",
                                  vector_particles_to_nodes<false>,
                                  vector_particles_to_nodes<true>,
                                  vector_pressure_to_nodes<false>,
                                  vector_pressure_to_nodes<true>,
                                  k_stress_kernels};

}  // namespace

template <>
const VectorKernels& compiled_vector_kernels<k_compiled_instructions>() {
    return k_kernels;
}

}  // namespace frana

#endif
