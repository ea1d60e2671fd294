// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/text/run_log.h"
#include "study/read_calibration.h"
#include "study/read_study.h"

namespace frana::app {

/// For the study file of a result, which may have been moved: compares the files that it names (scenes, table, files in
/// [set] and [vary]) with inputs.json beside it, as find_recorded_inputs() those of a scene.
void find_recorded_inputs(study::StudyReading& reading, RunLog& log);
void find_recorded_inputs(study::CalibrationReading& reading, RunLog& log);

}  // namespace frana::app
