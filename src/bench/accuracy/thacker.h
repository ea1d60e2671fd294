// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bench/accuracy/accuracy_case.h"

namespace frana::bench {

/// Water oscillating in a paraboloid Z = D (r^2 / a^2 - 1), D = 10 m, a = 100 m, no friction, after three periods.
/// Thacker, J. Fluid Mech. 107, 499-508 (1981).
///   thacker         the surface remains a plane and the disc circles: w = sqrt(2 g D) / a, s = 20 m,
///                   h = D (1 - |x - c|^2 / a^2), c = s (cos wt, sin wt), v = s w (-sin wt, cos wt)
///   thacker-radial  the surface remains a paraboloid: w = sqrt(8 g D) / a, A = 0.5, b = 1 - A cos wt,
///                   h = D (sqrt(1 - A^2) / b - (1 - A^2) r^2 / (a^2 b^2)), v = w r A sin wt / (2 b)
/// These are solutions of the equations without a slope correction, which is therefore off.
/// Own values: the shoreline's error in cells (the farthest particle of 32 sectors against the exact circle;
/// mark 1), the loss of the energy above that at rest, as a fraction (mark 5 %).
std::vector<AccuracyCase> thackers();

}  // namespace frana::bench
