// SPDX-License-Identifier: Apache-2.0
// Invalid zones, obstacles, release and inflow: one clear message each, nothing written.
#include <algorithm>

#include "support/tiny_scene.h"

namespace frana::test {
namespace {

struct SiteProblem {
    std::string name;
    std::string lines;  ///< after the tiny scene's own
    std::vector<std::string> messages;
    std::string set{};  ///< a key that the tiny scene already has
};

void PrintTo(const SiteProblem& tested, std::ostream* out) {
    *out << tested.name;
}

class BadSite : public TinyScene, public ::testing::WithParamInterface<SiteProblem> {};

TEST_P(BadSite, IsRefusedInOneMessageWithNothingWritten) {
    const std::string inflow =
        R"({"type":"FeatureCollection","crs":{"type":"name","properties":{"name":"urn:ogc:def:crs:EPSG::32632"}},)"
        R"("features":[{"type":"Feature","properties":{},"geometry":{"type":"LineString","coordinates":)";
    write("line.geojson", inflow + "[[527030,5094060],[527030,5094090]]}}]}");
    write("far_line.geojson", inflow + "[[527030,5094060],[527030,5094990]]}}]}");
    write_dtm([](int, int) { return 1.0; }, true, "one.asc");
    write_dtm([](int, int) { return -0.5; }, true, "hole.asc");
    write_dtm([](int, int) { return 9999.0; }, true, "high.asc");
    write("good.csv", "time,discharge,velocity\n0,10,2\n5,10,2\n");
    write("back.csv", "time,discharge,velocity\n0,10,2\n5,10,2\n4,10,2\n");
    write("words.csv", "time,discharge,velocity\n0,10,2\n5,ten,2\n");
    write("still.csv", "time,discharge,velocity\n0,10,0\n5,10,0\n");
    write("shrink.csv", "time,volume\n0,10\n5,8\n");
    write_polygon("zone", {{100, 10}, {200, 10}, {200, 140}, {100, 140}});
    write_polygon("half", {{100, 10}, {400, 10}, {400, 140}, {100, 140}});
    write_polygon("house", {{30, 60}, {50, 60}, {50, 80}, {30, 80}});
    write_scene(GetParam().lines);
    const std::vector<std::string> before = files();
    for (const std::string command : {"run", "check"}) {
        std::vector<std::string> arguments{command, "scene.ini"};
        if (!GetParam().set.empty()) arguments.insert(arguments.end(), {"--set", GetParam().set});
        const Outcome outcome = frana(arguments);
        EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
        EXPECT_EQ(outcome.out, "");
        for (const std::string& words : GetParam().messages)
            EXPECT_NE(outcome.err.find(words), std::string::npos) << "no \"" << words << "\" in: " << outcome.err;
        EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    }
    EXPECT_EQ(files(), before);
}

const std::string k_inflow = "[inflow]\nline = line.geojson\nhydrograph = ";

INSTANTIATE_TEST_SUITE_P(
    Scenes, BadSite,
    ::testing::Values(
        SiteProblem{"zone_attribute_missing",
                    "[terrain]\nfriction-zones = zone.geojson\n[zones]\nfriction-angle = attribute:PHI\n",
                    {"zones.friction-angle", "no number in the attribute PHI", "depth"}},
        SiteProblem{"zone_columns_unknown",
                    "[terrain]\nfriction-zones = zone.geojson\n",
                    {"terrain.friction-zones", "no column", "depth", "friction_angle"}},
        SiteProblem{"zone_layer_partly_outside",
                    "[terrain]\nfriction-zones = half.geojson\n[zones]\nfriction-angle = attribute:depth\n",
                    {"terrain.friction-zones", "reaches beyond the DTM", "527400"}},
        SiteProblem{"zone_value_out_of_range",
                    "[zones]\nfriction-angle = raster:dtm.asc\n",
                    {"zones.friction-angle", "least value", "out of range", "0, or 1 to 60"}},
        SiteProblem{"erodible_layer_below_zero",
                    "[entrainment]\nerosion = growth\ngrowth-rate = 0.01\n[zones]\nerodible-depth = raster:hole.asc\n",
                    {"zones.erodible-depth", "least value", "-0.5", "out of range"}},
        SiteProblem{"zone_column_without_layer",
                    "[zones]\nturbulence = attribute:xi\n",
                    {"zones.turbulence", "needs terrain.friction-zones"}},
        SiteProblem{"zone_friction_twice",
                    "[zones]\nfriction-angle = raster:one.asc\nfriction-coefficient = raster:one.asc\n",
                    {"contradicts zones.friction-coefficient"}},
        SiteProblem{"zone_not_used",
                    "[terrain]\nfriction-zones = zone.geojson\n[zones]\ncohesion = attribute:depth\n",
                    {"cohesion", "do not use"}},
        SiteProblem{"friction_table_unknown",
                    "",
                    {"material.friction-table", "is not a friction table", "ramms-avalanche"},
                    "material.friction-table=swiss"},
        SiteProblem{"friction_table_of_another_period",
                    "[material]\nreturn-period = 150\n",
                    {"material.return-period", "not in the friction table", "10, 30, 100, 300 years"},
                    "material.friction-table=ramms-avalanche"},
        SiteProblem{"obstacle_without_height",
                    "[terrain]\nobstacles = zone.geojson\n",
                    {"terrain.obstacles", "needs terrain.obstacle-height"}},
        SiteProblem{"obstacle_partly_outside",
                    "[terrain]\nobstacles = half.geojson\nobstacle-height = 3\n",
                    {"terrain.obstacles", "reaches beyond the DTM"}},
        SiteProblem{
            "wall_on_the_release", "[terrain]\nwalls = house.geojson\n", {"terrain.walls", "stands on the release"}},
        SiteProblem{"slip_surface_above_the_dtm",
                    "[release]\nslip-depth = 5\n",
                    {"release.dtm-contains-release", "slip-surface", "Set it to on"},
                    "release.thickness=slip-surface"},
        SiteProblem{"thicker_than_any_landslide",
                    "",
                    {"release.thickness", "thicker than any landslide", "at most 2000 m"},
                    "release.thickness=1e308"},
        SiteProblem{"elevations_for_thicknesses",
                    "",
                    {"release.thickness", "thicker than any landslide", "9999"},
                    "release.thickness=raster:high.asc"},
        SiteProblem{"volume_that_no_outline_holds",
                    "[release]\nvolume = 1e12\n",
                    {"release.volume", "thicker than any landslide"}},
        SiteProblem{"more_cells_than_memory",
                    "",
                    {"terrain.cell-size", "450 000 000 cells", "0.01 m"},
                    "terrain.cell-size=0.01"},
        SiteProblem{"slip_surface_without_depth",
                    "[release]\ndtm-contains-release = on\n",
                    {"needs its depth", "release.slip-depth"},
                    "release.thickness=slip-surface"},
        SiteProblem{"slip_depth_and_volume",
                    "[release]\ndtm-contains-release = on\nslip-depth = 3\nvolume = 900\n",
                    {"release.slip-depth", "contradicts release.volume"},
                    "release.thickness=slip-surface"},
        SiteProblem{"difference_measured_normal",
                    "[release]\nthickness-direction = normal\ndtm-contains-release = on\n",
                    {"release.thickness-direction", "vertical"},
                    "release.thickness=difference:dtm.asc,one.asc"},
        SiteProblem{"start_attribute_missing",
                    "[release]\nstart = attribute:when\n",
                    {"release.start", "no number in the attribute when"}},
        SiteProblem{"direction_without_velocity",
                    "[release]\ndirection = 90\n",
                    {"release.direction", "needs release.velocity"}},
        SiteProblem{
            "line_without_hydrograph", "[inflow]\nline = line.geojson\n", {"inflow.line", "needs inflow.hydrograph"}},
        SiteProblem{"hydrograph_goes_back_in_time",
                    k_inflow + "back.csv\n",
                    {"back.csv", "line 4: the times do not rise", "4 s", "after 5 s"}},
        SiteProblem{"hydrograph_with_words", k_inflow + "words.csv\n", {"words.csv", "line 3", "discharge", "ten"}},
        SiteProblem{
            "hydrograph_that_stands_still", k_inflow + "still.csv\n", {"still.csv", "discharge without velocity"}},
        SiteProblem{"hydrograph_that_shrinks", k_inflow + "shrink.csv\n", {"shrink.csv", "line 3: the volume falls"}},
        SiteProblem{"hydrograph_missing", k_inflow + "none.csv\n", {"none.csv", "does not exist"}},
        SiteProblem{"line_partly_outside",
                    "[inflow]\nline = far_line.geojson\nhydrograph = good.csv\n",
                    {"inflow.line", "reaches beyond the DTM"}},
        SiteProblem{"line_is_an_area",
                    "[inflow]\nline = zone.geojson\nhydrograph = good.csv\n",
                    {"zone.geojson", "is not a line"}}),
    [](const auto& test) { return test.param.name; });

/// Both columns are missing: both are reported.
TEST_F(TinyScene, AHydrographWithoutItsColumnsIsReportedAtOnce) {
    write("line.geojson", R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{},)"
                          R"("geometry":{"type":"LineString","coordinates":[[9.35,46.0],[9.3501,46.0]]}}]})");
    write("heads.csv", "t,q\n0,10\n5,10\n");
    write_scene(k_inflow + "heads.csv\n");
    const Outcome outcome = frana({"check", "scene.ini"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.err.find("no column time"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("neither a column discharge nor volume"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace frana::test
