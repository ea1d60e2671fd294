// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/input/prepare.h"
#include "app/process/terminal.h"
#include "simulation/result.h"

namespace frana::app {

/// Shows step, simulated time and time left of a run: for a person, or as lines of JSON for a program
/// (share/doc/scripts.md).
class ProgressReporter {
  public:
    /// @param json lines of JSON, also if `quiet`
    explicit ProgressReporter(bool quiet, bool json = false) : line_(quiet || json), json_(json) {}
    void show(const Progress& progress);
    /// Clears the updated line; the computation has ended, files are written next.
    void finish();

  private:
    StatusLine line_;
    bool json_;
    double next_ = 0;    ///< of the lines of JSON, seconds after the start
    double begin_ = -1;  ///< simulated time when first shown; less than 0: not yet [s]
};

/// Runs of one scene with some keys changed, for studies: the engine alone, nothing written.
class SceneVariants {
  public:
    /// @param overrides section.key=value of the command line, applied to all
    SceneVariants(std::string file, std::vector<std::string> overrides, int threads, bool quiet)
        : file_(std::move(file)), overrides_(std::move(overrides)), threads_(threads), quiet_(quiet), log_(quiet) {}

    /// Reads the scene with further overrides. Throws Error(input) as prepare does.
    Prepared read(const std::vector<std::string>& more);
    /// Runs to the end, with progress on the terminal; a signal stops it (StopReason::requested).
    [[nodiscard]] RunResult run(const Scene& scene) const;

  private:
    std::string file_;
    std::vector<std::string> overrides_;
    int threads_;
    bool quiet_;
    RunLog log_;
};

}  // namespace frana::app
