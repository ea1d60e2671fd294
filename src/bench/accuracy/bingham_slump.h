// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bench/accuracy/accuracy_case.h"

namespace frana::bench {

/// Final profile of a slump held by a yield stress: a block 5 m deep and 20 m long against a wall, on level ground with
/// the yield stress T at its base, comes to rest where the pressure's slope equals it,
///     rho g h dh/dx = -T   =>   h = sqrt(2 T (x_f - x) / (rho g)),   2/3 sqrt(2 T / (rho g)) x_f^(3/2) = 100
///     m2
/// (Liu and Mei, J. Fluid Mech. 207, 505-529, 1989; the depth-averaged limit of a slow slump of Bingham
/// (Liu and Mei, J. Fluid Mech. 207, 505-529, 1989; the depth-averaged limit of a slow slump of Bingham fluid). T is
/// chosen for x_f = 40 m; the whole block yields, since h(0) = 3.75 m. The model has a yield stress at the bed as p_A
/// tan(phi), with tan(phi) = 1e-6 so that the weight contributes nothing. The profile is that of a slow slump: a
/// turbulence of xi = 0.2 m/s2 keeps the Froude number below 0.1, and the run lasts 600 s. The in-plane yield stress is
/// omitted, as in the exact profile. Own value: relative error of the run-out x_f, mark 3 %.
AccuracyCase bingham_slump();

}  // namespace frana::bench
