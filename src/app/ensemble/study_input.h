// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/ensemble/polygon_members.h"
#include "app/input/prepare.h"
#include "gis/access/remembered_reads.h"
#include "study/read_study.h"
#include "study/sampling.h"

namespace frana::app {

/// The cells of one level of a multilevel study.
struct LevelCells {
    double cell_size = 0;      ///< [m]
    double expected_cost = 0;  ///< of a run, relative to one on the scene's own cells
};

/// A study with everything checked that can be checked before its members run.
struct StudyInput {
    study::StudyReading reading;
    study::SampleTable table;
    /// Of a multilevel study: draws from which its levels take members; `table` holds those taken so far, first those
    /// of the pilot.
    std::vector<study::SampleTable> level_draws;
    Prepared base;                            ///< the central member: medians, likeliest choices
    SceneReading central;                     ///< from which it was prepared
    std::vector<ReleaseArea> other_releases;  ///< of members with other files, for maps
    std::vector<Slope> slopes;                ///< of a region, by member
    /// One fact per line: the study, every member's values, the scenes and their data. Two studies with the same
    /// identity give the same bits.
    std::string identity;
    std::vector<LevelCells> levels;  ///< of a multilevel study, the coarsest first
    /// The files read so far, for the members: whatever several of them need is read once.
    std::shared_ptr<gis::RememberedReads> files = std::make_shared<gis::RememberedReads>();
    bool keeps_final_depth = false;  ///< of the members' records

    /// Returns the scene of a member, as `frana run` with its values reads it.
    [[nodiscard]] SceneReading member(std::size_t index) const;
    /// Returns the scene with the study's settings and these values ("key=value").
    [[nodiscard]] SceneReading scene_with(const std::vector<std::string>& overrides) const;
};

/// Draws other members for a study that was prepared, as its `reading.study` says by now. Throws Error(input).
void redraw(StudyInput& input);

/// A study whose files have been read as text: where its result goes is known, and all problems so far.
struct StudyTexts {
    study::StudyReading reading;
    study::SampleTable table;
    std::vector<study::SampleTable> level_draws;
    std::vector<Slope> slopes;
    SceneReading central;  ///< its problems contain those of the study and of all members
};

/// Reads study (or region), table and scene, draws the members, and reads the scene of each. The study file of a
/// result, which may have been moved, finds its inputs as find_recorded_inputs(). Throws Error(input) only if a file is
/// no INI, the study names no scene, or an input of such a result is missing.
StudyTexts read_study_texts(const std::string& path, RunLog& log);

/// The same for members that are known already.
StudyTexts read_study_scenes(study::StudyReading reading, study::SampleTable table);

/// Prepares the central member, and a member for each value of keys without order, such as files. Throws Error(input)
/// with every problem found, and with that of the result's place as prepare().
StudyInput prepare_study(StudyTexts texts, const std::optional<Problem>& place, RunLog& log);

}  // namespace frana::app
