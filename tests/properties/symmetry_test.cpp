// SPDX-License-Identifier: Apache-2.0
// What must not change a flow: where its map lies, which way round it is, how much map there is beyond it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "moved_scene.h"
#include "random_scene.h"
#include "simulation/simulation.h"

namespace frana::test {
namespace {

bool same_bits(const Raster& a, const Raster& b) {
    return a.values.size() == b.values.size() &&
           std::memcmp(a.values.data(), b.values.data(), a.values.size() * sizeof(double)) == 0;
}

constexpr Raster RunResult::*k_rasters[] = {&RunResult::release,       &RunResult::max_depth,   &RunResult::max_velocity,
                                            &RunResult::final_depth, &RunResult::arrival_time};

// Greatest difference of any cell, over the greatest value; what is dry counts as 0.
double greatest_difference(const Raster& a, const Raster& b) {
    const auto value = [](double v) { return std::isnan(v) ? 0 : v; };
    double difference = 0, greatest = 0;
    for (std::size_t i = 0; i < a.values.size(); ++i) {
        difference = std::max(difference, std::abs(value(a.values[i]) - value(b.values[i])));
        greatest = std::max(greatest, std::abs(value(a.values[i])));
    }
    return greatest > 0 ? difference / greatest : difference;
}

Made made(int scene) {
    return scene % 5 == 4 ? Made::of_solids : scene % 5 == 3 ? Made::of_fluid : Made::of_mass;
}

template <class Look>
void for_scenes(int of_a_hundred, std::uint64_t stream, const Look& look) {
    for (int i = 0; i < scene_count(of_a_hundred); ++i) {
        SCOPED_TRACE(scene_label(i));
        RandomNumbers random(scene_seed(), stream + static_cast<std::uint64_t>(i));
        look(random_scene(random, made(i)), random, i);
    }
}

TEST(Property, ASceneElsewhereGivesTheSameBits) {
    for_scenes(15, 1000000, [](const Scene& scene, RandomNumbers& random, int) {
        const auto east = static_cast<std::int64_t>(random.below(2000)) - 1000;
        const auto north = static_cast<std::int64_t>(random.below(2000)) - 1000;
        const RunResult here = run(scene, {}), there = run(moved(scene, east, north), {});
        EXPECT_EQ(here.steps, there.steps);
        for (const auto raster : k_rasters) EXPECT_TRUE(same_bits(here.*raster, there.*raster));
    });
}

void compare(const RunResult& straight, const RunResult& other, Raster (*move)(const Raster&), int scene) {
    for (const auto raster : {&RunResult::release, &RunResult::max_depth, &RunResult::max_velocity, &RunResult::final_depth}) {
        const double d = greatest_difference(move(straight.*raster), other.*raster);
        if (d > 1e-13) std::printf("scene %d %g steps %ld particles %ld\n", scene, d, (long)straight.steps, (long)straight.particles_peak);
    }
}

TEST(Property, AMirroredSceneFlowsMirrored) {
    for_scenes(15, 2000000, [](const Scene& scene, RandomNumbers&, int i) {
        compare(run(scene, {}), run(mirrored(scene), {}), mirrored, i);
    });
}

TEST(Property, ATurnedSceneFlowsTurned) {
    for_scenes(15, 3000000, [](const Scene& scene, RandomNumbers&, int i) {
        compare(run(scene, {}), run(turned(scene), {}), turned, i);
    });
}

// Whether nothing came within five cells of an edge, where what lies beyond is felt.
bool stays_inside(const RunResult& result) {
    const GridSpec& grid = result.max_depth.grid;
    for (std::int64_t row = 0; row < grid.rows; ++row) {
        for (std::int64_t column = 0; column < grid.columns; ++column) {
            const std::int64_t to_edge = std::min({row, column, grid.rows - 1 - row, grid.columns - 1 - column});
            if (to_edge < 5 && result.max_depth.at(row, column) > 0) return false;
        }
    }
    return result.volume_left == 0;
}

TEST(Property, MoreTerrainBeyondGivesTheSameBits) {
    int compared = 0;
    for_scenes(15, 4000000, [&](Scene scene, RandomNumbers& random, int i) {
        scene.numerics.boundary = Boundary::open;
        const auto more = [&] { return static_cast<std::int64_t>(random.below(60)); };
        const Scene wide = widened(scene, 0, more(), 0, more(), random.between(0, 5));
        const RunResult narrow = run(scene, {}), broad = run(wide, {});
        if (!stays_inside(narrow)) return;
        ++compared;
        EXPECT_EQ(narrow.steps, broad.steps) << i;
        for (const auto raster : k_rasters) EXPECT_TRUE(same_bits(narrow.*raster, narrowed(broad.*raster, scene.grid)));
    });
    EXPECT_GT(compared, 3);
}

}  // namespace
}  // namespace frana::test
