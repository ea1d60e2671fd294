// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bench/accuracy/accuracy_case.h"

namespace frana::bench {

/// Dam break of a dry granular layer, 1 m thick (normal to the slope), on a rough incline of 22 degrees with
/// a bed friction angle of 21 degrees, t = 5 s. Faccanoni and Mangeney, Int. J. Numer. Anal. Meth. Geomech.
/// 37, 1408-1433 (2013): with c = sqrt(g h0 cos theta) and m = g cos theta (tan theta - tan delta), along the
/// slope
///     undisturbed for x <= m t^2 / 2 - c t:           h = h0,   u = m t
///     up to x = m t^2 / 2 + 2 c t:                    h = (2 c - x / t + m t / 2)^2 / (9 g cos theta),
///                                                     u = 2/3 (x / t + c + m t)
/// Errors are computed over -200 m <= x <= 220 m.
///   granular-slope      gravity tilted over a flat bed
///   granular-slope-map  a sloping bed in map view, with the slope correction (default scheme)
/// Own values: relative L2 errors of depth and momentum; the undisturbed block's speed over m t = 0.9169 m/s
/// less one (mark 0.2 %); and the L2 errors over the lattice's with particles placed at random (mark 1.1).
std::vector<AccuracyCase> granular_slopes();

}  // namespace frana::bench
