// SPDX-License-Identifier: Apache-2.0
// Properties of every flow: nothing is lost, density alone changes nothing, friction shortens the run-out.
#include "physics/laws.h"
#include "scene_tests.h"

namespace frana::test {
namespace {

// Of sums over some thousand particles or cells: 1e-16 each.
constexpr double k_volume_error = 1e-12;

TEST(Property, NothingIsLostAndNoHardEventOccurs) {
    for_scenes(20, 5, [](const Scene& scene, RandomNumbers&, int) {
        const RunResult result = run(scene, {});
        EXPECT_LT(relative_volume_error(result), k_volume_error);
        EXPECT_EQ(result.hard_events.non_finite, 0);
        // The published scheme bounds a particle's area once in some hundred scenes.
        if (scene.numerics.scheme != Scheme::paper) {
            EXPECT_TRUE(result.hard_events.none());
        }
        for (const SeriesRow& row : result.series) {
            ASSERT_TRUE(std::isfinite(row.max_depth + row.max_speed + row.kinetic_energy));
            if (result.exchanges) continue;  // the series does not contain the volume eroded from the bed
            ASSERT_NEAR(row.volume + row.volume_left, row.volume_entered, k_volume_error * row.volume_entered)
                << "step " << row.step;
        }
        for (const double depth : result.raster("max_depth").values) EXPECT_FALSE(depth < 0);
    });
}

// Friction, turbulence, Manning's resistance and the pressure are all in proportion to density.
TEST(Property, TwiceTheDensityChangesNothingWithoutViscosityAndYieldStress) {
    for_scenes(15, 6, [](Scene& scene, RandomNumbers& random, int number) {
        if (made_of(number) == Made::of_solids) scene = random_scene(random, Made::of_fluid);
        scene.material.of<BinghamStress>().viscosity = scene.material.of<BinghamStress>().yield_stress = 0;
        if (scene.structured) scene.structured->fluid_viscosity = 0;
        const RunResult light = run(scene, {});
        scene.material.density *= 2;
        if (scene.structured) scene.structured->fluid_density *= 2;
        const RunResult heavy = run(scene, {});
        for (const char* raster : k_fields) EXPECT_TRUE(same_bits(light.raster(raster), heavy.raster(raster)));
        EXPECT_TRUE(same_bits(light.raster("arrival_time"), heavy.raster("arrival_time")));
    });
}

// Returns the easternmost edge of the reached cells [m].
double reach(const RunResult& result) {
    const GridSpec& grid = result.raster("max_depth").grid;
    double east = 0;
    for (std::int64_t row = 0; row < grid.rows; ++row) {
        for (std::int64_t column = 0; column < grid.columns; ++column) {
            if (result.raster("max_depth").at(row, column) > 0) east = std::max(east, grid.cell_centre(row, column).x);
        }
    }
    return east;
}

TEST(Property, MoreFrictionNeverIncreasesTheRunOutOnAPlane) {
    for (int i = 0; i < scene_count(5); ++i) {
        SCOPED_TRACE(scene_label(i));
        RandomNumbers random(scene_seed(), 7000000 + static_cast<std::uint64_t>(i));
        Scene scene = random_plane(random);
        double before = std::numeric_limits<double>::infinity(), front_before = before;
        for (const double angle : {4., 10., 16., 22., 28., 34.}) {
            scene.material.of<CoulombFriction>().friction_coefficient = std::tan(angle * M_PI / 180);
            const RunResult result = run(scene, {});
            EXPECT_LE(reach(result), before) << angle << " degrees";
            EXPECT_LE(result.series.back().front_distance, front_before) << angle << " degrees";
            before = reach(result);
            front_before = result.series.back().front_distance;
        }
    }
}

}  // namespace
}  // namespace frana::test
