// SPDX-License-Identifier: Apache-2.0
#include "app/pictures/result_numbers.h"

#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>

#include "simulation/simulation.h"

namespace frana::app {
namespace {

// "Raise time.end" where run-out and area have long been final cries wolf: eleven of fourteen real scenes crept on.
TEST(RunEnd, TellsAFrontThatMovesFromADepositThatCreeps) {
    const std::string at_end = describe(StopReason::end_time);
    const std::string has_settled = describe(StopReason::settled);
    const RunEnd moves = run_end(at_end, 60, 3, 0.7, false, 0.4), creeps = run_end(at_end, 600, 0.3, 0.02, true, 0.01),
                 rests = run_end(at_end, 600, 0.01, 0.001, false, 0.001),
                 settled = run_end(has_settled, 300, 0.5, 0.1, true, 0.02);
    EXPECT_TRUE(moves.is_cut_short && !moves.creeps);
    EXPECT_TRUE(!creeps.is_cut_short && creeps.creeps);
    EXPECT_FALSE(rests.is_cut_short || rests.creeps);
    EXPECT_TRUE(!settled.is_cut_short && settled.creeps);
    EXPECT_TRUE(run_end(has_settled, 300, 0.5, 0.1, true, 0.06).is_cut_short) << "by a loose time.stop-change";
    // A seventh of the volume that moves behind a front at rest pushed it on 80 s later (S-1000, end = 120 and 200 s).
    EXPECT_TRUE(run_end(at_end, 120, 2, 0.17, true, 0.02).is_cut_short);
    // Whatever else stops a run stops a flow that moves as time.end does.
    for (const StopReason other : {StopReason::momentum, StopReason::requested, StopReason::settled})
        EXPECT_TRUE(run_end(describe(other), 60, 3, 0.7, false, 0.4).is_cut_short) << describe(other);
    for (const StopReason rest : {StopReason::still, StopReason::all_left})
        EXPECT_FALSE(run_end(describe(rest), 60, 3, 0.7, false, 0.4).is_cut_short) << describe(rest);
    EXPECT_EQ(creeping_sentence(creeps).text(), "run-out and area final; 2 % still moves, at 0.3 m/s");
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
    keys["material.density"] = "2000";
    EXPECT_EQ(scenario_words(facts, {}).find("(default)"), std::string::npos);
    facts.density_by_default = true;
    EXPECT_NE(scenario_words(facts, {}).find("density 2 000 kg/m\u00B3 (default)"), std::string::npos)
        << scenario_words(facts, {});
}

// What a page in another language is made of goes through summary.json unchanged, with its place and how far it
// matters.
TEST(Warnings, ComeBackFromASummaryInAnyLanguage) {
    const Warnings warnings{
        {worded("{1} m3 ({2} %) left the computed ground: use a larger DTM", {numeral("1 234.5"), numeral("12")}), true,
         Point{600000, 5000000}},
        worded("not released before the end: {1}", {worded("E {1}, N {2}", {std::string("2"), std::string("Süd\"")})}),
        worded("without values"),
        std::string("a text of another program")};
    const Json summary{{"warning_values", json_of(warnings)}};
    const Warnings back = warnings_in(Json::parse(summary.dump()));
    EXPECT_EQ(back, warnings);
    EXPECT_EQ(limits_of_use(back).size(), 1U);
    EXPECT_EQ(back[0].place.value_or(Point{}).x, 600000);
    EXPECT_FALSE(back[1].place);
    EXPECT_TRUE(warnings_in(Json::object()).empty());
    EXPECT_TRUE(warnings_in(Json::parse("{\"warning_values\": [1, {}, [], [[2]]]}")).front().words.text().empty());
    const Words german(Language::german);
    EXPECT_EQ(warning_line({}, german), "");
    EXPECT_EQ(warning_line({warnings[3]}, german), "Warnung: a text of another program");
    EXPECT_EQ(warning_line(warnings, german, 76), "Warnung: summary.json");
    const std::string line = warning_line(warnings, german), part = warning_line(warnings, german, 110);
    EXPECT_EQ(line.find("Warnung: 1.234,5 m"), 0U) << line;
    EXPECT_TRUE(line.ends_with("; a text of another program")) << line;
    EXPECT_NE(part.find("/4: 1.234,5 m"), std::string::npos) << part;
}

}  // namespace
}  // namespace frana::app
