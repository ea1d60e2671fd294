// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/input/prepare.h"
#include "simulation/result.h"

namespace frana::app {

/// Runs of one scene that differ in some keys, as studies need them: the engine alone, nothing written.
class SceneVariants {
  public:
    /// @param overrides section.key=value of the command line, which hold for all
    SceneVariants(std::string file, std::vector<std::string> overrides, int threads, bool quiet)
        : file_(std::move(file)), overrides_(std::move(overrides)), threads_(threads), quiet_(quiet), log_(quiet) {}

    /// The scene with more overrides. Throws Error(input) as prepare does.
    Prepared read(const std::vector<std::string>& more);
    /// To its end, with progress on the terminal; a signal stops it (StopReason::requested).
    [[nodiscard]] RunResult run(const Scene& scene) const;

  private:
    std::string file_;
    std::vector<std::string> overrides_;
    int threads_;
    bool quiet_;
    RunLog log_;
};

}  // namespace frana::app
