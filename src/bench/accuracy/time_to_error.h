// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "bench/accuracy/accuracy.h"

namespace frana::bench {

/// Time after which a curve of {seconds, error}, ascending in time, is under an error for good: between two
/// resolutions by powers of time, beyond the finest NaN; at the coarsest already: its time.
double time_to_error(const std::vector<std::pair<double, double>>& time_and_error, double error);

/// For each case with an exact solution, what the default scheme takes on one thread to an error of 1 % and of 0.3 %
/// (the greater of l1_depth and l1_momentum), and the finest resolution's own.
std::string time_to_error_table(const std::vector<AccuracyRow>& rows);

}  // namespace frana::bench
