// SPDX-License-Identifier: Apache-2.0
// Runs that are killed, stopped by signals and resumed, from the user's view.
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <random>
#include <thread>

#include "app/store/checkpoint_file.h"
#include "core/error.h"
#include "resuming.h"

namespace frana::test {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

// Blocks that break, with fluid, instead of the flow.
const std::string k_breaking =
    "[terrain]\ndtm = dtm.asc\n[release]\nperimeter = perimeter.geojson\nthickness = 2\n[material]\n"
    "model = structured\n[structured]\nphases = solids-and-fluid\ncohesion = 2e3\ninternal-friction-angle = "
    "28\n"
    "bed-friction-angle = 12\nyoung-modulus = 1e6\nbulk-modulus = 1e6\n[numerics]\nparticles-per-cell = 9\n"
    "[time]\nend = 2\nframe-interval = 0.5\n[output]\nmaps = off\nanimation = off\nreport = off\n" +
    k_one_day;

std::vector<std::string> with(std::vector<std::string> first, const std::vector<std::string>& more) {
    first.insert(first.end(), more.begin(), more.end());
    return first;
}

// Kills a run at a random moment, sometimes the resumed run as well, and lets it complete. Some moments are before the
// first checkpoint, some after the last file.
class Killed : public Resuming {
  protected:
    void kill_and_resume(int kills, const std::vector<std::string>& more) {
        const auto begin = std::chrono::steady_clock::now();
        succeeded(frana(run("whole", with(more, {"--threads", "1"}))));
        const auto whole = std::chrono::steady_clock::now() - begin;
        const unsigned seed = std::random_device()();
        RecordProperty("seed", std::to_string(seed));
        std::mt19937 random(seed);
        int survived = 0;
        for (int k = 0; survived < kills; ++k) {
            const std::string result = "killed" + std::to_string(k), threads = k % 2 == 0 ? "2" : "1";
            SCOPED_TRACE("seed " + std::to_string(seed) + ", result " + result);
            for (bool continues = true; continues;) {
                StartedProgram program(folder_.string(),
                                       run(result, with(more, {"--resume", "--quiet", "--threads", threads})));
                const double fraction = std::uniform_real_distribution<double>(0.02, 1.1)(random);
                std::this_thread::sleep_for(std::chrono::duration_cast<std::chrono::milliseconds>(fraction * whole));
                program.send(SIGKILL);
                const Outcome outcome = program.wait();
                // Under its name there is a complete result or none.
                EXPECT_EQ(fs::exists(path(result)), fs::exists(path(result + "/summary.json")));
                continues = outcome.exit_code == -SIGKILL && random() % 2 == 0;
                if (outcome.exit_code == -SIGKILL) ++survived;
                EXPECT_TRUE(outcome.exit_code == -SIGKILL || outcome.exit_code == 0) << outcome.err;
                if (fs::exists(path(result + "/summary.json"))) continues = false;
            }
            succeeded(frana(run(result, with(more, {"--resume", "--quiet"}))));
            expect_same_result("whole", result);
            expect_tidy(result);
            fs::remove_all(path(result));
        }
    }

