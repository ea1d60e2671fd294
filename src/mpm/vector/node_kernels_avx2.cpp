// SPDX-License-Identifier: Apache-2.0
// As kernels_avx2.cpp, but without fused products and sums.
#include "mpm/vector/kernels.h"
#if defined(__AVX2__)
#include "mpm/vector/update_nodes.h"
#include "physics/friction_voellmy.h"

namespace frana {
namespace {

constexpr VectorNodeKernels k_kernels{vector_mean_levels, vector_node_references, vector_momenta_to_map,
                                      vector_update_nodes<Curved<NormalSlope>, UniformFriction>,
                                      vector_update_nodes<Curved<NormalSlope>, SummedFriction<NoExcess>>};

}  // namespace

template <>
const VectorNodeKernels& compiled_vector_node_kernels<k_compiled_instructions>() {
    return k_kernels;
}

}  // namespace frana

#endif
