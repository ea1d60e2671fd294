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

namespace frana::app::study {

/// Figure by which the median member is chosen.
inline constexpr const char* k_median_figure = "covered_area_m2";

/// The member in the middle of a study.
struct MedianMember {
    std::size_t member = 0;
    Figure figure;      ///< its own value of k_median_figure
    double median = 0;  ///< weighted, of all members
};

/// Returns the member whose figure is nearest to the weighted median of all, of several the
/// first. None if no member finished.
std::optional<MedianMember> median_member(const StudyResult& result);

/// Runs a member again, with frames, and writes animation.mp4 if the scene asks for one; the terrain and the outlines
/// of the study must have been written. The frames are removed. There is a warning if the animation could not
/// be made.
void film_member(const StudyInput& input, const StudyResult& result, const MedianMember& median,
                 const ResultDirectory& directory, RunLog& log);

/// Returns members.csv: a row for each member, with its values as after `--set` and its figures.
std::string members_csv(const StudyInput& input, const StudyResult& result);
/// Returns sensitivity.csv: a row for each figure and key.
std::string sensitivity_csv(const StudyInput& input, const std::vector<FigureSensitivity>& figures);

/// What a study's summary.json contains besides its members.
struct StudyFacts {
    Troubles troubles;
    ErrorSummary error;       ///< of all maps of probability
    double least_margin = 1;  ///< Estimate::margin of a probability of 0 or 1
    std::optional<MedianMember> median;
    std::optional<RarePlace> rare_place;
    std::optional<ExposureTotals> exposure;
    std::optional<SchemeCheck> scheme_check;
    std::vector<FrictionArea> friction_areas;  ///< of the ground that at least one run reached
    std::string date;                          ///< the day it was written, "2026-11-24"
    /// Areas deeper than the threshold at some time [m2]: with the probability of each of k_study_quantiles at least;
    /// of sources that fail alone one value, that of all of them. Empty: there is no such map.
    std::vector<double> reached_m2;
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
/// Returns summary.json.
std::string study_summary_json(const StudyInput& input, const StudyResult& result, const StudyFacts& facts);

}  // namespace frana::app::study
