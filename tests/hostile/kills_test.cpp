// SPDX-License-Identifier: Apache-2.0
// Runs that are killed or stopped just before a rename, an fsync, an unlink or any other change on disk, and at random
// moments; then the same command again.
#include <algorithm>
#include <chrono>
#include <csignal>

#include "support/tiny_scene.h"
#include "trial_ground.h"
#include "trials.h"

namespace frana::test {
namespace {

class Killed : public TrialGround {
  protected:
    void SetUp() override {
        if (!can_watch_calls()) GTEST_SKIP() << "this system does not let a program's calls be watched (seccomp)";
    }

    void attempt(const TriedCommand& command, const SystemCall& moment, int signal_number, Trials& trials) const {
        restore(command.begins_in);
        const Ending ending = run({command.arguments}, {}, [&](const SystemCall& call) {
            return call == moment ? Answer{Answer::Kind::signal, signal_number} : Answer{};
        });
        expect_nothing_lost(command, ending, signal_number == SIGKILL ? Disturbance::kill : Disturbance::error);
        trials.ended(ending.exit_code);
        expect_repaired(command);
    }

    RandomNumbers random_{trial_seed(), 2};
};

TEST_F(Killed, OrStoppedBeforeAnyChangeOnDiskLosesNothing) {
    std::vector<TriedCommand> tried = commands();
    std::erase_if(tried, [](const TriedCommand& command) { return command.name == "check"; });  // changes nothing
    Trials trials;
    for (int k = 0; k < trial_count(5); ++k) {
        const int signal_number = k % 3 == 2 ? SIGTERM : SIGKILL;
        trials.begin(signal_number == SIGKILL ? "kills before a change on disk" : "SIGTERM before a change on disk");
        TriedCommand& command = tried[random_.below(tried.size())];
        measure(command);
        if (HasFatalFailure()) return;
        const SystemCall call = random_call(command.calls, random_);
        SCOPED_TRACE("seed " + std::to_string(trial_seed()) + ", trial " + std::to_string(k) + ": " + command.name +
                     ", signal " + std::to_string(signal_number) + " before " + call.text());
        attempt(command, call, signal_number, trials);
    }
}

// Most of a command's time passes before its disk changes: hence also moments by the clock.
TEST_F(Killed, AtRandomMomentsLosesNothing) {
    std::vector<TriedCommand> tried = commands();
    std::erase_if(tried, [](const TriedCommand& command) { return command.name == "check"; });
    Trials trials;
    for (int k = 0; k < trial_count(2); ++k) {
        trials.begin("kills at random moments");
        TriedCommand& command = tried[random_.below(tried.size())];
        const auto begin = std::chrono::steady_clock::now();
        measure(command);
        if (HasFatalFailure()) return;
        const double whole = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        restore(command.begins_in);
        Launch launch{command.arguments};
        launch.patience_seconds = random_.between(0.02, 1) * std::max(whole, 0.5);
        SCOPED_TRACE("seed " + std::to_string(trial_seed()) + ", trial " + std::to_string(k) + ": " + command.name +
                     ", SIGKILL after " + std::to_string(launch.patience_seconds) + " s");
        const Ending ending = run(launch);
        trials.ended(ending.exit_code);
        expect_nothing_lost(command, ending, Disturbance::kill);
        expect_repaired(command);
    }
}

// Rasters are written, nothing is left to draw: the signal comes too late to leave anything out.
class LateSignal : public TinyScene {};

TEST_F(LateSignal, WithoutEffectIsNoError) {
    if (!can_watch_calls()) GTEST_SKIP() << "this system does not let a program's calls be watched (seccomp)";
    bool sent = false;
    const Ending ending =
        run_supervised(folder_.string(), {{"run", "scene.ini", "--out", "result"}}, {}, [&](const SystemCall& call) {
            if (sent || call.path.find("/summary.json") == std::string::npos) return Answer{};
            sent = true;
            EXPECT_TRUE(std::filesystem::exists(path("result.partial/max_depth.tif")));
            return Answer{Answer::Kind::signal, SIGTERM};
        });
    EXPECT_TRUE(sent);
    EXPECT_EQ(ending.exit_code, 0) << ending.err;
    EXPECT_TRUE(std::filesystem::exists(path("result/summary.json")));
    for (const std::string& name : files())
        EXPECT_TRUE(name.find("partial") == std::string::npos && name.find("checkpoint") == std::string::npos) << name;
}

}  // namespace
}  // namespace frana::test
