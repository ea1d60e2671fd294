// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/input/prepare.h"
#include "study/read_study.h"
#include "study/sampling.h"

namespace frana::app {

/// A study with everything checked that can be checked before its members run.
struct StudyInput {
    study::StudyReading reading;
    study::SampleTable table;
    Prepared base;                            ///< the central member: medians, likeliest choices
    SceneReading central;                     ///< from which it was prepared
    std::vector<ReleaseArea> other_releases;  ///< of members with other files, for maps
    /// One fact per line: the study, every member's values, the scenes and their data. Two studies with the same
    /// identity give the same bits.
    std::string identity;

    /// Returns the scene of a member, as `frana run` with its values reads it.
    [[nodiscard]] SceneReading member(std::size_t index) const;
};

/// A study whose files have been read as text: where its result goes is known, and all problems so far.
struct StudyTexts {
    study::StudyReading reading;
    study::SampleTable table;
    SceneReading central;  ///< its problems contain those of the study and of all members
};

/// Reads study, table and scene, draws the members, and reads the scene of each. Throws Error(input) only if a file is
/// no INI, or the study names no scene.
StudyTexts read_study_texts(const std::string& path);

/// Prepares the central member, and a member for each value of keys without order, such as files. Throws Error(input)
/// with every problem found, and with that of the result's place as prepare().
StudyInput prepare_study(StudyTexts texts, const std::optional<Problem>& place, RunLog& log);

}  // namespace frana::app
