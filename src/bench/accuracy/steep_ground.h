// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "bench/accuracy/accuracy_case.h"

namespace frana::bench {

/// A film without friction, too thin for its own pressure to matter, moves over steep ground as a point mass on the
/// surface does: |speed along the bed|^2 / 2 + g Z is constant (a constraint that does no work; Goldstein, Classical
/// Mechanics). All of a film has the same energy, so that no particle overtakes another. Each case is run along the
/// grid and, if it has a direction, at 30 degrees to it.
///
///   valley      down one side of a V and up the other; own values: height climbed over height fallen (200 m),
///               minus 1, for five pairs of slopes; measured half-way up, before the foremost turn and meet
///               those behind
///   valley-surge  the same from rest on half of a face: climb less that of the exact flow, for four pairs
///   profile     down and up a smooth profile; greatest change of the energy over the greatest fall
///   bowl        around a paraboloid; the same for energy and for angular momentum about its axis
///   slope-step  from 40 to 10 degrees; the same for energy
///   gully-bend  down a half-pipe that turns by 90 degrees; the same
///   ridge       against a ridge: height of rest from which half of it passes over the ridge's, minus 1
///
/// l1_depth of these cases is the largest of their own values, l1_momentum the mean.
std::vector<AccuracyCase> steep_ground();

}  // namespace frana::bench
