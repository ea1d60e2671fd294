// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "analysis/runout.h"
#include "app/input/prepare.h"
#include "app/store/result_directory.h"
#include "simulation/result.h"

namespace frana::app {

/// Returns gauges.csv: time_s,gauge,depth_m,speed_ms.
std::string gauges_csv(const std::vector<GaugeRow>& rows, const std::vector<Gauge>& gauges);
/// Returns sections.csv: time_s,section,discharge_m3s,volume_m3,wetted_width_m,max_depth_m,max_speed_ms.
std::string sections_csv(const std::vector<SectionRow>& rows, const std::vector<CrossSection>& sections);

/// Writes gauges.csv and sections.csv if a scene has them, with gauges.gpkg for their places. Throws
/// Error(environment).
void publish_series(const Prepared& prepared, const RunResult& result, const ResultDirectory& directory);

/// Writes profiles.csv and profiles.gpkg: the results along the flow path, from the top of the release to the tip of
/// the trace, and along the user's lines. Throws Error(environment).
void publish_profiles(const Prepared& prepared, const RunResult& result, const Runout& run_out,
                      const ResultDirectory& directory);

}  // namespace frana::app
