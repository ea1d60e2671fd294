// SPDX-License-Identifier: Apache-2.0
// Compiled for AVX2 and FMA on x86-64 (see CMakeLists.txt); called only where the processor has both.
#include "mpm/vector/kernel_table.h"

namespace frana {

const VectorKernels* avx2_kernels() {
#if defined(__AVX2__) && defined(__FMA__)
    static constexpr VectorKernels k_kernels = kernel_table("AVX2");
    return &k_kernels;
#else
    return nullptr;
#endif
}

}  // namespace frana
