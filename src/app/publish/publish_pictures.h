// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/compare/comparison.h"
#include "app/pictures/result_numbers.h"
#include "app/text/run_log.h"
#include "core/words/sentence.h"
#include "params/keys/scene_spec.h"

namespace frana::app {

/// The pictures of a scene: maps, comparison, charts, animation.
struct PictureRequest {
    const SceneSpec& spec;
    std::string folder;  ///< of the result
    const std::optional<Comparison>& comparison;
    std::optional<MainStatistics> statistics;  ///< of a run whose summary.json is not written yet
    std::string date{};                        ///< the same
    Warnings warnings{};                       ///< the same
    const RunResult* run = nullptr;            ///< whose rasters are drawn; null: those of the files
    int threads = 1;
};

/// What drawing found, and left for --resume.
struct PictureOutcome {
    bool has_failed = false;   ///< a picture, for a reason that may pass
    bool was_stopped = false;  ///< by a signal, before all were drawn
    Warnings warnings{};       ///< of what could not be drawn or read, told
};

/// Loads what the pictures and the particles of a run are drawn and written with: it is better missed before the run
/// than after it. Throws Error(environment) if it is missing.
enum class Loading { now, later };  ///< later: only looks whether they are there, as `frana check` does
void load_drawing(const SceneSpec& scene, Loading loading = Loading::now);
void load_drawing(bool pictures, bool films, Loading loading);
/// The memory that this takes once they are loaded, as measured on Debian 12 [bytes].
std::int64_t drawing_library_bytes(const SceneSpec& scene);

/// Draws them beside each other; any exception is a warning, since the numbers are more important than a picture.
/// Pictures not begun when a stop signal arrives are left out, so that the program ends soon.
PictureOutcome draw_pictures(const PictureRequest& request, RunLog& log);

}  // namespace frana::app
