// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bench/accuracy/accuracy_case.h"

namespace frana::bench {

/// A wide slab 1 m deep (vertically) on a plane of 30 degrees with Voellmy friction, phi = 15 degrees and xi
/// = 300 m/s2, reaches its terminal speed: along the slope, with thickness d = h cos theta,
///     dv/dt = a (1 - v^2 / w^2),  a = g (sin theta - cos theta tan phi),  w^2 = a xi d / g,
///     v = w tanh(a t / w),  distance = w^2 / a ln cosh(a t / w).
/// The comparison uses the nodes within 20 m of the exact middle after 20 s, when v / w > 1 - 1e-5. Own value: relative
/// error of the middle's speed, mark 1e-3.
AccuracyCase voellmy_plane();

}  // namespace frana::bench
