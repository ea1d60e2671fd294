// SPDX-License-Identifier: Apache-2.0
#include "app/commands/scene_variants.h"

#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>

#include "app/input/share_directory.h"
#include "app/process/terminal.h"
#include "core/json.h"
#include "simulation/simulation.h"

namespace frana::app {
namespace {

constexpr double k_json_interval = 0.5;

/// The flow may come to rest earlier: this is the maximum at the present rate.
double seconds_left(const Progress& progress, double begin, double elapsed) {
    return elapsed * (progress.end - progress.time) / (progress.time - begin);
}

std::string line_of(const Progress& progress, double begin, double elapsed) {
    char text[160];
    std::snprintf(text, sizeof text, "step %lld  %.2f of at most %.6g s simulated  %lld particles",
                  static_cast<long long>(progress.step), progress.time, progress.end,
                  static_cast<long long>(progress.particles));
    std::string line = text;
    if (progress.time > begin && elapsed > 1) {
        std::snprintf(text, sizeof text, "  %.0f s left at most", seconds_left(progress, begin, elapsed));
        line += text;
    }
    return line;
}

std::string json_line(const Progress& progress, double begin, double elapsed) {
    Json line{{"phase", "computing"},
              {"fraction", progress.end > 0 ? progress.time / progress.end : 0},
              {"step", progress.step},
              {"simulated_s", progress.time},
              {"end_s", progress.end}};
    line["seconds_left"] = progress.time > begin ? Json(seconds_left(progress, begin, elapsed)) : Json();
    line["particles"] = progress.particles;
    return line.dump();
}

}  // namespace

void ProgressReporter::show(const Progress& progress) {
    if (begin_ < 0) begin_ = progress.time;
    if (json_) {
        if (line_.seconds() < next_) return;
        next_ = line_.seconds() + k_json_interval;
        std::cerr << json_line(progress, begin_, line_.seconds()) << std::endl;
        return;
    }
    if (line_.is_due()) line_.show(line_of(progress, begin_, line_.seconds()));
}

void ProgressReporter::finish() {
    line_.finish();
    if (!json_) return;
    Json line = Json::object();
    line["phase"] = "writing";
    std::cerr << line.dump() << std::endl;
}

Prepared SceneVariants::read(const std::vector<std::string>& more) {
    const SceneReading reading = read_scene(file_, overridden(overrides_, more), share_directory());
    Prepared prepared = prepare(reading, log_);
    prepared.scene.time.frame_interval = 0;
    return prepared;
}

RunResult SceneVariants::run(const Scene& scene) const {
    RunOptions options;
    ProgressReporter progress(quiet_);
    options.threads = threads_;
    options.on_progress = [&progress](const Progress& now) { progress.show(now); };
    options.stop_requested = [] { return stop_signal() != 0; };
    RunResult result = frana::run(scene, options);
    progress.finish();
    return result;
}

}  // namespace frana::app
