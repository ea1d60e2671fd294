// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"
#include "particles/seeding.h"
#include "simulation/release.h"
#include "support/problems.h"

namespace frana {
namespace {

const Polygon k_square_with_hole{{{10, 10}, {50, 10}, {50, 50}, {10, 50}}, {{{20, 20}, {30, 20}, {30, 30}, {20, 30}}}};

TEST(FillOutline, ConservesAreaHolesAndParts) {
    const MultiPolygon outline{k_square_with_hole, {{{70, 10}, {90, 10}, {80, 30}}, {}}};
    ParticleSet particles;
    const double volume = fill_outline(
        outline, 1.3, [](Point) { return 2.0; }, particles);
    EXPECT_NEAR(volume, 2 * area(outline), 1e-12 * volume);
    for (std::size_t i = 0; i < particles.size(); ++i) {
        const Point p{particles[Field::x][i], particles[Field::y][i]};
        EXPECT_FALSE(p.x > 20 && p.x < 30 && p.y > 20 && p.y < 30) << "in the hole";
    }
}

TEST(FillOutline, CountsOverlappingPartsOnce) {
    const Polygon square{{{10, 10}, {50, 10}, {50, 50}, {10, 50}}, {}};
    const Polygon shifted{{{30, 10}, {70, 10}, {70, 50}, {30, 50}}, {}};
    ParticleSet particles;
    EXPECT_NEAR(fill_outline(
                    {square, shifted}, 1, [](Point) { return 1.0; }, particles),
                60 * 40, 1e-9);
}

TEST(FillOutline, FillsASliverNarrowerThanTheLattice) {
    ParticleSet particles;
    const MultiPolygon sliver{{{{10, 10.1}, {90, 10.1}, {90, 10.4}, {10, 10.4}}, {}}};
    EXPECT_NEAR(fill_outline(
                    sliver, 2, [](Point) { return 1.0; }, particles),
                80 * 0.3, 1e-10);
    EXPECT_GE(particles.size(), 40u);
}

Scene slope_scene() {
    Scene scene;
    scene.grid = {500000, 5100100, 2, 50, 50, ""};
    scene.terrain = Raster(scene.grid);
    for (std::int64_t r = 0; r < 50; ++r) {
        for (std::int64_t c = 0; c < 50; ++c) scene.terrain.at(r, c) = 0.75 * 2 * static_cast<double>(c);
    }
    scene.release = {
        {{{{{500040, 5100040}, {500060, 5100040}, {500060, 5100060}, {500040, 5100060}}, {}}}, 3, {}, {}, false}};
    return scene;
}

TEST(MakeRelease, NormalThicknessIsLongerVertically) {
    Scene scene = slope_scene();
    EXPECT_NEAR(make_release(scene).volume, 3 * 400, 1e-9);
    scene.release[0].normal_to_bed = true;  // slope 0.75: secant 1.25
    EXPECT_NEAR(make_release(scene).volume, 3 * 1.25 * 400, 1e-6);
}

TEST(MakeRelease, MatchesAGivenVolume) {
    Scene scene = slope_scene();
    scene.release[0].volume = 1500;
    const Release release = make_release(scene);
    double sum = 0;
    for (std::size_t p = 0; p < release.particles.size(); ++p) sum += release.particles[Field::volume][p];
    EXPECT_NEAR(sum, 1500, 1e-9);
    EXPECT_EQ(release.volume, 1500);
}

TEST(MakeRelease, RemovesTheMassFromTheTerrainThatContainsIt) {
    Scene scene = slope_scene();
    scene.terrain_contains_release = true;
    const Release release = make_release(scene);
    double taken = 0;
    for (std::size_t i = 0; i < release.bed.values.size(); ++i)
        taken += scene.terrain.values[i] - release.bed.values[i];
    EXPECT_NEAR(taken * 4, release.volume, 1e-9 * release.volume);
}

TEST(MakeRelease, NamesTheCellsWithoutTerrain) {
    Scene scene = slope_scene();
    scene.terrain.at(25, 25) = k_no_data;
    try {
        make_release(scene);
        FAIL() << "must refuse";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::input);
        EXPECT_TRUE(
            has_problem(error.problems(), "terrain.dtm", "1 cells, among them row 25 column 25 (500051.0, 5100049.0)"));
    }
}

TEST(MakeRelease, RefusesAnEmptyRelease) {
    Scene scene = slope_scene();
    scene.release[0].thickness = 0;
    EXPECT_THROW(make_release(scene), Error);
}

}  // namespace
}  // namespace frana
