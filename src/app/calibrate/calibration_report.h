// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "app/calibrate/calibration_result.h"
#include "app/calibrate/calibration_tables.h"
#include "app/store/result_directory.h"

namespace frana::app {

/// Returns the title of a calibration's charts and report.
std::string calibration_title(const CalibrationInput& input);

/// Writes report.html from the tables and the charts already in the directory. Throws Error(environment).
void write_calibration_report(const CalibrationInput& input, const CalibrationRuns& runs,
                              const CalibrationResult& result, const CalibrationFacts& facts,
                              const ResultDirectory& directory);

}  // namespace frana::app