    // The number in the default tests; FRANA_KILLS sets another.
    static int kills() {
        const char* asked = std::getenv("FRANA_KILLS");
        return asked != nullptr ? std::atoi(asked) : 2;
    }
};

// SQLite has a journal beside a GeoPackage while it writes it; its process number may be another program's now.
TEST_F(Killed, JournalsOfAKillAreInNoManifest) {
    interrupt("result");
    const std::string folder = "result.partial";
    for (const char* process : {"999999999", "1"})
        for (const char* ending : {".gpkg", ".gpkg-journal"})
            write(folder + "/extent.partial" + process + ending, "half");
    succeeded(frana(run("result", {"--resume", "--quiet"})));
    EXPECT_EQ(read_text(path("result/manifest.json")).find(".partial"), std::string::npos);
    expect_tidy("result");
    for (const std::string& file : files()) EXPECT_EQ(file.find("journal"), std::string::npos) << file;
}

TEST_F(Killed, AtAnyMomentItEndsInTheSameBits) {
    kill_and_resume(kills(), {});
}

TEST_F(Killed, AtAnyMomentTheStructuredModelEndsInTheSameBits) {
    write("scene.ini", k_breaking);
    kill_and_resume(kills(), {});
}

TEST_F(Killed, AtAnyMomentWithAFrictionTableItEndsInTheSameBits) {
    kill_and_resume(kills(), {"--set", "material.friction-table=ngi-avalanche", "--set", "material.return-period=300",
                              "--set", "material.table-friction-factor=0.5"});
}

class Stopped : public Resuming {};

TEST_F(Stopped, BySignalsItKeepsItsStateAndIsResumed) {
    // Checkpoints only when a signal stops it.
    const auto run_once = [&](const std::string& result) {
        std::vector<std::string> arguments = run(result);
        arguments.back() = "output.checkpoint-interval=0";
        return arguments;
    };
    succeeded(frana(with(run_once("whole"), {"--quiet"})));
    const std::vector<std::pair<int, std::string>> signals{{SIGINT, "int"}, {SIGTERM, "term"}, {SIGHUP, "hup"}};
    for (const auto& [number, result] : signals) {
        {
            StartedProgram program(folder_.string(), run_once(result));
            ASSERT_TRUE(
                program.wait_until([&] { return fs::exists(path(result + ".partial/frames/depth_0002.tif")); }));
            program.send(number);
            const Outcome outcome = program.wait();
            EXPECT_EQ(outcome.exit_code, 128 + number) << outcome.err;
            EXPECT_NE(outcome.err.find("--resume continues it"), std::string::npos) << outcome.err;
        }
        const std::string summary = read_text(path(result + "/summary.json"));
        EXPECT_EQ(json_text(summary, "stop_reason"), "requested");
        EXPECT_TRUE(json_lists(summary, "warnings", "when signal ends the run")) << summary;
        EXPECT_TRUE(fs::exists(path(result + "/max_depth.tif")));
        ASSERT_EQ(checkpoints(result).size(), 1U);

        refusal_of(frana(run_once(result)), {"--resume"});
        ASSERT_EQ(checkpoints(result).size(), 1U);

        const Outcome resumed = succeeded(frana(with(run_once(result), {"--resume", "--threads", "3"})));
        EXPECT_NE(resumed.err.find("resuming from"), std::string::npos) << resumed.err;
        expect_same_result("whole", result);
        expect_tidy(result);
        const std::string log = read_text(path(result + "/log.txt"));
        EXPECT_LT(log.find("checkpoint at"), log.find("resuming from"));  // both sessions, in order
    }
}

class Interrupted : public Resuming {};

TEST_F(Interrupted, ItIsNeitherIgnoredNorLost) {
    interrupt("result");
    const std::vector<std::string> before = checkpoints("result");
    ASSERT_EQ(before.size(), 2U);  // the last two are kept
    refusal_of(frana(run("result")), {"an interrupted run of it is kept in", "--resume continues it"});
    EXPECT_EQ(checkpoints("result"), before);
    // From the start, if requested; then it is replaced.
    succeeded(frana(run("result", {"--overwrite", "--quiet"})));
    expect_tidy("result");
    for (const std::string& name : files()) EXPECT_EQ(name.rfind("result.", 0), std::string::npos) << name;
}

TEST_F(Interrupted, WithoutACheckpointResumingStartsAtTheBeginning) {
    const Outcome outcome = succeeded(frana(run("result", {"--resume"})));
    EXPECT_NE(outcome.err.find("no checkpoint: starting from the beginning"), std::string::npos) << outcome.err;
    const Outcome again = succeeded(frana(run("result", {"--resume"})));
    EXPECT_NE(again.err.find("the result is complete"), std::string::npos) << again.err;
}

TEST_F(Interrupted, ADamagedCheckpointIsReplacedByTheOneBefore) {
    succeeded(frana(run("whole", {"--quiet"})));
    interrupt("result");
    const std::vector<std::string> both = checkpoints("result");
    ASSERT_EQ(both.size(), 2U);
    std::string bytes = read_text(both[0]);
    bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 4);
    std::ofstream(both[0], std::ios::binary) << bytes;
    const Outcome outcome = succeeded(frana(run("result", {"--resume"})));
    expect_words(outcome.err, {"checkpoint not used: " + both[0] + ": is damaged", "resuming from"});
    expect_same_result("whole", "result");
}

