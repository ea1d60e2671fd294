// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/pictures/result_numbers.h"
#include "app/publish/accuracy_record.h"
#include "app/publish/publish_exposure.h"
#include "app/publish/publish_hazard.h"
#include "core/json.h"
#include "core/words/sentence.h"
#include "params/keys/scene_spec.h"
#include "simulation/result.h"
#include "simulation/run_summary.h"

namespace frana::app {

/// Wall time of the parts of a run [s].
struct WallSeconds {
    double total = 0, input = 0, engine = 0, output = 0, render = 0;
};

/// Content of summary.json besides the engine's own result.
struct SummaryFacts {
    SceneSpec spec;
    GridSpec computed;  ///< the scene's; rasters may cover a part of it
    std::string crs_label;
    std::string date;  ///< the day of the run, "2026-11-24"
    int threads = 1;
    WallSeconds wall;
    std::int64_t peak_memory_bytes = 0;
    MainStatistics statistics;
    PeakStatistics high;                                          ///< over that trace
    std::optional<GroundStatistics> release_ground, path_ground;  ///< of the DTM under the release and the trace
    std::vector<HazardArea> hazard;                               ///< empty: no scheme
    std::optional<ExposureTotals> exposure;                       ///< none: no exposed features
    std::vector<Sentence> warnings;
    std::optional<AccuracyRecord> accuracy;  ///< none: not asked for, or the run did not come to its end
    std::vector<std::string> data_identity;  ///< by which --resume compares the scene's data
};

/// Returns the sums over exposed features for it.
Json exposure_json(const ExposureTotals& totals);

/// Returns summary.json.
std::string summary_json(const RunResult& result, const SummaryFacts& facts);

/// Returns the peak resident memory of this process so far.
std::int64_t peak_memory_bytes();

}  // namespace frana::app
