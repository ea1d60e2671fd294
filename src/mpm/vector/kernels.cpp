// SPDX-License-Identifier: Apache-2.0
#include "mpm/vector/kernels.h"

namespace frana {

// In a source of its own: the one with the kernels is compiled for processors that may differ from this one.
const VectorKernels* vector_kernels() {
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return compiled_vector_kernels();
#endif
    return nullptr;
}

}  // namespace frana
