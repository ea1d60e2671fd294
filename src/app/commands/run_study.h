// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "app/commands/command_line.h"
#include "app/commands/commands.h"
#include "app/store/result_directory.h"
#include "app/study/pool/rank_pool.h"
#include "app/study/publish/publish_study.h"
#include "core/error.h"

namespace frana::app {

// What the commands that run many members have in common.

/// The other processes of a study under mpirun; none otherwise. They end when these do.
struct OtherRanks {
    std::optional<study::Job> job;
    std::unique_ptr<study::RankPool> pool;  ///< in rank 0, if there are others

    /// Throws Error(input) if srun started several processes that cannot exchange messages.
    OtherRanks() {
        study::refuse_separate_processes();
        if (!study::started_as_rank()) return;
        job.emplace();
        if (job->rank() == 0 && job->size() > 1) pool = std::make_unique<study::RankPool>(*job);
    }
    /// They are not needed any more.
    void release() {
        pool.reset();
        job.reset();
    }
};

/// Returns the form of such a command.
/// @param what the study is called in its sentences
CommandForm study_form(const std::string& command, const std::string& meaning, const std::string& default_place,
                       const std::string& what, const std::string& operand = "STUDY.ini");

/// Adds a problem for work that an interrupted study or run has kept for this result.
/// @param study folder of the interrupted study; empty: none
void refuse_to_discard(const std::string& target, const std::string& study, Problems& problems);

/// Throws Error(input) if the members kept in a folder belong to a study with another identity, with the differences.
void require_same_study(const std::string& identity, const std::string& folder);

/// Whether a result is complete and of the same study: nothing is left to do. Throws Error(input) if it is the finished
/// result of another one.
bool is_complete(const std::string& identity, const std::string& target);

/// Gives a written result its name, and returns the exit code. Throws Error(environment).
/// @param strict whether a run that was cut, left the ground or failed makes the exit code 3
int publish_result(const std::string& identity, const study::StudyOutcome& outcome, bool strict,
                   ResultDirectory& directory, RunLog& log);

/// Runs the members of a study or region and writes what they say together. Returns the exit code; throws Error.
/// @param check_file throws Error(input) for the file of another command
int run_study(const CommandForm& form, void (*check_file)(const std::string& file), const Arguments& arguments);

}  // namespace frana::app
