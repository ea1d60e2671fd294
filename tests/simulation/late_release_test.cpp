// SPDX-License-Identifier: Apache-2.0
// Areas that fail at separate times with separate velocities, and walls that no flow passes.
#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"
#include "physics/laws.h"
#include "simulation/flow.h"
#include "simulation/release.h"
#include "simulation/simulation.h"

namespace frana {
namespace {

Polygon box(double west, double south, double east, double north) {
    return {{{west, south}, {east, south}, {east, north}, {west, north}}, {}};
}

// 200 m x 100 m with a slope to the east.
Scene plane_scene(double slope) {
    Scene scene;
    scene.grid = {0, 100, 2, 100, 50, ""};
    scene.terrain = Raster(scene.grid);
    for (std::int64_t r = 0; r < scene.grid.rows; ++r)
        for (std::int64_t c = 0; c < scene.grid.columns; ++c)
            scene.terrain.at(r, c) = 200 - slope * scene.grid.cell_centre(r, c).x;
    scene.material.of<CoulombFriction>().friction_coefficient = 0.1;
    scene.time.end = 6;
    return scene;
}

TEST(LateRelease, EntersCompletelyAtItsTime) {
    Scene scene = plane_scene(0.5);
    scene.terrain_contains_release = true;
    scene.release = {{{box(10, 20, 30, 40)}, 2}, {{box(10, 60, 30, 80)}, 3}};
    scene.release[1].start = 3;
    const RunResult result = run(scene, {});
    const double first = 2 * 400, second = 3 * 400;
    for (const SeriesRow& row : result.series) {
        const double expected = row.time <= 3 ? first : first + second;
        EXPECT_NEAR(row.volume + row.volume_left, expected, 1e-12 * expected) << row.time;
    }
    EXPECT_NEAR(result.volume_initial, first, 1e-12 * first);
    EXPECT_NEAR(result.volume_entered, first + second, 1e-12 * second);
    EXPECT_GE(result.raster("arrival_time").at(15, 10), 3);  // in the middle of the second area
    EXPECT_LT(result.raster("arrival_time").at(35, 10), 1);
    // The bed is below both, by their thicknesses.
    EXPECT_NEAR(scene.terrain.at(15, 10) - result.raster("bed").at(15, 10), 3, 1e-9);
    EXPECT_NEAR(result.raster("release").at(15, 10), 3, 1e-9);
    EXPECT_TRUE(result.released[1].failed);
    scene.time.end = 2;
    const RunResult shorter = run(scene, {});
    EXPECT_FALSE(shorter.released[1].failed);
    EXPECT_NEAR(shorter.volume_entered, first, 1e-12 * first);
}

// On ground that has not failed yet, an earlier mass must not fall into the hollow of a later one: it slides at the
// speed of the plane, as if there were no second area. Until the second fails, both runs have the same bits.
TEST(LateRelease, IsGroundUntilItFails) {
    Scene alone = plane_scene(0.5);
    alone.terrain_contains_release = true;
    alone.release = {{{box(10, 40, 30, 60)}, 2}};
    alone.time.end = 4;
    Scene both = alone;
    both.release.push_back({{box(34, 40, 60, 60)}, 5});
    both.release[1].start = 4;
    const RunResult one = run(alone, {}), two = run(both, {});
    ASSERT_EQ(one.series.size(), two.series.size());
    for (std::size_t i = 0; i < one.series.size(); ++i) {
        EXPECT_EQ(one.series[i].kinetic_energy, two.series[i].kinetic_energy);
        EXPECT_EQ(one.series[i].max_depth, two.series[i].max_depth);
    }
}

// The change of elevation takes nothing from ground that has not failed, over which another mass has flowed.
TEST(LateRelease, LowersNoGroundBeforeItFails) {
    Scene scene = plane_scene(0.5);
    scene.release = {{{box(10, 40, 30, 60)}, 2}, {{box(34, 40, 60, 60)}, 5}, {{box(34, 70, 60, 90)}, 5}};
    scene.release[1].start = 3;
    scene.release[2].start = 20;
    scene.time.end = 2;
    const RunResult before = run(scene, {});
    ASSERT_FALSE(before.released[1].failed);
    const Raster &change = before.raster("elevation_change"), &depth = before.raster("final_depth");
    int reached = 0;
    for (std::int64_t r = 20; r < 30; ++r)
        for (std::int64_t c = 17; c < 30; ++c) {
            if (std::isnan(change.at(r, c))) continue;
            ++reached;
            EXPECT_NEAR(change.at(r, c), depth.at(r, c), 1e-12) << r << ", " << c;  // rounding of sums of metres
        }
    EXPECT_GT(reached, 20);
    EXPECT_NEAR(change.at(25, 7), depth.at(25, 7) - 2, 1e-12);  // the first area has failed
    scene.time.end = 6;                                         // the second as well, the third not yet
    const RunResult after = run(scene, {});
    ASSERT_TRUE(after.released[1].failed && !after.released[2].failed);
    EXPECT_NEAR(after.raster("elevation_change").at(25, 20), after.raster("final_depth").at(25, 20) - 5, 1e-12);
}

// Material released onto other material makes it deeper immediately: one metre on one metre of still water.
TEST(LateRelease, IsAddedOnTopOfOtherMaterial) {
    Scene scene = plane_scene(0);
    scene.release = {{{box(0, 0, 200, 100)}, 1}};
    const Release pool = make_release(scene);
    scene.release = {{{box(60, 30, 140, 70)}, 1}};
    const Release more = make_release(scene);
    Flow flow(pool.bed, pool.particles, scene.material, scene.numerics, 1);
    flow.add_particles(more.particles);
    const Raster depth = flow.nodal_fields().depth;
    // A cell and a half from the new mass's edge the splines do not reach it; 1e-9 is rounding.
    for (std::int64_t r = 18; r < 32; ++r)
        for (std::int64_t c = 33; c < 67; ++c) EXPECT_NEAR(depth.at(r, c), 2, 1e-9);
    EXPECT_NEAR(depth.at(5, 10), 1, 1e-9);
}

TEST(InitialVelocity, MovesTheCentroid) {
    Scene scene = plane_scene(0);
    scene.material.of<CoulombFriction>().friction_coefficient = 0;
    scene.release = {{{box(40, 40, 60, 60)}, 1}};
    scene.release[0].speed = 10;
    scene.release[0].azimuth = std::atan2(0.6, 0.8);
    const Release release = make_release(scene);
    for (std::size_t p = 0; p < release.particles.size(); ++p) {
        EXPECT_NEAR(release.particles[Field::u][p], 6, 1e-12);
        EXPECT_NEAR(release.particles[Field::v][p], 8, 1e-12);
    }
    scene.release[0].azimuth.reset();
    EXPECT_THROW(make_release(scene), Error);  // level ground has no downhill
}

TEST(InitialVelocity, RunsDownhillAlongTheBed) {
    Scene scene = plane_scene(0.75);  // secant 1.25
    scene.release = {{{box(40, 40, 60, 60)}, 1}};
    scene.release[0].speed = 10;
    const Release release = make_release(scene);
    EXPECT_NEAR(release.particles[Field::u][0], 8, 1e-9);
    EXPECT_NEAR(release.particles[Field::v][0], 0, 1e-9);
}

TEST(ReleaseVolume, IsSharedByAllAreas) {
    Scene scene = plane_scene(0.5);
    scene.release = {{{box(10, 20, 30, 40)}, 2}, {{box(10, 60, 30, 80)}, 3}};
    scene.release[1].start = 1;
    scene.release_volume = 5000;
    const Release release = make_release(scene);
    EXPECT_NEAR(release.volume, 5000, 1e-9);
    EXPECT_NEAR(release.areas[0].volume, 2000, 1e-9);
    EXPECT_NEAR(release.areas[1].scaled, 2.5, 1e-12);
}

// A wall one cell thick across the path of a steep, fast mass: nothing gets behind it, nothing is lost.
TEST(Walls, StopTheFlow) {
    Scene scene = plane_scene(0.5);
    scene.release = {{{box(10, 10, 40, 90)}, 3}};
    scene.numerics.boundary = Boundary::wall;
    scene.time.end = 15;
    scene.walls.emplace(scene.grid);
    for (std::int64_t r = 0; r < scene.grid.rows; ++r) scene.walls->at(r, 50) = 1;
    const RunResult result = run(scene, {});
    EXPECT_TRUE(result.hard_events.none());
    for (std::int64_t r = 0; r < scene.grid.rows; ++r) {
        for (std::int64_t c = 50; c < scene.grid.columns; ++c)
            EXPECT_TRUE(std::isnan(result.raster("max_depth").at(r, c))) << r << " " << c;
    }
    EXPECT_GT(result.raster("max_depth").at(25, 49), 3);  // it piles up before the wall
    EXPECT_NEAR(result.volume_final, result.volume_entered, 1e-12 * result.volume_entered);
    scene.release = {{{box(96, 10, 104, 90)}, 3}};
    EXPECT_THROW(make_release(scene), Error);
}

}  // namespace
}  // namespace frana
