// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/compare/comparison.h"
#include "app/publish/document.h"
#include "app/publish/publish.h"
#include "app/publish/publish_exposure.h"
#include "app/publish/publish_hazard.h"
#include "app/publish/summary.h"
#include "core/words/words.h"
#include "render/chart/chart.h"

namespace frana::app {

/// A map of a report.
struct ReportMap {
    std::string name;  ///< "max_depth_3d"
    std::string file;
    std::string caption, alt;
};

/// Estimated errors of a run's values due to the size of the cells.
struct ErrorEstimates {
    struct Estimate {
        double error = 0;  ///< in the unit of the value
        bool converging = false;
    };
    std::map<std::string, Estimate> of;  ///< by the value's key in summary.json, or as RunValue::key
    bool from_study = false;             ///< of `frana converge`; else of numerics.accuracy

    /// Returns none without an estimate.
    [[nodiscard]] std::optional<Estimate> find(const std::string& key) const;
};

/// Returns those of numerics.accuracy, else those that `frana converge` left beside the result for exactly this scene.
/// @param result the folder that the result will have
ErrorEstimates error_estimates(const SummaryFacts& facts, const std::string& result);

/// The paragraph on exposure of a report's answer; empty without exposed features.
Document exposure_answer(const std::optional<ExposureTotals>& totals, ReachedBy by, const Words& words);

/// The section of the features that are reached, the deepest first, with its heading; empty if none is.
Document exposure_section(const std::optional<ExposureTotals>& totals, const Words& words);

/// Data of a report, besides the pictures already in the result directory.
struct ReportInput {
    const Prepared& prepared;
    const RunResult& result;
    const SummaryFacts& facts;
    const std::optional<Comparison>& comparison;
    const std::vector<HazardArea>& hazard;
    ErrorEstimates errors;
    Words words;
};

/// Writes report.html: one self-contained file, for the screen and for paper. On its first page are the scenario and
/// the answer; then the maps of `maps/` and comparison.png, values in detail, inputs, and the keys that were used.
/// Throws Error(environment).
void write_report(const ReportInput& input, const ResultDirectory& directory);

}  // namespace frana::app
