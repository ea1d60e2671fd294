// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/study/plan/study_input.h"
#include "app/study/pool/study_result.h"
#include "core/json.h"
#include "core/words/sentence.h"
#include "simulation/run_summary.h"

namespace frana::app::study {

/// Figures in which the runs of two schemes are compared.
inline constexpr const char* k_checked_figures[] = {k_run_out_key, "covered_area_m2", "max_depth_m"};

/// A study's members by the other scheme: how much of a result is the scheme's.
struct SchemeCheck {
    struct Member {
        std::size_t member = 0;
        bool is_farthest = false;  ///< else its run-out is nearest to the median
        double own[std::size(k_checked_figures)] = {}, other[std::size(k_checked_figures)] = {};
        std::string failure;  ///< of the second run; empty: it finished

        /// Difference of a figure of the second run, relative to that of the first.
        [[nodiscard]] double difference(std::size_t figure) const { return other[figure] / own[figure] - 1; }
    };
    std::string scheme, other;  ///< of the members, of the second runs
    std::string refusal;        ///< why there are none; empty: there are
    std::vector<Member> members;
};

/// The scheme of all members; none: it varies, or the model has one only.
std::optional<Scheme> common_scheme(const StudyInput& input);

/// Runs the members nearest to the weighted median of the run-out and farthest again by the other scheme: finite
/// volumes, or the default one of members by these. Each runs on one thread; the members alone decide its bits. None
/// without a common_scheme. Throws Error(environment).
/// @param weights of the members; one without is no candidate
std::optional<SchemeCheck> check_scheme(const StudyInput& input, const std::vector<MemberRecord>& members,
                                        const std::vector<double>& weights, int threads);

/// Returns what the check says, a name and its value for each run; the first is the members' scheme.
std::vector<std::pair<Sentence, Sentence>> rows_of(const SchemeCheck& check);
/// The warning where members by finite volumes reach elsewhere than by particles; none for members by particles.
std::optional<Sentence> warning_of(const SchemeCheck& check, bool is_region);
Json check_json(const SchemeCheck& check);
/// The name of the common scheme; null without one.
Json scheme_json(const StudyInput& input);

}  // namespace frana::app::study
