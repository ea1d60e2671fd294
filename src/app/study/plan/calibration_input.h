// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/study/plan/read_calibration.h"
#include "app/study/plan/study_input.h"

namespace frana::app::study {

/// A calibration whose files have been read as text.
struct CalibrationTexts {
    CalibrationReading reading;
    Places design;                   ///< of the first members, in all keys
    std::vector<StudyTexts> events;  ///< with the first members; their problems contain those of the scenes
    SceneReading first_scene;        ///< of the first event: the result's place is beside its
    Problems problems;               ///< of everything read so far
};

/// Reads the calibration, draws its first members, and reads their scenes. The study file of a result, which may have
/// been moved, finds its inputs as find_recorded_inputs(). Throws Error(input) only if a file is no INI, no event has a
/// scene, or an input of such a result is missing.
CalibrationTexts read_calibration_texts(const std::string& path, const Session& session, RunLog& log);

/// A calibration with everything checked that can be checked before its members run.
struct CalibrationInput {
    CalibrationReading reading;
    Places design;
    std::vector<StudyInput> coarse;  ///< by event: the first members, on coarse cells
    std::vector<StudyInput> own;     ///< by event: the same members on the scene's own cells
    /// One fact per line, as of a StudyInput.
    std::string identity;

    [[nodiscard]] const CalibrationSpec& spec() const noexcept { return reading.calibration; }
    [[nodiscard]] std::size_t events() const noexcept { return own.size(); }
};

/// Prepares the scenes of all events on both sizes of cells, and checks that each has what is compared with it. Throws
/// Error(input) with every problem found, and with that of the result's place as prepare().
CalibrationInput prepare_calibration(CalibrationTexts texts, const std::optional<Problem>& place, RunLog& log);

/// Returns the members of one event at places in all keys; problems of their values are those of the members.
SampleTable members_at(const CalibrationSpec& calibration, std::size_t event, const Places& places, Problems& problems);

}  // namespace frana::app::study
