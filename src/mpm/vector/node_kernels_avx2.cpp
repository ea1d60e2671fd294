// SPDX-License-Identifier: Apache-2.0
// As kernels_avx2.cpp, but without fused products and sums.
#include "mpm/vector/kernels.h"
#if defined(__AVX2__)
#include "mpm/vector/update_nodes.h"
#endif

namespace frana {

#if defined(__AVX2__)

namespace {

constexpr VectorNodeKernels k_kernels{vector_mean_levels, vector_node_references, vector_momenta_to_map,
                                      vector_update_nodes<Curved<NormalSlope>, UniformFriction>,
                                      vector_update_nodes<Curved<NormalSlope>, SummedFriction<NoExcess>>};

}  // namespace

const VectorNodeKernels* compiled_vector_node_kernels() {
    return &k_kernels;
}

#else

const VectorNodeKernels* compiled_vector_node_kernels() {
    return nullptr;
}

#endif

}  // namespace frana
