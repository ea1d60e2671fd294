// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "models/structured/solid/artificial_viscosity.h"
#include "models/structured/solid/kernel.h"

namespace frana::structured {

/// Parameters of the solids' laws for the sums over neighbours. These are compiled for AVX2 as well, where Eigen would
/// align its types differently from the rest of the program: no header of the sums includes Eigen.
struct PairLaws {
    explicit PairLaws(double smoothing_length) : kernel(smoothing_length) {}

    CubicKernel kernel;
    double spacing = 1;  ///< of particles at the start, dp [m]
    ArtificialViscosity viscosity;
};

}  // namespace frana::structured
