// SPDX-License-Identifier: Apache-2.0
// Full disks, unwritable places, inputs that disappear during a run, and closed message streams.
#include <sys/mount.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <optional>
#include <thread>

#include "resuming.h"

namespace frana::test {
namespace {

namespace fs = std::filesystem;

/// With a separate disk of 48 MB, in the folder "disk".
class SmallDisk : public Resuming {
  protected:
    void SetUp() override {
        fs::create_directory(disk());
        if (::mount("tmpfs", disk().c_str(), "tmpfs", 0, "size=48m") != 0)
            GTEST_SKIP() << "a small disk can be mounted by root only: " << std::strerror(errno);
        mounted_ = true;
    }
    void TearDown() override {
        if (mounted_) ::umount2(disk().c_str(), MNT_DETACH);
    }
    [[nodiscard]] std::string disk() const { return path("disk"); }

  private:
    bool mounted_ = false;
};

/// Allocates every free byte of a disk, continuously, during its lifetime.
class Filler {
  public:
    explicit Filler(const std::string& disk) : path_(disk + "/filler") {
        take();
        thread_ = std::thread([this] {
            while (!enough_) {
                take();
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
            }
        });
    }
    ~Filler() {
        enough_ = true;
        thread_.join();
        fs::remove(path_);
    }
    Filler(const Filler&) = delete;
    Filler& operator=(const Filler&) = delete;

  private:
    void take() const {
        std::ofstream file(path_, std::ios::binary | std::ios::app);
        const std::string block(4096, 'x');
        while (file.write(block.data(), static_cast<std::streamsize>(block.size())).flush()) {
        }
    }

