// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"
#include "simulation/release.h"

namespace frana {
namespace {

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

TEST(MakeRelease, RefusesAnEmptyRelease) {
    Scene scene = slope_scene();
    scene.release[0].thickness = 0;
    EXPECT_THROW(make_release(scene), Error);
}

}  // namespace
}  // namespace frana
