// SPDX-License-Identifier: Apache-2.0
#include "app/commands/scene_variants.h"

#include <algorithm>

#include "app/commands/progress.h"
#include "app/input/share_directory.h"
#include "app/process/signals.h"
#include "simulation/simulation.h"

namespace frana::app {

Prepared SceneVariants::read(const std::vector<std::string>& more) {
    // A variant's value counts in place of the user's for the same key.
    std::vector<std::string> all = overrides_;
    std::erase_if(all, [&](const std::string& given) {
        return std::any_of(more.begin(), more.end(), [&](const std::string& text) {
            return given.starts_with(text.substr(0, text.find('=') + 1));
        });
    });
    all.insert(all.end(), more.begin(), more.end());
    const SceneReading reading = read_scene(file_, all, materials_directory());
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
