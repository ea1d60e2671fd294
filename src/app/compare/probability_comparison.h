// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "analysis/scores.h"
#include "app/input/survey_input.h"
#include "app/pictures/map_source.h"
#include "app/text/run_log.h"
#include "render/chart/chart.h"

namespace frana::app {

/// A map of probability that is compared with an observed outline.
struct ProbabilityMap {
    std::string file;
    std::string name;  ///< "probability_depth_0.5"
    Raster values;
    MapSource source;  ///< title and style of its pictures
};

/// Returns whether an operand of `frana compare` is the result of a study or one of its maps of probability.
bool is_probability(const std::string& operand);

/// Reads the map; of a study's result that of a depth threshold [m], by default the scene's for surveys, or the least
/// that is mapped. Throws Error(input).
ProbabilityMap read_probability_map(const std::string& operand, const std::optional<double>& threshold);

/// Scores the map against the surveyed areas; those outside its grid count as not foreseen. Throws Error(input).
ProbabilityScores compare_with_survey(const ProbabilityMap& map, const Survey& survey, RunLog& log);

/// Returns the chart of reliability and ROC curve.
render::Chart probability_chart(const ProbabilityScores& scores, const ProbabilityMap& map);

std::string probability_json(const ProbabilityScores& scores, const ProbabilityMap& map, const Survey& survey);

/// Writes comparison.json, roc.csv, reliability.csv and the picture of both to a folder.
/// Throws Error.
void write_probability_comparison(const ProbabilityScores& scores, const ProbabilityMap& map, const Survey& survey,
                                  const std::string& folder);

}  // namespace frana::app
