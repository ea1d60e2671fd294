// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/input/prepare.h"
#include "app/process/terminal.h"
#include "app/store/checkpoint_file.h"
#include "app/store/frame_store.h"
#include "app/text/run_log.h"
#include "core/error.h"

namespace frana::app {

/// Folder of checkpoints in a result directory.
inline constexpr const char* k_checkpoint_folder = "checkpoint";

/// Returns the checkpoints in a result directory, the latest first. Throws Error(environment) if the folder cannot be
/// read.
std::vector<std::string> checkpoints_in(const std::string& directory);

/// Writes the checkpoints of a run: step_NNN.frana, the last two kept.
class Checkpoints {
  public:
    /// @param interval wall time between two [s]; 0: only at the end
    /// @param frames whose records a checkpoint contains; null: none are written
    /// @param earlier wall time of earlier sessions [s]
    /// @param accuracy CheckpointHead::accuracy
    Checkpoints(std::string directory, double interval, const Prepared& prepared, FrameWriter* frames,
                const Stopwatch& since_start, double earlier, std::string accuracy, Findings found);

    /// Writes a checkpoint when it is due and at the run's last step. If one cannot be written, there is a warning and
    /// the run continues.
    void after_step(const Progress& now, const SaveState& state);

  private:
    [[nodiscard]] CheckpointHead head(const Progress& now);
    void save(const Progress& now, const SaveState& state);

    std::string directory_, folder_;
    double interval_;
    const Prepared& prepared_;
    FrameWriter* frames_;
    const Stopwatch& since_start_;
    double earlier_;
    std::string accuracy_;
    Findings found_;
    std::string identity_;  ///< computed when first needed, from all data
    Stopwatch since_last_;
    bool warned_ = false;
};

}  // namespace frana::app
