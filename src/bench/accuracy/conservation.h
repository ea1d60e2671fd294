// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bench/accuracy/accuracy_case.h"

namespace frana::bench {

/// Equation (45) of Fois, de Falco, Formaggia 2024: a mudflow divides around an obstacle and merges again,
///     Z = 60 - x/3 + 15 exp(-((x - 50)^2 + (y - 10)^2) / 7) on [0, 150] x [0, 20] m, h = 60 - Z where x < 20
///     m,
/// 1200 kg/m3, 10 Pa s, friction 12 degrees, xi 200 m/s2, closed walls, 7 s. There is no exact flow; exact are the
/// equality of volume and momentum of nodes and particles, and the symmetry of both halves. So here
///     l1_depth    greatest relative difference of the nodes' volume from the start's, at any step
///     l1_momentum greatest difference of the nodes' momentum along the channel from the particles', over the
///     sum of the
///                 particles' |v| V, at any step before the flow meets the end wall (4 s). Across the channel
///                 the side walls' mirror images absorb momentum as soon as the halves differ, so there
///                 it is not conserved.
///     l2_depth, linf_depth  relative L2 and greatest difference [m] between the halves at 3 s, when the
///                 flow is around the obstacle
/// Marks: 1e-12 for volume and momentum, 1e-9 m for symmetry.
AccuracyCase conservation();

}  // namespace frana::bench
