// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "app/compare/comparison.h"
#include "app/compare/probability_comparison.h"
#include "app/pictures/map_source.h"
#include "app/publish/document.h"
#include "core/words/words.h"

namespace frana::app {

/// Puts the comparison of a map of probability with a survey into report.html of the study's result, as renew_page.
bool renew_report(const std::string& folder, const ProbabilityScores& scores, const ProbabilityMap& map);

// The parts of a report that `frana compare` replaces.
inline constexpr const char* k_comparison_answer = "comparison answer";
inline constexpr const char* k_comparison_section = "comparison";

/// The sentence of the first page; also if nothing was compared.
Document comparison_answer(const std::optional<Comparison>& comparison, const Words& words);
/// The section: the map (if that file exists), the scores, their curve; empty without a comparison.
/// @param picture comparison.png, or one drawn for the page
Document comparison_section(const std::optional<Comparison>& comparison, const std::string& picture,
                            const Words& words);

/// Puts a comparison into report.html of a result, as renew_page.
/// @param source that comparison.png was drawn from, if it was drawn
bool renew_report(const std::string& folder, const Comparison& comparison, const MapSource& source);

}  // namespace frana::app
