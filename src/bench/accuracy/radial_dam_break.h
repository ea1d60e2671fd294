// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bench/accuracy/accuracy_case.h"

namespace frana::bench {

/// A cylinder of water 10 m high and 60 m in radius collapses, t = 6 s, no friction, against a converged
/// radial solution (radial_reference.h).
///   radial-wet  into 2 m of water
///   radial-dry  on dry ground
/// Own values: how much farther the front is along the grid's axes than along its diagonals, over the
/// reference's reach (outermost depth of 2.5 m in the wet case, 0.1 m in the dry one); mark 2 %.
std::vector<AccuracyCase> radial_dam_breaks();

}  // namespace frana::bench
