// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "app/calibrate/calibration_result.h"
#include "app/calibrate/publish_calibration.h"
#include "app/pictures/map_source.h"
#include "app/store/result_directory.h"
#include "params/keys/scene_spec.h"

namespace frana::app {

/// Writes posterior_EVENT.tif for each event: the probability under the posterior that the maximum depth exceeds the
/// threshold of the survey, with its standard error as second band. The map of it shows the surveyed outline and the
/// trace of the best member. Returns false if a map could not be drawn, with a warning. Throws Error(environment).
bool publish_calibration_maps(const CalibrationInput& input, const CalibrationRuns& runs,
                              const CalibrationResult& result, const Troubles& troubles,
                              const ResultDirectory& directory, RunLog& log);

/// Returns the title of a calibration's charts and report.
std::string calibration_title(const CalibrationInput& input);

/// Returns how a calibration's maps and charts look: as the scene's keys ask.
MapStyle calibration_style(const SceneSpec& scene);

/// Writes report.html from the tables and the charts already in the directory. Throws Error(environment).
void write_calibration_report(const CalibrationInput& input, const CalibrationRuns& runs,
                              const CalibrationResult& result, const CalibrationFacts& facts,
                              const ResultDirectory& directory);

}  // namespace frana::app
