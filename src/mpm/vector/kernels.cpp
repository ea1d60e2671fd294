// SPDX-License-Identifier: Apache-2.0
#include "mpm/vector/kernels.h"

namespace frana {

const VectorKernels& best_kernels() {
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return *avx2_kernels();
#endif
    return baseline_kernels();
}

}  // namespace frana
