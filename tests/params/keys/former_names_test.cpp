// SPDX-License-Identifier: Apache-2.0
#include "params/keys/parameter.h"

#include <algorithm>
#include <fstream>
#include <iterator>

#include "params/keys/scene_parameters.h"
#include "scene_fixture.h"

namespace frana {
namespace {

TEST(FormerNames, AreMappedToKeysAndAreNoKeysThemselves) {
    const std::vector<std::string> keys = names_of(scene_parameters());
    const auto is_key = [&](const std::string& name) {
        return std::find(keys.begin(), keys.end(), name) != keys.end();
    };
    for (const FormerName& name : former_names()) {
        EXPECT_TRUE(is_key(name.now)) << name.now;
        EXPECT_FALSE(is_key(name.former)) << name.former;
    }
}

TEST(FormerNames, AreInTheChangelogsTable) {
    std::ifstream file(FRANA_SOURCE_SHARE "/../CHANGELOG.md");
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    for (const FormerName& name : former_names()) {
        if (name.stays) continue;
        EXPECT_NE(text.find("| `" + std::string(name.former) + "` | `" + name.now + "` |"), std::string::npos)
            << name.former;
    }
}

class FormerNamesInScenes : public SceneFixture {};

TEST_F(FormerNamesInScenes, AreReadWithAWarning) {
    const SceneReading reading = read(k_least + "[time]\nstop-energy-share = 0.1\n", {"time.stop-moving-share=0.2"});
    EXPECT_TRUE(reading.problems.empty());
    EXPECT_EQ(reading.scene.time.stop_energy_fraction, 0.1);
    EXPECT_EQ(reading.scene.time.stop_moving_fraction, 0.2);
    ASSERT_EQ(reading.warnings.size(), 2U);
    EXPECT_NE(reading.warnings[0].text().find("time.stop-energy-share is now called time.stop-energy-fraction"),
              std::string::npos);
    EXPECT_NE(reading.warnings[1].text().find("--set time.stop-moving-share"), std::string::npos);
}

TEST_F(FormerNamesInScenes, BesideThePresentOneAreGivenTwice) {
    EXPECT_TRUE(has_problem(problems(k_least + "[time]\nstop-energy-share = 0.1\nstop-energy-fraction = 0.2\n"),
                            "time.stop-energy-fraction", "0.2"));
}

}  // namespace
}  // namespace frana
