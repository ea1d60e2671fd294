// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "started_program.h"
#include "tiny_scene.h"

namespace frana::test {

/// A tiny scene that takes a second, for runs that are stopped, killed and resumed.
class Resuming : public TinyScene {
  protected:
    Resuming();

    /// Arguments of a run into a result, with checkpoints twenty times a second.
    [[nodiscard]] std::vector<std::string> run(const std::string& result,
                                               const std::vector<std::string>& more = {}) const;
    /// The furthest first; of the result itself and of folders beside it.
    [[nodiscard]] std::vector<std::string> checkpoints(const std::string& result) const;
    /// Whether there are so many checkpoints of a result.
    [[nodiscard]] bool has_checkpoints(const std::string& result, std::size_t count = 1) const {
        return checkpoints(result).size() >= count;
    }
    /// Lets a run begin and kills it once it has taken its second checkpoint.
    void interrupt(const std::string& result, const std::vector<std::string>& more = {}) const;
    /// The same files with the same bytes, but for those that tell the time of day or how long it took; of these the
    /// summary has the same values.
    void expect_same_result(const std::string& one, const std::string& other) const;
    /// Nothing half written and nothing left over beside a finished result.
    void expect_tidy(const std::string& result) const;
};

}  // namespace frana::test
