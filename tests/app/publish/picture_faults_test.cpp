// SPDX-License-Identifier: Apache-2.0
// Pictures that cannot be drawn: what was computed is written all the same.
#include <cstdlib>

#include "result_scenes.h"

namespace frana::test {
namespace {

namespace fs = std::filesystem;

class PictureFaults : public ResultScenes {
  protected:
    /// Runs a command of which every picture fails between these calls for letters (support/picture_fault.cpp).
    [[nodiscard]] Outcome with_fault(long from, long to, const std::vector<std::string>& arguments) const {
        ::setenv("LD_PRELOAD", FRANA_PICTURE_FAULT, 1);
        ::setenv("FRANA_TEST_FAULT", (std::to_string(from) + "-" + std::to_string(to)).c_str(), 1);
        const Outcome outcome = frana(arguments);
        ::unsetenv("LD_PRELOAD");
        ::unsetenv("FRANA_TEST_FAULT");
        return outcome;
    }
    void expect_all_but_pictures(const std::string& result, const Outcome& outcome) const {
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        for (const char* file : {"max_depth.tif", "extent.gpkg", "timeseries.csv", "gauges.csv", "comparison.json",
                                 "summary.json", "report.html", "log.txt", "manifest.json"})
            EXPECT_TRUE(fs::exists(path(result + "/" + file))) << result << ": " << file;
        EXPECT_TRUE(fs::exists(path(result + "/frames"))) << result;
    }
    static constexpr long k_all = 1'000'000'000;
};

/// Every kind of picture of a run: maps, views, comparison, charts, those of the report, a film.
const std::string k_pictures =
    k_voellmy +
    "[output]\nframes = on\nmap-size = 640x480\nmap-formats = png, svg\nmaps = max_depth, max_velocity_3d, "
    "hazard\ngauges = gauge.geojson\ncross-sections = section.geojson\n[hazard]\nscheme = austrian-torrent\n"
    "[observed]\nperimeter = scar.geojson\n";

TEST_F(PictureFaults, LeaveEverythingElseOfARun) {
    if (k_sanitized) GTEST_SKIP() << "left out: a sanitizer must be loaded first";
    run(k_pictures, "whole");
    const std::vector<std::string> names{"maps/max_depth", "maps/max_velocity_3d", "maps/hazard", "comparison",
                                         "charts",         "animation.mp4"};
    const Outcome all = with_fault(1, k_all, {"run", "scene.ini", "--out", "none"});
    expect_all_but_pictures("none", all);
    for (const std::string& name : names) {
        EXPECT_NE(all.err.find(name + " could not be drawn: "), std::string::npos) << name << ": " << all.err;
        EXPECT_TRUE(json_lists(read_text(path("none/summary.json")), "warnings", name + " could not be drawn")) << name;
    }
    EXPECT_NE(read_text(path("none/report.html")).find("could not be drawn: planted fault"), std::string::npos);
    EXPECT_EQ(read_text(path("none/max_depth.tif")), read_text(path("whole/max_depth.tif")));
    succeeded(frana({"render", "none", "--map", "max_depth"}));
    EXPECT_TRUE(fs::exists(path("none/maps/max_depth.svg")));
    // A single fault, in one picture after the other until none is left.
    bool met = true;
    for (long call = 1; met; call = 6 * call + 1) {
        const std::string result = "at" + std::to_string(call);
        const Outcome outcome = with_fault(call, call, {"run", "scene.ini", "--out", result});
        expect_all_but_pictures(result, outcome);
        met = outcome.err.find("could not be drawn") != std::string::npos ||
              read_text(path(result + "/report.html")).find("could not be drawn") != std::string::npos;
    }
}

TEST_F(PictureFaults, LeaveEverythingElseOfAStudy) {
    if (k_sanitized) GTEST_SKIP() << "left out: a sanitizer must be loaded first";
    run(k_voellmy + "[output]\nmaps = off\nanimation = off\n", "whole");
    write("study.ini",
          "[study]\nscene = scene.ini\nsamples = 4\n[set]\noutput.maps = on\noutput.animation = on\noutput.map-size = "
          "640x480\n[vary]\nmaterial.friction-angle = uniform(12, 18)\n");
    succeeded(with_fault(1, k_all, {"ensemble", "study.ini", "--out", "study"}));
    EXPECT_NE(read_text(path("study/summary.json")).find("could not be drawn"), std::string::npos);
    for (const char* file : {"members.csv", "summary.json", "report.html", "manifest.json"})
        EXPECT_TRUE(fs::exists(path(std::string("study/") + file))) << file;
}

TEST_F(PictureFaults, LeaveTheTablesOfAConvergenceStudy) {
    if (k_sanitized) GTEST_SKIP() << "left out: a sanitizer must be loaded first";
    run(k_voellmy + "[output]\nmaps = off\nanimation = off\nreport = off\n", "whole");
    succeeded(with_fault(1, k_all, {"converge", "scene.ini", "--out", "study"}));
    for (const char* file : {"convergence.csv", "convergence.json", "uncertainty.tif"})
        EXPECT_TRUE(fs::exists(path(std::string("study/") + file))) << file;
}

TEST_F(PictureFaults, LongNamesOfManyGaugesAreShortened) {
    std::vector<TestFeature> gauges;
    for (int i = 0; i < 8; ++i)
        gauges.push_back({"Point", {{45 + i, 75}}, named("gauge_of_twenty_chars" + std::to_string(i))});
    write_features("gauge", gauges);
    run(k_voellmy + "[output]\nanimation = off\nmap-size = 640x480\ngauges = gauge.geojson\n", "out");
    EXPECT_TRUE(fs::exists(path("out/charts/gauges.png")));
    EXPECT_EQ(read_text(path("out/report.html")).find("could not be drawn"), std::string::npos);
}

TEST_F(PictureFaults, WithoutMapsTheComparisonIsNotDrawn) {
    run(k_voellmy + "[output]\nmaps = off\nanimation = off\nreport = off\n[observed]\nperimeter = scar.geojson\n",
        "out");
    EXPECT_TRUE(fs::exists(path("out/comparison.tif")));
    EXPECT_FALSE(fs::exists(path("out/comparison.png")));
}

}  // namespace
}  // namespace frana::test
