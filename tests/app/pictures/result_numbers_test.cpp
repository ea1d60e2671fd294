// SPDX-License-Identifier: Apache-2.0
#include "app/pictures/result_numbers.h"

#include <gtest/gtest.h>

#include <map>

#include "simulation/simulation.h"

namespace frana::app {
namespace {

// "Raise time.end" where run-out and area have long been final cries wolf: eleven of fourteen real scenes crept on.
TEST(RunEnd, TellsAFrontThatMovesFromADepositThatCreeps) {
    const std::string at_end = describe(StopReason::end_time);
    const RunEnd moves = run_end(at_end, 60, 3, 0.7, false), creeps = run_end(at_end, 600, 0.3, 0.02, true),
                 rests = run_end(at_end, 600, 0.01, 0.001, false),
                 settled = run_end(describe(StopReason::settled), 300, 0.5, 0.05, true);
    EXPECT_TRUE(moves.is_cut_short && !moves.creeps);
    EXPECT_TRUE(!creeps.is_cut_short && creeps.creeps);
    EXPECT_FALSE(rests.is_cut_short || rests.creeps);
    EXPECT_FALSE(settled.is_cut_short || settled.creeps);
    // A seventh of the volume that moves behind a front at rest pushed it on 80 s later (S-1000, end = 120 and 200 s).
    EXPECT_TRUE(run_end(at_end, 120, 2, 0.17, true).is_cut_short);
    EXPECT_NE(creeping_sentence(creeps).text().find("0.3 m/s"), std::string::npos);
}

// "Off" is no value that differs from place to place.
TEST(ScenarioWords, TellTurbulenceThatIsOffFromTurbulenceByPlace) {
    std::map<std::string, std::string> keys{{"material.model", "voellmy-bingham"},
                                            {"release.thickness", "2"},
                                            {"material.friction-angle", "12"},
                                            {"material.turbulence", "off"}};
    ScenarioFacts facts;
    facts.value = [&](const std::string& key) {
        return keys.contains(key) ? std::optional(keys.at(key)) : std::nullopt;
    };
    EXPECT_NE(scenario_words(facts, {}).find("no turbulence"), std::string::npos);
    EXPECT_EQ(scenario_words(facts, {}).find("by place"), std::string::npos);
    keys["zones.turbulence"] = "raster:xi.tif";
    EXPECT_NE(scenario_words(facts, {}).find("turbulence by place"), std::string::npos);
}

}  // namespace
}  // namespace frana::app
