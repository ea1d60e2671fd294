// SPDX-License-Identifier: Apache-2.0
#include "resuming.h"

#include <algorithm>
#include <csignal>

#include "same_result.h"

namespace frana::test {
namespace {

namespace fs = std::filesystem;

}  // namespace

Resuming::Resuming() {
    write_scene(
        "stop-when-still = off\nstop-change = 0\nframe-interval = 0.5\n[numerics]\nparticles-per-cell = 16\n[output]\n"
        "maps = off\nanimation = off\nreport = off\n" +
        k_one_day + "[terrain]\ncell-size = 1\n");
}

std::vector<std::string> Resuming::run(const std::string& result, const std::vector<std::string>& more) const {
    return with_more({"run", "scene.ini", "--out", result, "--set", "output.checkpoint-interval=0.02"}, more);
}

std::vector<std::string> Resuming::checkpoints(const std::string& result) const {
    std::vector<fs::path> found;
    std::error_code ignored;
    const fs::path place = folder_ / result;
    const std::string own = place.filename().string();
    for (const auto& entry : fs::directory_iterator(place.parent_path(), ignored)) {
        const std::string name = entry.path().filename().string();
        if (name != own && name != own + ".partial") continue;
        for (const auto& file : fs::directory_iterator(entry.path() / "checkpoint", ignored)) {
            const std::string step = file.path().filename().string();
            if (step.starts_with("step_") && step.find(".partial") == std::string::npos) found.push_back(file.path());
        }
    }
    std::sort(found.begin(), found.end(),
              [](const fs::path& a, const fs::path& b) { return a.filename() > b.filename(); });
    return {found.begin(), found.end()};
}

void Resuming::interrupt(const std::string& result, const std::vector<std::string>& more) const {
    StartedProgram program(folder_.string(), run(result, more));
    // A checkpoint is written before the last but one of those before it is removed: for a moment there are three.
    ASSERT_TRUE(program.wait_until([&] {
        if (!has_checkpoints(result, 2)) return false;
        program.pause();
        if (checkpoints(result).size() == 2) return true;
        program.send(SIGCONT);
        return false;
    })) << program.wait().err;
    program.send(SIGKILL);
    ASSERT_EQ(program.wait().exit_code, -SIGKILL);
}

void Resuming::expect_same_result(const std::string& one, const std::string& other) const {
    EXPECT_GT(expect_same_files(path(one), path(other)), 20U);
}

void Resuming::expect_tidy(const std::string& result) const {
    for (const std::string& name : files()) {
        if (name.rfind(result, 0) != 0) continue;
        expect_no_words(name, {"partial", "checkpoint"});
    }
}

}  // namespace frana::test
