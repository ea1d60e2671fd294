// SPDX-License-Identifier: Apache-2.0
// Signals and problems after the last step, while files and pictures are made; and results that --resume completes.
#include <chrono>
#include <csignal>
#include <thread>

#include "resuming.h"

namespace frana::test {
namespace {

namespace fs = std::filesystem;

class Late : public Resuming {
  protected:
    void SetUp() override {
        write_scene(
            "frame-interval = 0.2\n[output]\nmap-size = 640x480\nmaps = max_depth, max_velocity, final_depth\n" +
            k_one_day + "animation = on\nreport = on\n[terrain]\ncell-size = 4\n");
    }
    [[nodiscard]] static std::vector<std::string> command(const std::string& result,
                                                          const std::vector<std::string>& more = {}) {
        return with_more({"run", "scene.ini", "--out", result}, more);
    }
    // Whether a file exists in the folder in which a result is being built.
    [[nodiscard]] bool has_begun(const std::string& result, const std::string& file) const {
        return fs::exists(path(result + ".partial/" + file));
    }
    // Sends signals once a file exists.
    Outcome stop_at(const std::string& result, const std::string& file, const std::vector<int>& signals,
                    const std::vector<std::string>& more = {}) const {
        StartedProgram program(folder_.string(), command(result, more));
        EXPECT_TRUE(program.wait_until([&] { return has_begun(result, file); })) << program.wait().err;
        for (const int number : signals) {
            if (signals.size() > 1) std::this_thread::sleep_for(k_apart);
            program.send(number);
        }
        return program.wait();
    }
    // Of two signals: the next picture has begun, and both are not taken for one.
    static constexpr std::chrono::milliseconds k_apart{200};
    void expect_completed(const std::string& result, std::vector<std::string> more = {}) const {
        more.emplace_back("--resume");
        succeeded(frana(command(result, more)));
        expect_same_result("whole", result);
        expect_tidy(result);
    }
};

TEST_F(Late, SignalLeavesOutPicturesWhichResumingDraws) {
    succeeded(frana(command("whole", {"--quiet"})));
    const Outcome outcome = stop_at("result", "max_depth.tif", {SIGTERM});
    EXPECT_EQ(outcome.exit_code, 128 + SIGTERM) << outcome.err;
    EXPECT_NE(outcome.err.find("left out because of the signal"), std::string::npos) << outcome.err;
    // All numbers are written, and the data needed to draw the rest.
    const std::string summary = read_text(path("result/summary.json"));
    EXPECT_NE(json_text(summary, "stop_reason"), "requested");
    EXPECT_TRUE(json_lists(summary, "warnings", "left out because of the signal")) << summary;
    EXPECT_EQ(read_text(path("result/max_depth.tif")), read_text(path("whole/max_depth.tif")));
    EXPECT_EQ(checkpoints("result").size(), 1U);
    expect_completed("result");
}

TEST_F(Late, SecondSignalEndsAtOnceAndResumingCompletes) {
    // So large that drawing one takes much longer than both intervals.
    const std::vector<std::string> large{"--quiet",
                                         "--set",
                                         "output.map-size=5000x3750",
                                         "--set",
                                         "output.maps=max_depth,max_velocity",
                                         "--set",
                                         "output.charts=off",
                                         "--set",
                                         "output.animation=off",
                                         "--set",
                                         "output.report=off"};
    succeeded(frana(command("whole", large)));
    const Outcome outcome = stop_at("result", "maps/max_depth.png", {SIGINT, SIGTERM}, large);
    EXPECT_EQ(outcome.exit_code, -SIGTERM) << outcome.err;
    expect_completed("result", large);
}

// It is told of, and drawn by the next command that can.
TEST_F(Late, ErrorOfAPictureLeavesAResult) {
    write("photo.bil", std::string(400, '\x80'));
    write("photo.hdr", "NROWS 20\nNCOLS 20\nNBITS 8\nULXMAP 527005\nULYMAP 5094145\nXDIM 10\nYDIM 10\n");
    fs::copy_file(path("dtm.prj"), path("photo.prj"));
    const std::vector<std::string> photo{"--set", "output.map-background=photo.bil", "--set", "output.animation=off"};
    succeeded(frana(command("whole", photo)));
    StartedProgram program(folder_.string(), command("result", photo));
    ASSERT_TRUE(program.wait_until([&] { return has_begun("result", "frames/depth_0001.tif"); }));
    fs::rename(path("photo.bil"), path("elsewhere.bil"));
    const Outcome outcome = succeeded(program.wait());
    EXPECT_NE(outcome.err.find("maps/max_depth could not be drawn"), std::string::npos) << outcome.err;
    EXPECT_TRUE(fs::exists(path("result/max_depth.tif")) && !fs::exists(path("result/maps/max_depth.png")));
    fs::rename(path("elsewhere.bil"), path("photo.bil"));
    succeeded(frana({"render", "result", "--map", "max_depth"}));
    EXPECT_TRUE(fs::exists(path("result/maps/max_depth.png")));
}

TEST_F(Late, ResumingACompleteResultComputesNothing) {
    succeeded(frana(command("result", {"--quiet"})));
    const Outcome complete = succeeded(frana(command("result", {"--resume"})));
    EXPECT_NE(complete.err.find("the result is complete"), std::string::npos) << complete.err;
    const auto refused = [&](const std::string& words, const std::vector<std::string>& more = {"--resume"}) {
        refusal_of(frana(command("result", more)), {words});
    };
    // Files that are damaged or gone are named, pictures and styles aside.
    for (const std::string name : {"timeseries.csv", "max_pressure.tif", "profiles.csv"}) {
        const std::string before = read_text(path("result/" + name));
        write("result/" + name, before.substr(0, before.size() / 2));
        refused("missing or not as the run wrote them: " + name);
        fs::remove(path("result/" + name));
        refused("missing or not as the run wrote them: " + name);
        write("result/" + name, before);
    }
    write("result/max_depth.qml", "of the user's own");
    fs::remove(path("result/maps/max_velocity.png"));
    succeeded(frana(command("result", {"--resume"})));
    refused("contains the finished result of another scene: time.end is 3 here and was 4",
            {"--resume", "--set", "time.end=3"});
    write_dtm([](int, int column) { return 301 - 2.5 * column; });
    refused("of another scene: the content of DTM differs");
    fs::remove(path("result/manifest.json"));
    refused("is a folder with other files, not a result");
}

}  // namespace
}  // namespace frana::test
