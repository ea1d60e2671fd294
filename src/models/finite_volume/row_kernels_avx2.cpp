// SPDX-License-Identifier: Apache-2.0
#include "mpm/vector/kernels.h"
#if defined(__AVX2__)
#include "models/finite_volume/row_kernels.h"

namespace frana::finite_volume {

template <Instructions>
const RowKernels& compiled_row_kernels();
template <>
const RowKernels& compiled_row_kernels<k_compiled_instructions>() {
    return k_row_kernels;
}

}  // namespace frana::finite_volume

#endif
