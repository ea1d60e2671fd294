// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/pictures/charts.h"
#include "app/pictures/map_source.h"
#include "app/store/result_directory.h"
#include "app/study/publish/publish_calibration.h"
#include "params/keys/scene_spec.h"

namespace frana::app::study {

/// Writes posterior_EVENT.tif for each event: the probability under the posterior that the maximum depth exceeds the
/// threshold of the survey, with its margin as second band. The map of it shows the surveyed outline and the
/// trace of the best member. A map that could not be drawn is a warning. Throws Error(environment).
void publish_calibration_maps(const CalibrationInput& input, const CalibrationRuns& runs,
                              const CalibrationResult& result, const Troubles& troubles,
                              const ResultDirectory& directory, RunLog& log);

/// Returns the title of a calibration's charts and report.
std::string calibration_title(const CalibrationInput& input);

/// Writes report.html from the tables and the charts already in the directory. Throws Error(environment).
void write_calibration_report(const CalibrationInput& input, const CalibrationRuns& runs,
                              const CalibrationResult& result, const CalibrationFacts& facts,
                              const ResultDirectory& directory);

/// Draws the chart of a calibration, if the scene asks for any: the distribution of each key before and after. One that
/// could not be drawn is a warning.
void draw_calibration_charts(const CalibrationInput& input, const CalibrationResult& result,
                             const ResultDirectory& directory, RunLog& log);

}  // namespace frana::app::study
