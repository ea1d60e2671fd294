// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bench/accuracy/accuracy_case.h"

namespace frana::bench {

/// A parabolic cap, 4 m thick and 80 m in radius (both in the slope's coordinates), on a plane of 35 degrees
/// with a bed friction angle of 25 degrees, t = 5 s, against the similarity solution (similarity_solution.h).
///   similarity      gravity tilted over a flat bed
///   similarity-map  a sloping bed in map view, with the slope correction (default scheme)
/// Own values: relative L2 errors of depth and momentum, as com1DFA's are published.
std::vector<AccuracyCase> similarities();

}  // namespace frana::bench
