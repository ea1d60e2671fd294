// SPDX-License-Identifier: Apache-2.0
// Pictures of an unfinished run, drawn while it continues.
#include <csignal>
#include <fstream>
#include <memory>
#include <regex>

#include "started_program.h"
#include "support/tiny_scene.h"

namespace frana::test {
namespace {

namespace fs = std::filesystem;

class UnderWay : public TinyScene {
  protected:
    UnderWay() {
        write_scene(
            "stop-when-still = off\nstop-change = 0\nframe-interval = 0.05\n[numerics]\nparticles-per-cell = "
            "16\n[output]\n"
            "maps = off\nanimation = off\n[terrain]\ncell-size = 1\n");
        run_ = std::make_unique<StartedProgram>(
            folder_.string(), std::vector<std::string>{"run", "scene.ini", "--out", "result", "--set", "time.end=400"});
    }
    /// The folder in which the result is being built; empty if there is none yet.
    [[nodiscard]] fs::path building() const {
        return fs::exists(path("result.partial")) ? fs::path(path("result.partial")) : fs::path();
    }
    [[nodiscard]] int frames() const {
        std::ifstream file(building() / "frames/frames.csv");
        int lines = 0;
        for (std::string line; std::getline(file, line);) ++lines;
        return lines - 1;
    }

    std::unique_ptr<StartedProgram> run_;
};

TEST_F(UnderWay, AnimationsAndMapsShowTheFramesSoFar) {
    ASSERT_TRUE(run_->wait_until([&] { return frames() >= 3; })) << run_->wait().err;
    run_->send(SIGSTOP);  // to draw a fixed state
    const Outcome animation = frana({"render", "result", "--animation", "film/", "--size", "640x480"});
    ASSERT_EQ(animation.exit_code, 0) << animation.err;
    EXPECT_TRUE(fs::exists(path("film/frame_0002.png")));
    const Outcome view = frana({"render", "result", "--animation", "view.mp4", "--view", "3d", "--size", "640x480"});
    EXPECT_EQ(view.exit_code, 0) << view.err;
    const Outcome map = frana({"render", "result", "--map", "depth@0.1", "--map", "velocity@0.1", "--out", "maps"});
    ASSERT_EQ(map.exit_code, 0) << map.err;
    // Named after the frame's true time: the first step that reached one of 0, 0.05, 0.1 ... s.
    EXPECT_TRUE(std::regex_match(map.out, std::regex("maps/depth_t(0\\.[0-9]+)\\.png\nmaps/velocity_t\\1\\.png\n")))
        << map.out;

    // Requests for values known only at the end are refused, and nothing is written to the run's folder.
    const std::vector<std::vector<std::string>> refused{{"render", "result"},
                                                        {"render", "result", "--map", "depth@0.1"},
                                                        {"render", "result", "--charts", "--out", "charts"},
                                                        {"render", "result", "--map", "max_depth", "--out", "maps"}};
    for (const auto& arguments : refused) EXPECT_EQ(frana(arguments).exit_code, 2) << arguments.back();
    EXPECT_NE(frana(refused[0]).err.find("under way"), std::string::npos);
    EXPECT_FALSE(fs::exists(building() / "maps"));
    EXPECT_FALSE(fs::exists(path("result")));
}

TEST_F(UnderWay, FramesOfAKilledRunCanBeDrawn) {
    ASSERT_TRUE(run_->wait_until([&] { return frames() >= 2; })) << run_->wait().err;
    run_->send(SIGKILL);
    run_->wait();
    const Outcome animation = frana({"render", "result", "--animation", "film.gif", "--size", "640x480"});
    EXPECT_EQ(animation.exit_code, 0) << animation.err;
}

}  // namespace
}  // namespace frana::test
