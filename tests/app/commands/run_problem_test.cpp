// SPDX-License-Identifier: Apache-2.0
// A run with a problem reports where and when, on the terminal and in the files, and keeps its state.
#include <nlohmann/json.hpp>

#include "support/tiny_scene.h"

namespace frana::test {
namespace {

namespace fs = std::filesystem;

using FailingRun = TinyScene;

TEST_F(FailingRun, NamesPlaceStepAndTimeEverywhere) {
    write_dtm([](int, int column) { return column == 16 ? -9999.0 : 300 - 2.5 * column; });
    write_scene("frame-interval = 1\n[output]\nmaps = off\nanimation = off\nreport = off\nframes = on\n");
    const Outcome outcome = frana({"run", "scene.ini", "--out", "result"});
    EXPECT_EQ(outcome.exit_code, 3) << outcome.err;
    const std::string summary = read_text(path("result/summary.json")), log = read_text(path("result/log.txt"));
    // Column 16 begins 80 m east of the DTM's corner; the flow comes from the west.
    for (const std::string& text : {outcome.err, summary, log}) {
        expect_words(text, {"the flow reached ground without elevation", ", at (52708", "step "});
    }
    EXPECT_EQ(json_text(summary, "stop_reason"), "reached-no-data");
    EXPECT_EQ(json_value(summary, "problems").size(), 1U);
    EXPECT_TRUE(fs::exists(path("result/frames/depth_0001.tif"))) << "the last frame";
    EXPECT_FALSE(fs::is_empty(path("result/checkpoint"))) << "the state at that step";
}

// An exit code other than 0 is explained, also with --quiet.
TEST_F(FailingRun, ReportsItsProblemAlsoWithQuiet) {
    write_dtm([](int, int column) { return column == 16 ? -9999.0 : 300 - 2.5 * column; });
    write_scene(k_numbers_only);
    const Outcome outcome = frana({"run", "scene.ini", "--out", "result", "--quiet"});
    EXPECT_EQ(outcome.exit_code, 3);
    EXPECT_NE(outcome.err.find("the flow reached ground without elevation"), std::string::npos) << outcome.err;
    write_dtm();
    const Outcome good = ran("good");
    EXPECT_EQ(good.err, "");
}

TEST_F(FailingRun, AGoodRunHasNone) {
    write_scene(k_numbers_only);
    ran();
    const std::string summary = read_text(path("result/summary.json"));
    EXPECT_EQ(json_value(summary, "problems"), Json::array());
    for (const char* count : {"non_finite", "entered_no_data", "impossible_speed", "volume_drift", "depth_clamped"})
        EXPECT_EQ(json_value(summary, count), 0) << count;
}

using MemoryLimit = TinyScene;

TEST_F(MemoryLimit, RefusesBeforeTheStartInRunAndCheck) {
    write_scene(k_numbers_only);
    const auto before = files();
    for (const char* command : {"run", "check"}) {
        refusal_of(frana({command, "scene.ini", "--memory-limit", "1MB"}), {"1 MB", "of memory"});
    }
    EXPECT_EQ(files(), before);
    succeeded(frana({"check", "scene.ini", "--memory-limit", "4GB"}));
}

TEST_F(MemoryLimit, ManyParticlesAreARefusal) {
    write_scene(k_numbers_only);
    refusal_of(frana({"check", "scene.ini", "--memory-limit", "20MB", "--set", "terrain.cell-size=1", "--set",
                      "numerics.particles-per-cell=16"}),
               {"--memory-limit"});
}

// Paths with spaces and other characters.
using OddPaths = TinyScene;

TEST_F(OddPaths, SpacesAccentsLengthAndLinks) {
    write_scene(k_numbers_only);
    // SQLite, which GeoPackages are, opens paths of up to 512 characters.
    std::string deep = "Frana è qui — 山";
    for (int i = 0; i < 8; ++i) deep += "/a folder with a long name, number " + std::to_string(i);
    fs::create_directories(path(deep));
    for (const char* name : {"scene.ini", "dtm.asc", "dtm.prj", "perimeter.geojson"})
        fs::copy(path(name), path(deep + "/" + name));
    succeeded(frana({"run", deep + "/scene.ini", "--out", deep + "/résultat 1", "--quiet"}));
    EXPECT_TRUE(fs::exists(path(deep + "/résultat 1/summary.json")));
    // The scene through a link to its folder.
    fs::create_directories(path("links"));
    fs::create_directory_symlink(path(deep), path("links/way"));
    const Outcome linked = succeeded(frana({"run", "links/way/scene.ini", "--out", "linked", "--quiet"}));
    EXPECT_EQ(read_text(path("linked/timeseries.csv")), read_text(path(deep + "/résultat 1/timeseries.csv")));
    const Outcome too_long = refusal_of(frana({"run", "scene.ini", "--out", std::string(300, 'x'),
                                               "--quiet"}));  // wrong input, found before anything is computed
    EXPECT_NE(too_long.err.find("--out"), std::string::npos) << too_long.err;
}

}  // namespace
}  // namespace frana::test
