// SPDX-License-Identifier: Apache-2.0
#include <sstream>

#include "support/tiny_scene.h"

namespace frana::test {
namespace {

/// The worked examples of share/scenes and the sample remain valid: `frana check` accepts them.
class Example : public TinyScene, public ::testing::WithParamInterface<std::pair<const char*, const char*>> {};

TEST_P(Example, IsReadyToRun) {
    const auto [scene, data] = GetParam();
    const std::string needed = std::string(FRANA_SHARED_DIR) + "/data/" + data;
    if (!std::filesystem::exists(needed)) GTEST_SKIP() << "the event's data are not at " << needed;
    const Outcome outcome = succeeded(frana({"check", std::string(FRANA_SOURCE_DIR) + "/share/scenes/" + scene}));
    EXPECT_NE(outcome.out.find("ready to run"), std::string::npos);
}

TEST_P(Example, LeadsFromTheRawFilesToTheReportInAtMostFifteenLines) {
    const auto [scene, data] = GetParam();
    const std::string file = std::string(FRANA_SOURCE_DIR) + "/share/scenes/" + scene;
    std::istringstream text(read_text(file));
    int lines = 0;
    for (std::string line; std::getline(text, line);) lines += !line.empty() && line[0] != '#';
    EXPECT_LE(lines, 15) << scene;
    if (!std::filesystem::exists(std::string(FRANA_SHARED_DIR) + "/data/" + data))
        GTEST_SKIP() << "the event's data are not at " << FRANA_SHARED_DIR << "/data/" << data;
    // A second of the flow; the whole runs are in share/doc/validation.md.
    succeeded(
        frana({"run", file, "--out", "result", "--quiet", "--set", "time.end=1", "--set", "output.maps=max_depth",
               "--set", "output.animation=off", "--set", "output.frames=off", "--set", "output.map-size=800x600"}));
    const std::string page = read_text(path("result/report.html"));
    expect_words(page, {"</html>", "src=\"data:image/"});
}

INSTANTIATE_TEST_SUITE_P(Scenes, Example,
                         ::testing::Values(std::pair{"wa_s1000.ini", "wa_s1000_2021"},
                                           std::pair{"realtopo.ini", "iseesnow"},
                                           std::pair{"colima.ini", "colima_titan2d"},
                                           std::pair{"lavangsdalen.ini", "lavangsdalen"},
                                           std::pair{"massmov2d.ini", "massmov2d_sample"}),
                         [](const auto& tested) {
                             const std::string name = tested.param.first;
                             return name.substr(0, name.find('.'));
                         });

using Sample = TinyScene;

TEST_F(Sample, BindoIsReadyToRun) {
    const Outcome outcome = succeeded(frana({"check", FRANA_SOURCE_DIR "/sample_data/bindo/scene.ini"}));
    expect_words(outcome.out, {"EPSG:32632", "EPSG:4326", "EPSG:3003"});
}

}  // namespace
}  // namespace frana::test
