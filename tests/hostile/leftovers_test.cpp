// SPDX-License-Identifier: Apache-2.0
// Files that frana could not remove, or had not completed when it was killed, are removed by the next command; user's
// files with similar names are kept.
#include <algorithm>
#include <cerrno>
#include <csignal>
#include <fstream>

#include "trial_ground.h"

namespace frana::test {
namespace {

class Leftovers : public TrialGround {
  protected:
    Leftovers() : TrialGround("off", "off") {}
    void SetUp() override {
        if (!can_watch_calls()) GTEST_SKIP() << "this system does not let a program's calls be watched (seccomp)";
        tried_ = commands();
    }
    TriedCommand& measured(const std::string& name) {
        for (TriedCommand& command : tried_) {
            if (command.name != name) continue;
            measure(command, k_all);
            return command;
        }
        throw std::logic_error(name);
    }
    /// Runs the command with this answer to certain calls; `again`: only to one of them, counted from 0.
    [[nodiscard]] Ending disturb(const TriedCommand& command, const Answer& answer,
                                 const std::function<bool(const SystemCall&)>& meets, int only = -1) {
        restore(command.begins_in);
        met_ = 0;
        return run({command.arguments}, k_all, [&](const SystemCall& call) {
            return meets(call) && (only < 0 || met_++ == only) ? answer : Answer{};
        });
    }
    /// The same command again ends as it does undisturbed.
    Ending expect_repaired(const TriedCommand& command, const std::vector<std::string>& again) const {
        Ending ending = run(again);
        EXPECT_EQ(ending.exit_code, 0) << ending.err;
        const std::vector<std::string> wrong = differences(command.after, state());
        EXPECT_TRUE(wrong.empty()) << in_lines(wrong) << ending.err;
        return ending;
    }
    static bool is_of(const SystemCall& call, const std::string& name, const std::string& path) {
        return call.name.rfind(name, 0) == 0 && call.path.rfind(path, 0) == 0;
    }

