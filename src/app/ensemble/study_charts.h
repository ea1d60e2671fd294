// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "app/ensemble/study_result.h"
#include "app/pictures/charts.h"

namespace frana::app {

/// One point of the convergence of the probabilities.
struct ErrorAt {
    std::size_t members = 0;
    study::MapError error;
};

/// Returns the standard errors of the probabilities of depth after some numbers of members, up to all of them; of
/// Saltelli's design those of matrix A, which are independent.
std::vector<ErrorAt> convergence_of(const StudyInput& input, const StudyResult& result);

/// Returns the title of a figure of a study in a language: "run-out".
std::string figure_title(const study::Figure& figure, const Words& words);

/// Returns the charts of a study: exceedance of the figures, sensitivities, convergence.
std::vector<NamedChart> study_charts(const StudyInput& input, const StudyResult& result,
                                     const std::vector<FigureSensitivity>& sensitivities,
                                     const std::vector<ErrorAt>& convergence, const MapSource& source);

}  // namespace frana::app
