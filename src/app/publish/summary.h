// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "analysis/runout.h"
#include "app/publish/high_figures.h"
#include "app/publish/publish_hazard.h"
#include "params/keys/scene_spec.h"
#include "simulation/result.h"

namespace frana::app {

/// Wall time of the parts of a run [s].
struct WallSeconds {
    double total = 0, input = 0, engine = 0, output = 0, render = 0;
};

/// What summary.json says beyond the engine's own result.
struct SummaryFacts {
    SceneSpec spec;
    std::string crs_label;
    int threads = 1;
    WallSeconds wall;
    std::int64_t peak_memory_bytes = 0;
    Runout run_out;
    double covered_area_m2 = 0;      ///< of the trace: greatest depth over output.trace-threshold
    HighFigures high;                ///< over that trace
    std::vector<HazardArea> hazard;  ///< empty: no scheme
    std::vector<std::string> warnings;
    std::vector<std::string> data_identity;  ///< what --resume knows the scene's data by
};

/// summary.json.
std::string summary_json(const RunResult& result, const SummaryFacts& facts);

/// One word for scripts: "end-time", "still", "all-left", "requested", "reached-no-data", "non-finite".
std::string stop_word(StopReason reason);

/// Peak resident memory of this process so far.
std::int64_t peak_memory_bytes();

}  // namespace frana::app
