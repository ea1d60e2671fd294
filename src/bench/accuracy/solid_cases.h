// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bench/accuracy/accuracy_case.h"

namespace frana::bench {

/// The structured model's solids against exact solutions. `l1_depth` contains each case's own error, relative:
///   p-wave           velocity of a pulse in a wide sheet against d'Alembert's, sqrt((K + 4 G / 3) / rho)
///   rigid-rotation   greatest strain rate over the angular velocity, of a rigidly rotating sheet; stress after
///                    a turn
///   incline-block    speed of a dry block after 2 s on 35 degrees; displacement of one on 27.9, with phi = 28
///   drag-relaxation  relative velocity of solids and fluid in a still cell, linear and quadratic drag
std::vector<AccuracyCase> solid_cases();

}  // namespace frana::bench
