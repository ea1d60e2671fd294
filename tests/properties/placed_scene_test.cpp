// SPDX-License-Identifier: Apache-2.0
#include "placed_scene.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/geometry.h"
#include "physics/laws.h"
#include "simulation/release.h"
#include "simulation/scene.h"
#include "simulation/simulation.h"

namespace frana::test {
namespace {

constexpr double k_radians_of_degree = M_PI / 180;

double square(double value) {
    return value * value;
}

// 60 x 44 cells of 4 m far from the origin of their coordinates: a curved gully that falls to the south-east, and a
// release with five corners on no cell's edge.
Scene gully() {
    Scene scene;
    GridSpec& grid = scene.grid;
    grid.west = 527004;
    grid.north = 5094176;
    grid.cell_size = 4;
    grid.columns = 60;
    grid.rows = 44;
    scene.terrain = Raster(grid);
    for (std::int64_t row = 0; row < grid.rows; ++row) {
        for (std::int64_t column = 0; column < grid.columns; ++column) {
            const double x = 4.0 * static_cast<double>(column), y = 4.0 * static_cast<double>(row);
            const double axis = 70 + 20 * std::sin(x / 37) + 0.2 * x;
            scene.terrain.at(row, column) =
                1500 - 0.45 * x - 0.1 * y + 0.8 * std::abs(y - axis) + 0.3 * std::sin(x * y / 91);
        }
    }
    ReleaseArea area;
    area.thickness = 6;
    const double x = grid.west, y = grid.south();
    area.outline = {{{{x + 20.25, y + 81.5},
                      {x + 63.5, y + 75.125},
                      {x + 71.25, y + 110.75},
                      {x + 44.5, y + 127.25},
                      {x + 17.75, y + 108.5}},
                     {}}};
    scene.release = {area};
    scene.material.of<CoulombFriction>().friction_coefficient = std::tan(12 * k_radians_of_degree);
    scene.material.of<TurbulentFriction>().turbulence = 800;
    scene.numerics.curvature = true;
    scene.time.end = 20;
    place_origin(scene);
    return scene;
}

TEST(PlacedScene, AQuarterTurnReordersCellsAndPoints) {
    Scene scene = gully();
    scene.release[0].azimuth = 1.5;
    const PlacedScene placed = placed_otherwise(scene, {0, 90});
    EXPECT_TRUE(placed.inside.values.empty());
    EXPECT_EQ(placed.scene.grid.columns, 44);
    EXPECT_EQ(placed.scene.grid.rows, 60);
    EXPECT_EQ(placed.scene.grid.south(), 0);
    EXPECT_EQ(placed.scene.terrain.at(59, 0), scene.terrain.at(0, 0));  // north-west becomes south-west
    EXPECT_EQ(placed.scene.terrain.at(0, 43), scene.terrain.at(43, 59));
    const Point p = scene.release[0].outline[0].outer[1], q = placed.scene.release[0].outline[0].outer[1];
    EXPECT_EQ(q.x, scene.grid.north - p.y);
    EXPECT_EQ(q.y, p.x - scene.grid.west);
    EXPECT_NEAR(*placed.scene.release[0].azimuth, 1.5 - M_PI / 2, 1e-15);
    const Scene whole = placed_otherwise(scene, {0, 360}).scene;
    EXPECT_EQ(whole.terrain.values, scene.terrain.values);
    EXPECT_EQ(whole.release[0].outline[0].outer[2].x, scene.release[0].outline[0].outer[2].x - scene.grid.west);
}

// Cubic convolution is exact for polynomials of the second degree.
TEST(PlacedScene, GroundIsWhereTheTurnedOutlineIs) {
    Scene scene = gully();
    const auto ground = [&](Point p) {
        const double x = p.x - scene.grid.west, y = p.y - scene.grid.south();
        return 900 - 0.3 * x + 0.2 * y + 0.004 * x * x - 0.002 * x * y + 0.003 * y * y;
    };
    for (std::int64_t row = 0; row < 44; ++row)
        for (std::int64_t column = 0; column < 60; ++column)
            scene.terrain.at(row, column) = ground(scene.grid.cell_centre(row, column));
    scene.terrain.at(20, 50) = k_no_data;
    for (const GridPlacement& placement : {GridPlacement{0.5, 0}, GridPlacement{0, 30}, GridPlacement{0, 45}}) {
        const PlacedScene placed = placed_otherwise(scene, placement);
        const Scene& other = placed.scene;
        // Two corners of the outline define where a place of the new grid is on the old one.
        const auto& from = scene.release[0].outline[0].outer;
        const auto& to = other.release[0].outline[0].outer;
        const double turn = placement.turn_deg * k_radians_of_degree, c = std::cos(turn), s = std::sin(turn);
        EXPECT_NEAR(to[2].x - to[0].x, c * (from[2].x - from[0].x) - s * (from[2].y - from[0].y), 1e-8);
        EXPECT_NEAR(to[2].y - to[0].y, s * (from[2].x - from[0].x) + c * (from[2].y - from[0].y), 1e-8);
        EXPECT_NEAR(area(other.release[0].outline), area(scene.release[0].outline), 1e-6);
        int compared = 0, holes = 0;
        for (std::int64_t row = 0; row < other.grid.rows; ++row) {
            for (std::int64_t column = 0; column < other.grid.columns; ++column) {
                const Point at = other.grid.cell_centre(row, column);
                const double x = at.x - to[0].x, y = at.y - to[0].y;
                const Point old{from[0].x + c * x + s * y, from[0].y - s * x + c * y};
                const bool is_inside = scene.grid.bounds().contains(old.x, old.y);
                const double to_edge = std::min({old.x - scene.grid.west, scene.grid.east() - old.x,
                                                 old.y - scene.grid.south(), scene.grid.north - old.y});
                if (std::abs(to_edge) > 0.01) {
                    EXPECT_EQ(placed.inside.at(row, column), is_inside ? 1 : 0);
                }
                const Point hole = scene.grid.cell_centre(20, 50);
                const double from_hole = std::hypot(old.x - hole.x, old.y - hole.y);
                if (from_hole < 1.9) {
                    EXPECT_TRUE(std::isnan(other.terrain.at(row, column)));
                }
                if (std::isnan(other.terrain.at(row, column))) ++holes;
                if (to_edge < 9 || from_hole < 12) continue;
                ++compared;
                EXPECT_NEAR(other.terrain.at(row, column), ground(old), 1e-6);
            }
        }
        EXPECT_GT(compared, 1500);
        EXPECT_TRUE(placement.turn_deg != 0 || holes == 1) << holes;
        EXPECT_LE(holes, 4);
    }
}

TEST(PlacedScene, AThicknessRasterConservesItsVolume) {
    Scene scene = gully();
    Raster thickness(scene.grid, k_no_data);
    for (std::int64_t row = 0; row < 44; ++row)
        for (std::int64_t column = 0; column < 60; ++column)
            if (const double h = 5 - 0.02 * (square(row - 20.0) + square(column - 12.0)); h > 0)
                thickness.at(row, column) = h;
    scene.release[0].thickness_raster = thickness;
    const double volume = make_release(scene).volume;
    for (const double turn : {30.0, 45.0, 90.0}) {
        const Release turned = make_release(placed_otherwise(scene, {0, turn}).scene);
        EXPECT_NEAR(turned.volume, volume, 1e-9 * volume) << turn;
    }
}

TEST(PlacedScene, MaterialThatLeavesTheGroundDoesNotReturn) {
    Scene level = gully();
    level.terrain = Raster(level.grid, 100);
    const PlacedScene placed = placed_otherwise(level, {0, 30});
    EXPECT_NEAR(placed.scene.terrain.at(0, 0), 100 - 5 * 4, 1e-9);  // five cells of 4 m deep
    for (std::size_t i = 0; i < placed.inside.values.size(); ++i) {
        if (placed.inside.values[i] == 0) {
            ASSERT_LT(placed.scene.terrain.values[i], 100);
        } else {
            ASSERT_NEAR(placed.scene.terrain.values[i], 100, 1e-9);
        }
    }
    Scene walled = gully();
    walled.numerics.boundary = Boundary::wall;
    const PlacedScene fenced = placed_otherwise(walled, {0, 30});
    ASSERT_TRUE(fenced.scene.walls);
    for (std::size_t i = 0; i < fenced.inside.values.size(); ++i)
        ASSERT_EQ(fenced.scene.walls->values[i], fenced.inside.values[i] == 0 ? 1 : 0);
}

// In a whole scene, over hundreds of steps in which thousands of particles split and merge: sums are in another order,
// and rounding is amplified as neighbours diverge (1e-9 here); one particle that splits differently gives 1e-4.
TEST(PlacedScene, AFlowTurnedByAQuarterDiffersOnlyByRounding) {
    Scene scene = gully();
    scene.numerics.cfl = 0.5;
    RunOptions options;
    options.threads = 2;
    const RunResult straight = run(scene, options), turned = run(placed_otherwise(scene, {0, 90}).scene, options);
    EXPECT_GT(straight.steps, 150);
    EXPECT_EQ(straight.steps, turned.steps);
    EXPECT_EQ(straight.particles_final, turned.particles_final);
    EXPECT_NE(straight.particles_final, straight.particles_initial);
    for (const char* raster : {"release", "max_depth", "max_velocity", "final_depth"}) {
        const Raster expected = quarter_turned(straight.raster(raster));
        double greatest = 0, difference = 0;
        for (std::size_t i = 0; i < expected.values.size(); ++i) {
            const auto value = [&](const Raster& r) { return std::isnan(r.values[i]) ? 0 : r.values[i]; };
            greatest = std::max(greatest, value(expected));
            difference = std::max(difference, std::abs(value(expected) - value(turned.raster(raster))));
        }
        EXPECT_GT(greatest, 0.5);
        EXPECT_LT(difference, 1e-9 * greatest);
    }
}

}  // namespace
}  // namespace frana::test
