// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "app/study/calibration_spec.h"
#include "app/study/plan/read_study.h"
#include "core/error.h"

namespace frana::app::study {

/// A calibration as far as its file could be read, and all its problems.
struct CalibrationReading {
    CalibrationSpec calibration;
    Problems problems;
    std::string label;  ///< the file as the user named it

    /// Returns where a key is given, for messages: "study.ini: objective.jaccard".
    [[nodiscard]] std::string where(const std::string& name) const { return label + ": " + name; }
};

/// Whether a study is a calibration: it has a section [objective] or [event NAME]. Throws Error(input) as read_ini.
bool is_calibration(const std::string& path);

/// Reads a calibration's file; every problem is collected, those of [set] and [vary] as read_study() finds them. Throws
/// Error(input) only if the file is no INI.
CalibrationReading read_calibration(const std::string& path);

/// Returns a calibration with every path in it mapped, as of a study, and one whose paths are relative to a folder.
CalibrationSpec with_files(CalibrationSpec calibration, const KeyedFileMap& map);
CalibrationSpec seen_from(CalibrationSpec calibration, const std::string& folder);

/// Returns the file with every key, its meaning and the distributions as used; reading it back gives the same.
std::string calibration_text(const CalibrationSpec& calibration);

}  // namespace frana::app::study
