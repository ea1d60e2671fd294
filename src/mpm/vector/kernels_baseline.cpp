// SPDX-License-Identifier: Apache-2.0
#include "mpm/vector/kernel_table.h"

namespace frana {

const VectorKernels& baseline_kernels() {
    static constexpr VectorKernels k_kernels = kernel_table("baseline");
    return k_kernels;
}

}  // namespace frana
