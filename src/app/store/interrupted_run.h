// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/store/checkpoint_file.h"
#include "app/store/result_directory.h"
#include "app/text/run_log.h"

namespace frana::app {

/// What runs that did not come to their end have left of one result: checkpoints in the result directory
/// (stopped by a signal) and in folders beside it in which it was being built (killed).
class InterruptedRun {
  public:
    /// Throws Error(environment) where the place cannot be read.
    explicit InterruptedRun(const std::string& directory);

    [[nodiscard]] bool any() const noexcept { return !checkpoints_.empty(); }
    /// Whether the result that is there was stopped, and can go on.
    [[nodiscard]] bool in_place() const noexcept { return in_place_; }
    /// A folder beside the result that was left; empty: none.
    [[nodiscard]] const std::string& beside() const noexcept { return beside_; }

    /// The furthest checkpoint that is whole and of the same scene, with a warning for every one that is not;
    /// null where there is none at all. Throws Error(input) where there are some and none can be used.
    [[nodiscard]] std::unique_ptr<CheckpointFile> choose(const std::string& identity, RunLog& log) const;

  private:
    std::vector<std::string> checkpoints_;  ///< the furthest first
    bool in_place_ = false;
    std::string beside_;
};

/// The folder beside a result in which a checkpoint's run can go on; empty for that of the result itself, and for one
/// that does not say that the result was being built in it (an older frana's, or a copy), which stays as it is.
std::string folder_of(const CheckpointFile& checkpoint, const std::string& directory);

/// Makes a result directory what it was at a checkpoint: its frames until then and the checkpoint itself, and
/// nothing else. Throws Error(environment).
void restore_files(const CheckpointFile& checkpoint, const ResultDirectory& directory);

/// The files of the frames that a checkpoint counts on: as it tells them, or as they are in `folder` where it is older
/// than such records.
std::vector<FrameRecord> frame_records(const CheckpointFile& checkpoint, const std::string& folder);

}  // namespace frana::app
