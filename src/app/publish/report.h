// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/compare/comparison.h"
#include "app/publish/publish.h"
#include "app/publish/publish_hazard.h"
#include "app/publish/report_errors.h"
#include "app/publish/summary.h"
#include "core/words/words.h"

namespace frana::app {

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
