// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/input/prepare.h"
#include "app/process/stopwatch.h"
#include "app/store/checkpoint_file.h"
#include "app/store/frame_store.h"
#include "app/store/reserved_space.h"
#include "app/text/run_log.h"
#include "core/error.h"

namespace frana::app {

/// Folder of checkpoints in a result directory.
inline constexpr const char* k_checkpoint_folder = "checkpoint";

/// The checkpoints in a result directory, the furthest first. Throws Error(environment) where they cannot be
/// looked for.
std::vector<std::string> checkpoints_in(const std::string& directory);

/// Takes the checkpoints of a run: step_NNN.frana, the last two kept. The disk's room for the next one is set aside
/// beforehand and grows with the flow, so that a disk that fills still takes the state as it is then.
class Checkpoints {
  public:
    /// @param interval wall time between two [s]; 0: only at the end
    /// @param frames those that a checkpoint counts on; null: none are written
    /// @param earlier wall time of earlier sessions [s]
    Checkpoints(std::string directory, double interval, const Prepared& prepared, FrameWriter* frames,
                const Stopwatch& since_start, double earlier, RunLog& log);

    /// Looks at the clock, and takes one when it is due and at the run's last step. One that cannot be written is a
    /// warning: the run goes on.
    void after_step(const Progress& now, const SaveState& state);
    /// Gives back what was set aside.
    void release() { space_.release(); }

  private:
    [[nodiscard]] CheckpointHead head(const Progress& now);
    void save(const Progress& now, const SaveState& state);
    void reserve_space(const Progress& now, const SaveState& state);
    void warn_once(const Error& error);

    std::string directory_, folder_;
    double interval_;
    const Prepared& prepared_;
    FrameWriter* frames_;
    const Stopwatch& since_start_;
    double earlier_;
    RunLog& log_;
    std::string identity_;  ///< made when first needed: it takes a look at all data
    Stopwatch since_last_, session_;
    ReservedSpace space_;
    double next_look_ = 0;  ///< at the space that a checkpoint takes, in session_ [s]
    bool warned_ = false;
};

}  // namespace frana::app
