// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "bench/accuracy/accuracy.h"

namespace frana::bench {

/// Returns accuracy.csv: one line per row; "nan" if there is no observed order.
std::string accuracy_csv(const std::vector<AccuracyRow>& rows);

/// Returns the table for the terminal: errors, orders, each case's own values with their marks, and other programs'
/// values beside them; marks values that do not pass and errors larger than those of another program.
std::string accuracy_table(const std::vector<AccuracyRow>& rows);

/// Returns as text which scheme has the least error for a given time, case by case.
std::string accuracy_verdict(const std::vector<AccuracyRow>& rows);

/// Returns the error reached in a given time, interpolated linearly in logarithms between measured (time, error) pairs;
/// NaN outside them.
double error_in_time(const std::vector<std::pair<double, double>>& time_and_error, double seconds);

}  // namespace frana::bench
