// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "bench/accuracy/accuracy.h"

namespace frana::bench {

/// accuracy.csv: one line a row; "nan" where there is no observed order.
std::string accuracy_csv(const std::vector<AccuracyRow>& rows);

/// The table for people: errors, orders, each case's own values with their marks, and other programs'
/// values beside them; says where a mark is missed or another program has less error.
std::string accuracy_table(const std::vector<AccuracyRow>& rows);

/// Which scheme has the least error for a given time, case by case, in words.
std::string accuracy_verdict(const std::vector<AccuracyRow>& rows);

/// Error reached in a given time, between measured (time, error) pairs on straight lines in logarithms; NaN
/// outside them.
double error_in_time(const std::vector<std::pair<double, double>>& time_and_error, double seconds);

}  // namespace frana::bench
