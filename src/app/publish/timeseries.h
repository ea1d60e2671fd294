// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "simulation/result.h"

namespace frana::app {

/// Returns timeseries.csv: a header with units, one row per step, numbers that read back as the same bits.
std::string timeseries_csv(const std::vector<SeriesRow>& series);

}  // namespace frana::app
