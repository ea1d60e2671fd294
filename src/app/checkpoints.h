// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/checkpoint_file.h"
#include "app/frame_store.h"
#include "app/prepare.h"
#include "app/run_log.h"
#include "app/stopwatch.h"

namespace frana::app {

/// Folder of checkpoints in a result directory.
inline constexpr const char* k_checkpoint_folder = "checkpoint";

/// The checkpoints in a result directory, the furthest first.
std::vector<std::string> checkpoints_in(const std::string& directory);

/// Takes the checkpoints of a run: step_NNN.frana, the last two kept.
class Checkpoints {
  public:
    /// @param interval wall time between two [s]; 0: only when asked for
    /// @param frames those that a checkpoint counts on; null: none are written
    /// @param earlier wall time of earlier sessions [s]
    Checkpoints(std::string directory, double interval, const Prepared& prepared, FrameWriter* frames,
                const Stopwatch& since_start, double earlier, RunLog& log);

    [[nodiscard]] bool due() const { return interval_ > 0 && since_last_.seconds() >= interval_; }
    /// A checkpoint that cannot be written is a warning: the run goes on. Throws Error(environment) where a frame could
    /// not be written.
    void save(const Progress& now, const SaveState& state);

  private:
    std::string directory_;
    double interval_;
    const Prepared& prepared_;
    FrameWriter* frames_;
    const Stopwatch& since_start_;
    double earlier_;
    RunLog& log_;
    std::string identity_;  ///< made when first needed: it takes a look at all data
    Stopwatch since_last_;
    bool warned_ = false;
};

}  // namespace frana::app