TEST_F(Interrupted, NothingToResumeFromIsReportedNotRestarted) {
    interrupt("result");
    const std::vector<std::string> both = checkpoints("result");
    const std::string newest = read_text(both[0]);
    const auto refusal = [&](const std::vector<std::string>& more) {
        const Outcome outcome = refusal_of(frana(run("result", with({"--resume"}, more))),
                                           {"the run cannot be resumed from any checkpoint"});
        return outcome.err;
    };
    // Another scene: reports which keys, which data.
    EXPECT_NE(refusal({"--set", "material.turbulence=400"})
                  .find("is from another scene: material.turbulence is 400 here and was 500"),
              std::string::npos);
    const std::string dtm = read_text(path("dtm.asc"));
    write_dtm([](int, int column) { return 301 - 2.5 * column; });
    EXPECT_NE(refusal({}).find("is from another scene: the content of DTM differs"), std::string::npos);
    write("dtm.asc", dtm);

    fs::remove(both[1]);
    std::string newer = newest;
    const auto own = static_cast<int>(app::k_checkpoint_format);
    newer[12] = static_cast<char>(own + 1);  // the format
    std::ofstream(both[0], std::ios::binary) << newer;
    EXPECT_NE(refusal({}).find("was written by a newer frana, in format " + std::to_string(own + 1) +
                               "; this one reads " + std::to_string(own)),
              std::string::npos);
    std::ofstream(both[0], std::ios::binary) << newest.substr(0, newest.size() - 1);
    EXPECT_NE(refusal({}).find("is cut short"), std::string::npos);
    std::ofstream(both[0], std::ios::binary) << "something else, and longer than what a checkpoint begins with";
    EXPECT_NE(refusal({}).find("is no checkpoint"), std::string::npos);
    std::ofstream(both[0], std::ios::binary) << newest;
    succeeded(frana(run("result", {"--resume", "--quiet"})));
}

TEST_F(Interrupted, AMissingInputOrFrameIsReported) {
    interrupt("result");
    fs::rename(path("dtm.asc"), path("elsewhere.asc"));
    refusal_of(frana(run("result", {"--resume"})), {"dtm.asc"});
    fs::rename(path("elsewhere.asc"), path("dtm.asc"));
    const fs::path frame =
        fs::path(checkpoints("result").front()).parent_path().parent_path() / "frames/depth_0000.tif";
    fs::rename(frame, path("frame"));
    refusal_of(frana(run("result", {"--resume"})), {"needs a frame that is missing"});
    fs::rename(path("frame"), frame);
    succeeded(frana(run("result", {"--resume", "--quiet"})));
}

// Every byte counts: with any change, the file is refused, without a crash.
TEST_F(Interrupted, NoChangedByteOfACheckpointIsAccepted) {
    interrupt("result");
    const std::string file = checkpoints("result").front(), bytes = read_text(file);
    ASSERT_NO_THROW(app::CheckpointFile{file});
    std::mt19937 random(20020629);
    for (int i = 0; i < 300; ++i) {
        std::string changed = bytes;
        const std::size_t place = i < 24 ? static_cast<std::size_t>(i) : random() % bytes.size();
        changed[place] = static_cast<char>(changed[place] ^ (1 << (random() % 8)));
        std::ofstream(path("changed"), std::ios::binary) << changed;
        EXPECT_THROW(app::CheckpointFile{path("changed")}, Error) << place;
    }
    for (const std::size_t size :
         {std::size_t{0}, std::size_t{7}, std::size_t{23}, std::size_t{28}, bytes.size() - 1}) {
        std::ofstream(path("changed"), std::ios::binary) << bytes.substr(0, size);
        EXPECT_THROW(app::CheckpointFile{path("changed")}, Error) << size;
    }
}

}  // namespace
}  // namespace frana::test
