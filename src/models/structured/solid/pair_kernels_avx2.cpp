// SPDX-License-Identifier: Apache-2.0
// Compiled for AVX2 and FMA on x86-64 (see src/CMakeLists.txt); called only if the processor has both.
#include "models/structured/solid/pair_kernels.h"
#if defined(__AVX2__) && defined(__FMA__)
#include "models/structured/solid/pair_sums.h"
#endif

namespace frana::structured {

#if defined(__AVX2__) && defined(__FMA__)

const PairKernels* compiled_pair_kernels() {
    static constexpr PairKernels k_kernels{velocity_gradients, accelerations};
    return &k_kernels;
}

#else

const PairKernels* compiled_pair_kernels() {
    return nullptr;
}

#endif

}  // namespace frana::structured
