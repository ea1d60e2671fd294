// SPDX-License-Identifier: Apache-2.0
#include "models/structured/solid/pair_kernels.h"

#include "models/structured/solid/pair_sums.h"

namespace frana::structured {

const PairKernels& plain_pair_kernels() {
    static constexpr PairKernels k_kernels{velocity_gradients, accelerations};
    return k_kernels;
}

// The processor is checked here: the source of the fast kernels must not run on one without AVX2.
const PairKernels& pair_kernels() {
#if defined(__x86_64__)
    const PairKernels* fast = compiled_pair_kernels();
    if (fast != nullptr && __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return *fast;
#endif
    return plain_pair_kernels();
}

}  // namespace frana::structured
