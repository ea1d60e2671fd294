// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/input/prepare.h"
#include "simulation/result.h"

namespace frana::app {

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
