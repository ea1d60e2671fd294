// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/ensemble/level_rounds.h"
#include "app/ensemble/median_member.h"
#include "app/ensemble/study_result.h"
#include "app/publish/publish_exposure.h"
#include "app/publish/publish_hazard.h"

namespace frana::app {

/// Returns members.csv: a row for each member, with its values as after `--set` and its figures.
std::string members_csv(const StudyInput& input, const StudyResult& result);
/// Returns sensitivity.csv: a row for each figure and key.
std::string sensitivity_csv(const StudyInput& input, const std::vector<FigureSensitivity>& figures);

/// What a study's summary.json contains besides its members.
struct StudyFacts {
    Troubles troubles;
    study::MapError error;  ///< of all maps of probability
    std::optional<MedianMember> median;
    std::vector<LevelSummary> levels;  ///< of a multilevel study
    std::optional<ExposureTotals> exposure;
    std::string date;  ///< the day it was written, "2026-11-24"
    /// Areas deeper than the threshold at some time [m2]: with the probability of each of k_study_quantiles at least;
    /// of sources that fail alone one value, that of all of them. Empty: there is no such map.
    std::vector<double> reached_m2;
    double reached_threshold = 0;     ///< [m]
    std::vector<HazardArea> degrees;  ///< of hazard, of a region with return periods
    double wall_seconds = 0;
    std::size_t computed = 0;  ///< members in this session
    int threads = 1;
    std::vector<Sentence> warnings;
};
std::string study_summary_json(const StudyInput& input, const StudyResult& result, const StudyFacts& facts);

}  // namespace frana::app