    std::string path_;
    std::atomic<bool> enough_ = false;
    std::thread thread_;
};

TEST_F(SmallDisk, ThatFillsStopsTheRunWhichIsResumedLater) {
    fs::create_directory(path("beside"));  // as deep as on the disk: the paths in scene.ini are relative
    succeeded(frana(run("beside/whole", {"--quiet"})));
    succeeded(frana(run("disk/result", {"--quiet", "--set", "time.end=0.5"})));
    const std::string earlier = read_text(path("disk/result/summary.json"));
    std::optional<Filler> filler;
    {
        StartedProgram program(folder_.string(), run("disk/result", {"--overwrite"}));
        ASSERT_TRUE(program.wait_until([&] { return has_checkpoints("disk/result", 2); }));
        program.send(SIGSTOP);
        filler.emplace(disk());
        program.send(SIGCONT);
        const Outcome outcome = program.wait();
        EXPECT_EQ(outcome.exit_code, 4) << outcome.err;
        expect_words(outcome.err, {"disk: the disk has ", "the run up to its last checkpoint is kept",
                                   "resume with the same command"});
    }
    EXPECT_EQ(read_text(path("disk/result/summary.json")), earlier);
    // Still full: the same again, and nothing is lost.
    const Outcome again = frana(run("disk/result", {"--overwrite", "--resume"}));
    EXPECT_EQ(again.exit_code, 4) << again.err;
    EXPECT_EQ(read_text(path("disk/result/summary.json")), earlier);
    filler.reset();
    const Outcome resumed = succeeded(frana(run("disk/result", {"--overwrite", "--resume"})));
    EXPECT_NE(resumed.err.find("resuming from"), std::string::npos) << resumed.err;
    expect_same_result("beside/whole", "disk/result");
    expect_tidy("disk/result");
}

TEST_F(SmallDisk, ThatCannotBeWrittenIsReportedBeforeAnythingIsComputed) {
    ASSERT_EQ(::mount(nullptr, disk().c_str(), nullptr, MS_REMOUNT | MS_RDONLY, nullptr), 0) << std::strerror(errno);
    const Outcome outcome = frana(run("disk/result"));
    EXPECT_EQ(outcome.exit_code, 4);
    EXPECT_NE(outcome.err.find("--out: cannot be written: Read-only file system"), std::string::npos) << outcome.err;
    // Together with a problem of the scene both are reported, and the scene must be corrected first.
    refusal_of(frana(run("disk/result", {"--set", "numerics.cfl=9"})), {"Read-only file system", "numerics.cfl"});
}

class RunProblem : public Resuming {};

TEST_F(RunProblem, ADeletedFolderIsReported) {
    StartedProgram program(folder_.string(), run("result"));
    ASSERT_TRUE(program.wait_until([&] { return has_checkpoints("result"); }));
    program.send(SIGSTOP);
    fs::remove_all(path("result.partial"));
    program.send(SIGCONT);
    const Outcome outcome = program.wait();
    EXPECT_EQ(outcome.exit_code, 4) << outcome.err;
    EXPECT_NE(outcome.err.find("result.partial"), std::string::npos) << outcome.err;
    EXPECT_FALSE(fs::exists(path("result")));
}

// Inputs are read before the run; later changes do not affect it.
TEST_F(RunProblem, InputsMayBeDeletedOnceTheyAreRead) {
    succeeded(frana(run("whole", {"--quiet"})));
    StartedProgram program(folder_.string(), run("result", {"--quiet"}));
    ASSERT_TRUE(program.wait_until([&] { return has_checkpoints("result"); }));
    for (const char* name : {"dtm.asc", "dtm.prj", "perimeter.geojson", "scene.ini"}) fs::remove(path(name));
    succeeded(program.wait());
    expect_same_result("whole", "result");
}

/// Runs a shell command in the folder, FRANA being the program; returns its exit code.
int shell(const fs::path& folder, const std::string& line) {
    return WEXITSTATUS(std::system(("cd '" + folder.string() + "' && FRANA='" FRANA_PROGRAM "'; " + line).c_str()));
}

TEST_F(RunProblem, ClosedStreamsDoNotStopTheRun) {
    write_scene(k_numbers_only);
    ASSERT_EQ(shell(folder_, "\"$FRANA\" run scene.ini --out whole 2> /dev/null"), 0);
    const std::vector<std::pair<std::string, std::string>> deaf{
        {"closed", "\"$FRANA\" run scene.ini --out closed >&- 2>&- <&-"},
        {"broken", "{ \"$FRANA\" run scene.ini --out broken 2>&1; echo $? > code; } | true; exit $(cat code)"},
        {"slow", "{ \"$FRANA\" run scene.ini --out slow 2>&1; echo $? > code; } | sleep 1; exit $(cat code)"},
        {"full", "\"$FRANA\" run scene.ini --out full 2> /dev/full"}};
    for (const auto& [result, line] : deaf) {
        EXPECT_EQ(shell(folder_, line), 0) << line;
        for (const char* name : {"max_depth.tif", "timeseries.csv", "dtm.tif"})
            EXPECT_TRUE(read_text(path("whole/" + std::string(name))) == read_text(path(result + "/" + name)))
                << result << " " << name;
    }
    // Requested output to stdout is different: its loss is an error.
    EXPECT_EQ(shell(folder_, "\"$FRANA\" params --ini > /dev/full 2> err"), 4);
    EXPECT_EQ(shell(folder_, "\"$FRANA\" run scene.ini --out document --json -q >&- 2> err"), 4);
    EXPECT_TRUE(std::filesystem::exists(path("document/summary.json")));  // only the document is lost
    EXPECT_NE(read_text(path("err")).find("could not be written to stdout"), std::string::npos);
}

TEST_F(RunProblem, AnOlderResultWithChartsIsReplaced) {
    write_scene("[output]\nmaps = max_depth\nmap-size = 640x480\nanimation = off\nreport = off\nframes = off\n");
    for (int i = 0; i < 2; ++i) {
        succeeded(frana({"run", "scene.ini", "--out", "result", "--overwrite", "--quiet"}));
        EXPECT_TRUE(fs::exists(path("result/charts")));
        for (const auto& entry : fs::directory_iterator(folder_))
            EXPECT_EQ(entry.path().filename().string().find("partial"), std::string::npos) << entry.path();
    }
}

}  // namespace
}  // namespace frana::test
