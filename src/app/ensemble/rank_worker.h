// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/ensemble/study_input.h"
#include "ranks/job.h"

namespace frana::app {

/// What a rank reads: everything of which rank 0 may give it members.
struct RankStudies {
    std::vector<StudyInput> studies;  ///< by MemberTask::study
    std::string identity;             ///< as rank 0 has it (RankPool::start)
};

/// A rank other than 0 of a study: reads it, runs the members that rank 0 gives it, each on one thread, and sends their
/// records back. Writes neither files nor messages: rank 0 is told of problems. Returns once rank 0 has nothing more to
/// do.
/// @param file of the study, for messages
void work_for_rank_0(const ranks::Job& job, const std::function<RankStudies()>& read, const std::string& file,
                     int threads);

}  // namespace frana::app
