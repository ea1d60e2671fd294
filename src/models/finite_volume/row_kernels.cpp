// SPDX-License-Identifier: Apache-2.0
#include "models/finite_volume/row_kernels.h"

#include "mpm/vector/kernels.h"

namespace frana::finite_volume {

template <Instructions>
const RowKernels& compiled_row_kernels();

const RowKernels& row_kernels(bool plain) {
#if defined(__x86_64__)
#if defined(FRANA_AVX512)
    if (!plain && vector_node_kernels(Instructions::avx512) != nullptr)
        return compiled_row_kernels<Instructions::avx512>();
#endif
    if (!plain && vector_node_kernels(Instructions::avx2) != nullptr) return compiled_row_kernels<Instructions::avx2>();
#endif
    static_cast<void>(plain);
    return k_row_kernels;
}

void prepare_excess(const Cells& cells, std::size_t first, std::size_t count, const StepValues& values,
                    const ExcessLaw& law, BedState* states) {
    const SummedFriction<ExcessLaw> friction{law, states, true};
    for (std::size_t k = first; k < first + count; ++k) prepare_cells<double>(cells, k, 1, values, friction);
}

void finish_excess(const Cells& cells, std::size_t first, std::size_t count, const StepValues& values,
                   const ExcessLaw& law, BedState* states, StripTotals& totals) {
    const SummedFriction<ExcessLaw> friction{law, states, true};
    for (std::size_t k = first; k < first + count; ++k) finish_cells<double>(cells, k, 1, values, friction, totals);
}

}  // namespace frana::finite_volume
