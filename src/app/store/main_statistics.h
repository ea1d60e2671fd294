// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "simulation/main_statistics.h"

namespace frana::app {

/// Returns the places from which the flows of a result come: by them flows that only flowed in are recognised.
std::vector<Point> flow_tops(const std::optional<MainStatistics>& statistics);

/// Returns none if the result has no summary.json yet, or not these values. Throws Error(input) if the file is damaged.
std::optional<MainStatistics> read_main_statistics(const std::string& result_folder);

}  // namespace frana::app
