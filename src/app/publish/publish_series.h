// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "analysis/runout.h"
#include "app/input/prepare.h"
#include "app/store/frame_store.h"
#include "app/store/result_directory.h"
#include "simulation/result.h"

namespace frana::app {

/// Returns timeseries.csv: a header with units, one row per step, numbers that read back as the same bits.
std::string timeseries_csv(const std::vector<SeriesRow>& series);

/// Writes gauges.csv and sections.csv if a scene has them, with gauges.gpkg for their places. Throws
/// Error(environment).
void publish_series(const Prepared& prepared, const RunResult& result, const ResultDirectory& directory);

/// Writes profiles.csv and profiles.gpkg: the results along the flow path, from the top of the release to the tip of
/// the trace, and along the user's lines. Throws Error(environment).
void publish_profiles(const Prepared& prepared, const RunResult& result, const Runout& run_out,
                      const ResultDirectory& directory);

}  // namespace frana::app
