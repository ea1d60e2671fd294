// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "app/store/checkpoint_file.h"
#include "app/store/result_directory.h"
#include "app/text/run_log.h"

namespace frana::app {

/// Returns the path of a file of members' records in the folder of a study's result that is being built.
std::string record_file(const std::string& folder, int number);
/// Returns the existing ones, also those of several studies whose folders are in the folder of records.
std::vector<std::string> records_in(const std::string& folder);

/// Returns whether a folder in which a result was being built has anything that --resume can use: checkpoints of a run,
/// records of a study's members.
bool has_saved_work(const std::string& folder);

/// Returns the folder in which a killed or stopped study left records of members for this result; empty: none.
std::string interrupted_study(const std::string& directory);

/// The remains of incomplete runs of one result: checkpoints in the result directory (stopped by a signal) and in the
/// partial folder (killed).
class InterruptedRun {
  public:
    /// Throws Error(environment) if the place cannot be read.
    explicit InterruptedRun(const std::string& directory);

    [[nodiscard]] bool any() const noexcept { return !checkpoints_.empty(); }
    /// Whether the existing result was stopped and can be resumed.
    [[nodiscard]] bool in_place() const noexcept { return in_place_; }
    /// The partial folder, if it has checkpoints; else empty.
    [[nodiscard]] const std::string& beside() const noexcept { return beside_; }

    /// Returns the latest checkpoint that is complete and of the same scene, with a warning for every later one that is
    /// not; null if there is none at all. Throws Error(input) if there are some and none can be used.
    [[nodiscard]] std::unique_ptr<CheckpointFile> choose(const std::string& identity, RunLog& log) const;

  private:
    std::vector<std::string> checkpoints_;  ///< the latest first
    bool in_place_ = false;
    std::string beside_;
};

/// Whether a checkpoint is in the partial folder, where its run can be resumed.
bool is_in_partial(const CheckpointFile& checkpoint, const std::string& directory);

/// Restores a result directory to its state at a checkpoint: its frames until then and the checkpoint itself, and
/// nothing else. Throws Error(environment).
void restore_files(const CheckpointFile& checkpoint, const ResultDirectory& directory);

}  // namespace frana::app
