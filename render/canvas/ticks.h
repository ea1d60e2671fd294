// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace frana::render {

/// Returns the smallest of 1, 2, 5 times a power of ten that is at least `least` (positive).
double nice_step_above(double least);
/// Returns the greatest of 1, 2, 5 times a power of ten that is at most `most` (positive).
double nice_step_below(double most);

/// Returns all multiples of `step` in [from, to], rising.
std::vector<double> multiples(double from, double to, double step);

/// Returns a number in as few digits as distinguish it from its neighbours: "0.5", "20", "1250".
std::string number(double value);
/// Returns a whole number in groups of three digits: "5 094 000".
std::string grouped(double value);

}  // namespace frana::render
