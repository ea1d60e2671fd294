// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/compare/comparison.h"
#include "app/store/main_statistics.h"
#include "app/text/run_log.h"
#include "params/keys/scene_spec.h"

namespace frana::app {

/// The pictures that a scene asks for: maps, comparison, charts, animation. They are drawn from the files of a result.
struct PictureRequest {
    const SceneSpec& spec;
    std::string folder;  ///< of the result
    const std::optional<Comparison>& comparison;
    bool only_missing = false;                 ///< what is there already stays as it is
    std::optional<MainStatistics> statistics;  ///< of a run whose summary.json is not written yet
};

/// What came of them.
struct PictureOutcome {
    std::vector<std::string> drawn;     ///< "maps/max_depth"
    std::vector<std::string> files;     ///< that were written
    std::vector<std::string> failed;    ///< each with a warning
    std::vector<std::string> left_out;  ///< a stop signal had come before they were drawn; one warning for all

    [[nodiscard]] bool complete() const noexcept { return failed.empty() && left_out.empty(); }
};

/// Draws them; a problem is a warning, since the numbers are worth more than a picture. What is not begun when a stop
/// signal comes is left out, so that the program ends soon.
PictureOutcome draw_pictures(const PictureRequest& request, RunLog& log);

}  // namespace frana::app
