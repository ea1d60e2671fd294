// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "started_program.h"
#include "support/tiny_scene.h"

namespace frana::test {

/// A tiny scene that takes a second, for runs that are stopped, killed and resumed.
class Resuming : public TinyScene {
  protected:
    Resuming();

    /// Returns the arguments of a run into a result, with checkpoints twenty times per second.
    [[nodiscard]] std::vector<std::string> run(const std::string& result,
                                               const std::vector<std::string>& more = {}) const;
    /// The latest first; of the result itself and of folders beside it.
    [[nodiscard]] std::vector<std::string> checkpoints(const std::string& result) const;
    /// Whether there are at least so many checkpoints of a result.
    [[nodiscard]] bool has_checkpoints(const std::string& result, std::size_t count = 1) const {
        return checkpoints(result).size() >= count;
    }
    /// Starts a run and kills it when it has two checkpoints.
    void interrupt(const std::string& result, const std::vector<std::string>& more = {}) const;
    /// Expects the same files with the same bytes, except those that contain the time of day or a duration; the summary
    /// has the same values except these.
    void expect_same_result(const std::string& one, const std::string& other) const;
    /// Expects no incomplete file and no remains beside a complete result.
    void expect_tidy(const std::string& result) const;
};

}  // namespace frana::test