    static constexpr Watch k_all{true, true, false};
    std::vector<TriedCommand> tried_;
    int met_ = 0;
};

TEST_F(Leftovers, ACheckpointThatCannotBeRemovedIsRemovedByTheNextRun) {
    const auto stick = [&](const TriedCommand& command) {
        const Ending ending = disturb(command, {Answer::Kind::fail, EACCES}, [](const SystemCall& call) {
            return is_of(call, "unlink", "out/r/checkpoint/");
        });
        EXPECT_EQ(ending.exit_code, 0) << ending.err;
        EXPECT_FALSE(differences(command.after, state()).empty());
    };
    const TriedCommand &anew = measured("run"), &over = measured("run --overwrite");
    stick(over);
    expect_repaired(over, over.again);
    // --resume finds a complete result: nothing is computed again.
    stick(anew);
    const Ending told = expect_repaired(anew, {"run", "in/scene.ini", "--out", "out/r", "--resume"});
    EXPECT_NE(told.err.find("the result is complete"), std::string::npos) << told.err;
    // And --overwrite does not treat it as a file of the user.
    stick(anew);
    expect_repaired(anew, {"run", "in/scene.ini", "--out", "out/r", "--quiet", "--overwrite"});
}

TEST_F(Leftovers, AnUnfinishedListIsRemovedByTheNextRun) {
    const TriedCommand& command = measured("run");
    const auto renamed = [](const SystemCall& call) { return is_of(call, "rename", "out/r/manifest.json"); };
    int times = 0;
    for (const SystemCall& call : command.calls) times += renamed(call) ? 1 : 0;
    ASSERT_GT(times, 0);
    for (int k = 0; k < times; ++k) {
        SCOPED_TRACE(k);
        EXPECT_EQ(disturb(command, {Answer::Kind::signal, SIGKILL}, renamed, k).exit_code, -SIGKILL);
        expect_repaired(command, command.again);
        EXPECT_EQ(disturb(command, {Answer::Kind::signal, SIGKILL}, renamed, k).exit_code, -SIGKILL);
        expect_repaired(command, {"run", "in/scene.ini", "--out", "out/r", "--quiet", "--overwrite"});
    }
}

TEST_F(Leftovers, TheNoteOfAJustPublishedResultIsRemovedByTheNextRun) {
    for (const char* name : {"run", "run --overwrite"}) {
        SCOPED_TRACE(name);
        const TriedCommand& command = measured(name);
        EXPECT_EQ(disturb(command, {Answer::Kind::signal, SIGKILL},
                          [](const SystemCall& call) { return is_of(call, "unlink", "out/r/being_built.json"); })
                      .exit_code,
                  -SIGKILL);
        expect_repaired(command, command.again);
    }
}

TEST_F(Leftovers, AnUnreadableListIsReportedAndTheNextRunCleansUp) {
    const TriedCommand& command = measured("run --overwrite");
    const auto read = [](const SystemCall& call) { return is_of(call, "read", "out/r/manifest.json"); };
    int times = 0;
    for (const SystemCall& call : command.calls) times += read(call) ? 1 : 0;
    ASSERT_GT(times, 0);
    for (const int k : {0, times - 1}) {  // of the older result, and of the new one in its place
        SCOPED_TRACE(k);
        const Ending ending = disturb(command, {Answer::Kind::fail, EIO}, read, k);
        EXPECT_EQ(ending.exit_code, 4) << ending.err;
        EXPECT_NE(ending.err.find("manifest.json: cannot be read"), std::string::npos) << ending.err;
        expect_repaired(command, command.again);
        // An interrupted call is no problem.
        succeeded(disturb(command, {Answer::Kind::fail, EINTR}, read, k));
        EXPECT_EQ(in_lines(differences(command.after, state())), "");
    }
}

TEST_F(Leftovers, AnEmptiedFolderIsRemovedByTheNextRun) {
    const TriedCommand& over = measured("run --overwrite");
    const Ending emptied = disturb(over, {Answer::Kind::fail, EACCES}, [](const SystemCall& call) {
        return is_of(call, "rmdir", "out/r.partial") && call.path.size() <= std::string("out/r.partial/").size();
    });
    EXPECT_EQ(emptied.exit_code, 0) << emptied.err;
    EXPECT_FALSE(differences(over.after, state()).empty());
    expect_repaired(over, over.again);
    // If a folder in it cannot be removed, list and note are kept.
    const Ending part = disturb(over, {Answer::Kind::fail, EACCES},
                                [](const SystemCall& call) { return is_of(call, "rmdir", "out/r.partial/frames"); });
    EXPECT_EQ(part.exit_code, 0) << part.err;
    EXPECT_FALSE(differences(over.after, state()).empty());
    expect_repaired(over, over.again);
    // And one without a note.
    const TriedCommand& anew = measured("run");
    const Ending refused = disturb(anew, {Answer::Kind::fail, EMLINK}, [](const SystemCall& call) {
        return is_of(call, "link", "out/r.partial/being_built.json");
    });
    EXPECT_EQ(refused.exit_code, 4) << refused.err;
    EXPECT_EQ(in_lines(differences(anew.before, state())), "");
    EXPECT_EQ(disturb(anew, {Answer::Kind::signal, SIGKILL},
                      [](const SystemCall& call) { return is_of(call, "link", "out/r.partial/being_built"); })
                  .exit_code,
              -SIGKILL);
    expect_repaired(anew, anew.again);
}

TEST_F(Leftovers, AFolderOfTheReportsPicturesIsRemovedByTheNextRun) {
    TriedCommand pdf = measured("run");
    pdf.after.clear();
    for (auto* arguments : {&pdf.arguments, &pdf.again})
        arguments->insert(arguments->end(), {"--set", "output.maps=max_depth", "--set", "output.map-formats=pdf",
                                             "--set", "output.report=on"});
    measure(pdf, k_all);
    succeeded(disturb(pdf, {Answer::Kind::fail, EIO},
                      [](const SystemCall& call) { return is_of(call, "rmdir", "out/r.partial/report_pictures"); }));
    expect_repaired(pdf, pdf.again);
}

TEST_F(Leftovers, UsersFilesWithSimilarNamesAreKept) {
    (void)measured("run");
    const std::vector<std::string> names{"out/r/notes.partial999999.txt", "out/r/manifest.partial.json",
                                         "out/r/manifest.partialcopy.json", "out/r/scene.ini.partial1"};
    for (const std::string& name : names) std::ofstream(at(name)) << "the user's\n";
    succeeded(run({"run", "in/scene.ini", "--out", "out/r", "--quiet", "--resume"}));
    for (const std::string& name : names) EXPECT_EQ(read_text(at(name)), "the user's\n") << name;
    const Ending refused = run({"run", "in/scene.ini", "--out", "out/r", "--quiet", "--overwrite"});
    EXPECT_EQ(refused.exit_code, 2);
    for (const std::string& name : names) {
        EXPECT_NE(refused.err.find(name.substr(std::string("out/r/").size())), std::string::npos) << refused.err;
        EXPECT_EQ(read_text(at(name)), "the user's\n") << name;
    }
}

}  // namespace
}  // namespace frana::test
