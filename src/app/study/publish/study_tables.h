// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/publish/publish_exposure.h"
#include "app/publish/publish_hazard.h"
#include "app/store/result_directory.h"
#include "app/study/plan/study_input.h"
#include "app/study/pool/study_result.h"
#include "app/study/publish/scheme_check.h"
#include "app/text/number_text.h"
#include "core/json.h"

namespace frana::app::study {

/// A column of the tables of members with a member's value.
struct MemberCell {
    std::string name, text;
    bool is_number = true;
};
/// What they say of a member: its values as after `--set`, its figures, how it ended; the same columns for all.
std::vector<MemberCell> member_row(const StudyInput& input, const StudyResult& result, const MemberRecord& member);
/// Returns members.csv, with a row for each member.
std::string members_csv(const StudyInput& input, const StudyResult& result);
/// Returns sensitivity.csv: a row for each figure and key.
std::string sensitivity_csv(const StudyInput& input, const std::vector<FigureSensitivity>& figures);

/// What the rates of a study are conditional on.
inline constexpr const char* k_condition_with_rate =
    worded("For this rate and these distributions; errors of the model excluded");

/// What the summary.json of a study of any kind contains besides its members.
struct StudyFacts {
    Troubles troubles;
    ErrorSummary error;       ///< of all maps of probability
    double least_margin = 1;  ///< Estimate::margin of a probability of 0 or 1
    std::optional<RarePlace> rare_place;
    std::optional<ExposureTotals> exposure;
    std::optional<SchemeCheck> scheme_check;
    std::vector<FrictionArea> friction_areas;  ///< of the ground that at least one run reached
    std::string date = today();                ///< the day it was written, "2026-11-24"
    /// Areas deeper than the threshold at some time [m2]: with the probability of each of k_study_quantiles at least;
    /// of sources that fail alone one value, that of all of them. Empty: there is no such map.
    std::vector<double> reached_m2;
    std::vector<Interval> once_m2;    ///< area deeper than the threshold once in each return period of the frequency
    Interval half_reached_m2;         ///< the area with 50 %, where the interval of its probability allows it
    double reached_threshold = 0;     ///< [m]
    std::vector<HazardArea> degrees;  ///< of hazard, of a region with return periods
    double wall_seconds = 0;
    std::size_t computed = 0;  ///< members in this session
    int threads = 1;
    Warnings warnings;
};
/// Whose friction a study shows, and by which of its keys that differs between the runs; of one with a friction table.
struct ShownFriction {
    std::string of;  ///< k_central_friction or k_largest_friction
    std::vector<std::string> varied;
};
ShownFriction shown_friction(const StudyInput& input);
/// What summary.json has of a study of any kind.
Json summary_head(const StudyInput& input, const StudyFacts& facts);
/// Returns summary.json.
std::string study_summary_json(const StudyInput& input, const StudyResult& result, const StudyFacts& facts);

}  // namespace frana::app::study
