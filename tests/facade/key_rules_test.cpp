// SPDX-License-Identifier: Apache-2.0
// Every key of scene files is taken by a scene in memory, or refused because it concerns files: in the program's words.
#include "facade/inside.h"

#include <gtest/gtest.h>

#include <set>

#include "params/keys/scene_parameters.h"

namespace frana::facade {
namespace {

TEST(KeyRules, TakeEveryKeyOfTheEngine) {
    const std::set<std::string> engine{"material", "structured", "entrainment", "time", "numerics"};
    int taken = 0;
    for (const Parameter& parameter : scene_parameters()) {
        std::string value = parameter.default_text();
        if (value.empty()) value = parameter.type == "number" && parameter.fits && parameter.fits(0.5) ? "0.5" : "";
        if (value.empty()) continue;
        const auto problem = problem_of_setting(parameter.name(), value);
        if (engine.count(parameter.section) == 0 || parameter.name() == "numerics.accuracy") continue;
        ++taken;
        EXPECT_FALSE(problem) << parameter.name() << ": " << problem->what;
    }
    EXPECT_GT(taken, 60);
}

TEST(KeyRules, RefuseWhatConcernsFiles) {
    for (const auto& [key, value] : {std::pair{"terrain.dtm", "dtm.tif"},
                                     {"terrain.cell-size", "5"},
                                     {"release.perimeter", "release.shp"},
                                     {"release.thickness", "3"},
                                     {"output.maps", "off"},
                                     {"output.gauges", "gauges.gpkg"},
                                     {"inflow.line", "line.gpkg"},
                                     {"inflow.direction", "90"},
                                     {"observed.perimeter", "scar.shp"},
                                     {"numerics.accuracy", "5"},
                                     {"structured.zones", "zones.gpkg"},
                                     {"structured.cohesion", "raster:cohesion.tif"},
                                     {"zones.friction-angle", "raster:angle.tif"},
                                     {"terrain.nodata-policy", "fill"}}) {
        const auto problem = problem_of_setting(key, value);
        ASSERT_TRUE(problem) << key;
        EXPECT_EQ(problem->where, key);
        EXPECT_FALSE(problem->remedy.empty()) << key;
    }
    EXPECT_FALSE(problem_of_setting("terrain.nodata-policy", "wall"));
    EXPECT_FALSE(problem_of_setting("structured.cohesion", "20000"));
    EXPECT_FALSE(problem_of_setting("output.sample-interval", "5"));
}

TEST(KeyRules, RefuseInTheProgramsWords) {
    const auto range = problem_of_setting("material.friction-coefficient", "32");
    ASSERT_TRUE(range);
    EXPECT_TRUE(range->where.text.ends_with("material.friction-coefficient"));
    EXPECT_EQ(range->value, "32");
    EXPECT_FALSE(range->limit.empty());
    const auto name = problem_of_setting("material.friction-koefficient", "0.2");
    ASSERT_TRUE(name);
    EXPECT_TRUE(name->where.text.ends_with("material.friction-koefficient"));
    EXPECT_EQ(name->remedy, "Did you mean material.friction-coefficient?");
    const auto word = problem_of_setting("material.friction-coefficient", "0,2"),
               none = problem_of_setting("material.friction-coefficient", "");
    ASSERT_TRUE(word && none);
    EXPECT_EQ(word->value, "0,2");
    EXPECT_EQ(none->value, "");
}

}  // namespace
}  // namespace frana::facade
