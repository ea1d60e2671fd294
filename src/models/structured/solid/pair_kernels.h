// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "models/structured/solid/pair_laws.h"
#include "models/structured/solid/pair_work.h"
#include "particles/cell_order.h"

namespace frana::structured {

/// The sums over neighbours, for one row of cells; see pair_sums.h. The same source is compiled for the plain
/// instruction set and for AVX2 with FMA; the results differ by rounding.
struct PairKernels {
    void (*velocity_gradients)(const CellOrder&, std::int64_t row, const CubicKernel&, PairWork&);
    /// Returns the greatest |phi| of the artificial viscosity [m/s].
    double (*accelerations)(const CellOrder&, std::int64_t row, const PairLaws&, PairWork&);
};

/// Returns the fastest kernels that the processor supports.
const PairKernels& pair_kernels();
const PairKernels& plain_pair_kernels();
/// Returns those compiled for AVX2 and FMA, whatever this processor supports; null on other architectures.
const PairKernels* compiled_pair_kernels();

}  // namespace frana::structured
