// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "bench/accuracy/accuracy.h"

namespace frana::bench {

/// Returns the time after which a curve of {seconds, error}, ascending in time, remains below an error: between two
/// resolutions by powers of time, beyond the finest NaN; if the coarsest already is, its time.
double time_to_error(const std::vector<std::pair<double, double>>& time_and_error, double error);

/// Returns, for each case with an exact solution, the default scheme's time on one thread to an error of 1 % and of 0.3
/// % (the greater of l1_depth and l1_momentum), and that of the finest resolution.
std::string time_to_error_table(const std::vector<AccuracyRow>& rows);

}  // namespace frana::bench
