// SPDX-License-Identifier: Apache-2.0
// Frame files of an interrupted run: all of them exist after it was resumed, and damaged ones are not used.
#include <csignal>
#include <fstream>

#include "app/store/checkpoint_file.h"
#include "particle_points.h"
#include "resuming.h"

namespace frana::test {
namespace {

namespace fs = std::filesystem;

class ResumedFrames : public Resuming {
  protected:
    [[nodiscard]] std::vector<std::string> with_particles(const std::string& result,
                                                          std::vector<std::string> more = {}) const {
        more.insert(more.end(), {"--quiet", "--set", "output.formats=geotiff,particles-gpkg", "--set",
                                 "terrain.cell-size=2.5", "--set", "numerics.particles-per-cell=9"});
        return run(result, more);
    }
    void expect_same_particles(const std::string& one, const std::string& other) const {
        for (int i = 0; i < 9; ++i) {
            const std::string name = "/frames/particles_000" + std::to_string(i) + ".gpkg";
            const Points a = read_points(path(one + name)), b = read_points(path(other + name));
            EXPECT_GT(a.size(), 100U);
            EXPECT_EQ(a.columns, b.columns) << name;
        }
    }
    // The folder with the checkpoint and its frames.
    [[nodiscard]] fs::path folder_of(const std::string& checkpoint) const {
        return fs::path(checkpoint).parent_path().parent_path();
    }
    static void damage(const fs::path& file) {
        std::string bytes = read_text(file.string());
        ASSERT_GT(bytes.size(), 100U) << file;
        bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 4);
        std::ofstream(file, std::ios::binary) << bytes;
    }
};

TEST_F(ResumedFrames, HaveTheParticlesOfAKilledRun) {
    succeeded(frana(with_particles("whole")));
    StartedProgram program(folder_.string(), with_particles("result"));
    ASSERT_TRUE(program.wait_until([&] {
        return has_checkpoints("result", 2) &&
               app::CheckpointFile(checkpoints("result")[0]).head().frame_times.size() > 2;
    })) << program.wait().err;
    program.send(SIGKILL);
    program.wait();
    succeeded(frana(with_particles("result", {"--resume"})));
    expect_same_result("whole", "result");
    expect_same_particles("whole", "result");
}

TEST_F(ResumedFrames, HaveTheParticlesOfAStoppedRun) {
    succeeded(frana(with_particles("whole")));
    {
        StartedProgram program(folder_.string(), with_particles("result"));
        ASSERT_TRUE(program.wait_until([&] { return has_checkpoints("result", 2); })) << program.wait().err;
        program.send(SIGTERM);
        ASSERT_EQ(program.wait().exit_code, 128 + SIGTERM);
    }
    succeeded(frana(with_particles("result", {"--resume"})));
    expect_same_result("whole", "result");
    expect_same_particles("whole", "result");
}

TEST_F(ResumedFrames, MissingFilesAreReported) {
    StartedProgram program(folder_.string(), with_particles("result"));
    ASSERT_TRUE(program.wait_until([&] { return has_checkpoints("result", 2); })) << program.wait().err;
    program.send(SIGKILL);
    program.wait();
    const fs::path file = folder_of(checkpoints("result")[0]) / "frames/particles_0000.gpkg";
    fs::remove(file);
    refusal_of(frana(with_particles("result", {"--resume"})), {"needs a frame that is missing: " + file.string()});
}

// Otherwise everything would be computed, and the animation would fail at the end, each time
// again.
TEST_F(ResumedFrames, ThatAreDamagedAreReportedBeforeAnythingIsComputed) {
    interrupt("result");
    const fs::path file = folder_of(checkpoints("result")[0]) / "frames/velocity_0000.tif";
    damage(file);
    refusal_of(frana(run("result", {"--resume"})),
               {"needs a frame that is not as it was written: " + file.string(), "--overwrite"});
    EXPECT_EQ(checkpoints("result").size(), 2U);
}

TEST_F(ResumedFrames, DamagedOnesLoseNoMoreThanNecessary) {
    succeeded(frana(run("whole", {"--quiet"})));
    StartedProgram program(folder_.string(), run("result"));
    // Two checkpoints with different numbers of frames.
    ASSERT_TRUE(program.wait_until([&] {
        const auto found = checkpoints("result");
        if (found.size() < 2) return false;
        program.send(SIGSTOP);
        try {
            const std::size_t later = app::CheckpointFile(found[0]).head().frame_times.size();
            if (later > app::CheckpointFile(found[1]).head().frame_times.size()) return true;
        } catch (const Error&) {  // removed meanwhile
        }
        program.send(SIGCONT);
        return false;
    })) << program.wait().err;
    program.send(SIGKILL);
    program.wait();
    const std::string newest = checkpoints("result")[0];
    const std::size_t frames = app::CheckpointFile(newest).head().frame_times.size();
    damage(folder_of(newest) / ("frames/depth_000" + std::to_string(frames - 1) + ".tif"));
    const Outcome resumed = succeeded(frana(run("result", {"--resume"})));
    expect_words(resumed.err, {"checkpoint not used: " + newest + ": needs a frame", "resuming from"});
    expect_same_result("whole", "result");
}

}  // namespace
}  // namespace frana::test
