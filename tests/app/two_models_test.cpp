// SPDX-License-Identifier: Apache-2.0
// The sample hillside with both models, on coarse cells: the scenes behind the table in sample_data/README.md.
#include <cstring>
#include <map>

#include "gis/raster/raster_in.h"
#include "support/tiny_scene.h"

namespace frana::test {
namespace {

class BothModels : public TinyScene {
  protected:
    /// summary.json of a scene of the sample on cells of 40 m.
    [[nodiscard]] std::string summary(const std::string& scene, const std::vector<std::string>& changes = {},
                                      const std::string& frames = "off") const {
        std::vector<std::string> arguments{"run", FRANA_SOURCE_DIR "/sample_data/bindo/" + scene, "--out", "result",
                                           "--overwrite"};
        const std::vector<std::string> set = with_more(
            {"terrain.cell-size=40", "output.maps=off", "output.animation=off", "output.frames=" + frames}, changes);
        for (const std::string& one : set) {
            arguments.emplace_back("--set");
            arguments.push_back(one);
        }
        succeeded(frana(arguments));
        return read_text(path("result/summary.json"));
    }
};

TEST_F(BothModels, AgreeWhereTheirEquationsDoAndDifferWithCohesion) {
    const auto of_cohesion = [&](const std::string& cohesion) {
        return summary("structured.ini", {"structured.cohesion=" + cohesion, "structured.solid-fraction=1"});
    };
    const std::string loose = of_cohesion("0");
    const double volume = json_number(loose, "initial_m3"), covered = json_number(loose, "covered_area_m2");
    // Without cohesion and water the structured model's equations are those of the first with Coulomb friction alone:
    // only the solution methods differ. On 10 m cells extents differ by 2 % and run-outs by 7 m; here a cell's diagonal
    // is allowed.
    const std::string friction = summary("coulomb.ini");
    const double extent = json_number(friction, "covered_area_m2"), run_out = json_number(friction, "horizontal_m");
    EXPECT_GT(run_out, 900);
    EXPECT_NEAR(covered, extent, 0.1 * extent);
    EXPECT_NEAR(json_number(loose, "horizontal_m"), run_out, 57);
    EXPECT_NEAR(volume, json_number(friction, "initial_m3"), 1);
    // One pascal is nearly no cohesion: the limit on a hillside; on 10 m cells extents differ by 0.4 %.
    EXPECT_NEAR(json_number(of_cohesion("1"), "covered_area_m2"), covered, 0.1 * covered);
    // 38 m load their mean height with some 300 kPa: blocks of 300 kPa remain intact and cover a third less ground;
    // those of 30 kPa break and release all their water, which flows further than dry material.
    const std::string strong = summary("structured.ini", {"structured.cohesion=300000"}),
                      weak = summary("structured.ini");
    EXPECT_LT(json_number(strong, "covered_area_m2"), 0.85 * covered);
    EXPECT_EQ(json_number(strong, "released_water_m3"), 0);
    EXPECT_NEAR(json_number(weak, "released_water_m3"), 0.5 * json_number(weak, "initial_m3"), 1);
    EXPECT_GT(json_number(weak, "horizontal_m"), json_number(loose, "horizontal_m"));
    // The water's particles count, too.
    EXPECT_GT(json_number(weak, "particle_steps"), json_number(loose, "particle_steps"));
    EXPECT_NEAR(json_number(weak, "initial_m3"), volume, 1);
}

// With frames, their particles and an animation as without.
TEST_F(BothModels, ObservationChangesNothing) {
    for (const std::string scene : {"coulomb.ini", "structured.ini"}) {
        const std::vector<std::string> brief{"time.end=20", "hazard.scheme=swiss-flood"};
        std::vector<std::string> seen = brief;
        seen.insert(seen.end(), {"time.frame-interval=0.7", "output.formats=geotiff, particles-gpkg",
                                 "output.checkpoint-interval=0.05"});
        const std::string alone = summary(scene, brief), series = read_text(path("result/timeseries.csv"));
        std::map<std::string, std::vector<double>> rasters;
        for (const char* name : {"max_depth", "max_velocity", "final_depth", "arrival_time", "max_flux"})
            rasters[name] = gis::read_result_raster(path("result/" + std::string(name) + ".tif")).values;
        const std::string watched = summary(scene, seen, "on");
        EXPECT_GT(files().size(), 60U);
        EXPECT_EQ(read_text(path("result/timeseries.csv")), series);
        for (const auto& [name, values] : rasters) {
            const std::vector<double> now = gis::read_result_raster(path("result/" + name + ".tif")).values;
            ASSERT_EQ(now.size(), values.size());
            EXPECT_EQ(std::memcmp(now.data(), values.data(), values.size() * sizeof(double)), 0) << name;
        }
        for (const char* statistic :
             {"steps", "max_depth_m", "max_velocity_ms", "covered_area_m2", "horizontal_m", "final_m3"})
            EXPECT_EQ(json_number(watched, statistic), json_number(alone, statistic)) << statistic;
    }
}

}  // namespace
}  // namespace frana::test
