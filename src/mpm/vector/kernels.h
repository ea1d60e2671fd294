// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mpm/nodes_to_particles.h"
#include "mpm/update_nodes.h"

namespace frana {

/// Sets of instructions that the kernels are compiled for, which give the same bits: AVX2 with FMA, and the same width
/// in AVX-512 (F, VL, DQ), which has twice the registers, and masks.
enum class Instructions { avx2, avx512 };

/// The default scheme's sweeps over particles (quadratic splines, APIC, referenced pressure), four particles or a row
/// of nodes at a time. The plain templates of mpm/ specify their results and serve processors without the instructions;
/// tests compare the two. Results are the same up to rounding.
struct VectorKernels {
    const char* instructions;  ///< their name
    void (*particles_to_nodes)(const ParticleTile&, const ParticleSet&, NodeGrid&);
    void (*particles_and_levels_to_nodes)(const ParticleTile&, const ParticleSet&, NodeGrid&);
    using Pressure = void (*)(const ParticleTile&, const ParticleSet&, double gravity, NodeGrid&);
    Pressure pressure_to_nodes, pressure_and_stress_to_nodes;
    const struct StressKernels& nodes_to_particles;  ///< by the law of stress: mpm/vector/stress_kernels.h
};

/// The sweeps over nodes of tiles that are four_at_a_time; update_nodes<Curved<NormalSlope>>. Products and sums are not
/// fused: a node has the same bits as by the plain formula, so that no frame's depth exceeds the greatest; only sums
/// over nodes differ by rounding.
struct VectorNodeKernels {
    using Sweep = void (*)(const NodeRange&, NodeGrid&);
    Sweep mean_levels, node_references, momenta_to_map;
    NodeReport (*uniform)(const NodeRange&, const NodeUpdate&, const UniformFriction&, double time, NodeGrid&, Maxima&);
    NodeReport (*summed)(const NodeRange&, const NodeUpdate&, const SummedFriction<NoExcess>&, double time, NodeGrid&,
                         Maxima&);
};

/// Returns whether VectorNodeKernels compute a tile: it has whole fours of nodes, and three around it, as
/// node_references needs: none in the outermost ring or among the ghosts.
inline bool four_at_a_time(const NodeRange& range, const NodeGrid& nodes) noexcept {
    constexpr std::int64_t ring = 3;
    return (range.i1 - range.i0) % 4 == 0 && range.i0 >= ring && range.j0 >= ring &&
           range.i1 <= nodes.stride() - ring && range.j1 <= nodes.padded_rows() - ring;
}

/// Returns the kernels in these instructions; null if the processor, or this build (FRANA_AVX512), lacks them.
const VectorKernels* vector_kernels(Instructions set);
const VectorNodeKernels* vector_node_kernels(Instructions set);
/// Returns those in the newest instructions that the processor has; null if it has none.
const VectorKernels* vector_kernels();
const VectorNodeKernels* vector_node_kernels();

/// Returns them as compiled for x86-64, whatever this processor supports.
template <Instructions>
const VectorKernels& compiled_vector_kernels();
template <Instructions>
const VectorNodeKernels& compiled_vector_node_kernels();

/// Those for which the including source is compiled: not inline, since sources differ.
#if defined(__AVX512VL__)
constexpr Instructions k_compiled_instructions = Instructions::avx512;
#else
constexpr Instructions k_compiled_instructions = Instructions::avx2;
#endif

}  // namespace frana
