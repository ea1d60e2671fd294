// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "random_scene.h"
#include "simulation/simulation.h"

namespace frana::test {

/// Three scenes of five with a mass, one with fluid, one with solids and fluid.
inline Made made_of(int scene) {
    return scene % 5 == 4 ? Made::of_solids : scene % 5 == 3 ? Made::of_fluid : Made::of_mass;
}

/// Calls look(scene, random, number) for a test's part of the random scenes, each with a separate stream of numbers;
/// those with a mass then by finite volumes, too.
template <class Look>
void for_scenes(int of_a_hundred, std::uint64_t stream, const Look& look) {
    const int count = scene_count(of_a_hundred);
    std::printf("  %d scenes, FRANA_SEED=%llu\n", count, static_cast<unsigned long long>(scene_seed()));
    for (int i = 0; i < count; ++i) {
        SCOPED_TRACE(scene_label(i));
        RandomNumbers random(scene_seed(), stream * 1000000 + static_cast<std::uint64_t>(i));
        Scene scene = random_scene(random, made_of(i)), by_volumes = scene;
        look(scene, random, i);
        if (made_of(i) != Made::of_mass) continue;
        SCOPED_TRACE("by finite volumes");
        by_volumes.numerics.scheme = Scheme::finite_volume;
        look(by_volumes, random, i);
    }
}

inline bool same_bits(const Raster& a, const Raster& b) {
    return a.values.size() == b.values.size() &&
           std::memcmp(a.values.data(), b.values.data(), a.values.size() * sizeof(double)) == 0;
}

/// The rasters of a result that contain no times, which jump if rounding makes a step earlier or later.
inline constexpr const char* k_fields[] = {"release", "max_depth", "max_velocity", "final_depth"};

}  // namespace frana::test
