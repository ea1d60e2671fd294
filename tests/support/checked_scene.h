// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/input/prepare.h"
#include "support/tiny_scene.h"

namespace frana::test {

using Sets = std::vector<std::string>;  ///< section.key=value

/// What `frana check` finds in a scene before it tries a run.
struct Checked {
    std::vector<Problem> problems;          ///< none: it can run
    Warnings warnings;                      ///< in the order in which they are told
    std::optional<app::Prepared> prepared;  ///< if it can run

    [[nodiscard]] bool is_refused() const { return !problems.empty(); }
    /// Everything that the program would print, a line each.
    [[nodiscard]] std::string told() const;
};

/// The tiny scene, checked without starting the program.
class CheckedScene : public TinyScene {
  protected:
    [[nodiscard]] Checked check(const Sets& sets = {}, const std::string& scene = "scene.ini") const;
    /// The problems with which a command ({"run", "scene.ini", "--threads", "0"}) refuses, in the scene's folder; none:
    /// it ran.
    [[nodiscard]] std::vector<Problem> refusal(const std::vector<std::string>& words) const;
    /// The same as the outcome that a started program would have, for refusal_of().
    [[nodiscard]] Outcome refused(const std::vector<std::string>& words) const;
};

}  // namespace frana::test
