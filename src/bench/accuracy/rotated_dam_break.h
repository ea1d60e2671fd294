// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bench/accuracy/accuracy_case.h"

namespace frana::bench {

/// Ritter's dam break (dam_break.h) with the dam at 30 degrees to the grid, 10 m over dry ground, t = 20 s.
///
/// Walls at 30 degrees are not possible, so the water is a rectangle so large (720 m behind the dam, 490 m along it)
/// that disturbances of its free sides, spreading at sqrt(g h) = 9.9 m/s, do not reach the strip that is compared: 50 m
/// wide about the middle, 500 m to either side of the dam, the same length as ritter's channel. The rectangle is filled
/// like a release perimeter, with the particles' areas clipped by its outline.
AccuracyCase rotated_dam_break();

}  // namespace frana::bench
