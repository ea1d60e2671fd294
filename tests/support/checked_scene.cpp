// SPDX-License-Identifier: Apache-2.0
#include "support/checked_scene.h"

#include "app/commands/command_line.h"
#include "app/input/check_inputs.h"
#include "app/input/doubt_ground.h"
#include "app/input/share_directory.h"
#include "params/scene/read_scene.h"

namespace frana::test {

std::string Checked::told() const {
    std::string text;
    for (const std::string& warning : texts_of(warnings)) text += warning + '\n';
    for (const Problem& problem : problems) text += describe(problem) + '\n';
    return text;
}

Checked CheckedScene::check(const Sets& sets, const std::string& scene) const {
    Checked checked;
    app::RunLog log(true);
    try {
        const SceneReading reading = read_scene(path(scene), sets, app::share_directory());
        app::Prepared prepared = app::prepare(reading, {log, checked.warnings});
        checked.warnings = prepared.scene.warnings;
        prepared.scene.warnings += app::doubt_ground(reading, prepared);
        checked.warnings = prepared.scene.warnings;
        checked.warnings += app::doubt_release(prepared.scene);
        checked.warnings += app::doubt_exposure(prepared);
        checked.prepared = std::move(prepared);
    } catch (const Error& error) {
        checked.problems = error.problems();
    }
    return checked;
}

std::vector<Problem> CheckedScene::refusal(const std::vector<std::string>& words) const {
    const std::filesystem::path before = std::filesystem::current_path();
    std::filesystem::current_path(folder_);
    std::vector<Problem> problems;
    for (const app::Command& command : app::commands()) {
        if (command.name != words.front()) continue;
        try {
            app::run_command(command, {words.begin() + 1, words.end()});
        } catch (const Error& error) {
            problems = error.problems();
        } catch (const std::exception& error) {
            ADD_FAILURE() << error.what();
        }
    }
    std::filesystem::current_path(before);
    return problems;
}

Outcome CheckedScene::refused(const std::vector<std::string>& words) const {
    Outcome outcome{0, "", ""};
    for (const Problem& problem : refusal(words)) outcome = {2, "", outcome.err + describe(problem) + '\n'};
    return outcome;
}

}  // namespace frana::test
