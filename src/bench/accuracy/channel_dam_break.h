// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bench/accuracy/accuracy_case.h"

namespace frana::bench {

/// Frictionless dam breaks in a walled channel of 1000 m x 50 m with the dam at 500 m, at t = 20 s, against
/// Stoker's and Ritter's solutions (dam_break.h). Cells of 10 to 0.625 m are 100 to 1600 along the channel.
///   stoker       10 m over 2 m: rarefaction and shock
///   stoker-weak  10 m over 5 m
///   stoker-thin  10 m over 0.1 m: water a hundred times as deep as what it meets
///   ritter       10 m over dry ground
/// Own values: mean depth error in metres, as other codes publish it; for ritter the error of the position of the 0.01
/// m depth, in cells (mark 2), and that of the foremost particle.
std::vector<AccuracyCase> channel_dam_breaks();

}  // namespace frana::bench
