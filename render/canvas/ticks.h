// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace frana::render {

/// The smallest of 1, 2, 5 times a power of ten that is at least `least` (positive).
double nice_step_above(double least);
/// The greatest of 1, 2, 5 times a power of ten that is at most `most` (positive).
double nice_step_below(double most);

/// All multiples of `step` in [from, to], rising.
std::vector<double> multiples(double from, double to, double step);

/// A number as short as it can be told from its neighbours: "0.5", "20", "1250".
std::string number(double value);
/// A whole number in groups of three digits: "5 094 000".
std::string grouped(double value);

}  // namespace frana::render
