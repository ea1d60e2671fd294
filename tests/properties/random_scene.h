// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "random_numbers.h"
#include "simulation/scene.h"

namespace frana::test {

/// The material of a random scene.
enum class Made { of_mass, of_fluid, of_solids };

/// Returns a small terrain of slopes, humps and gullies, an outline of some corners near its top, a material and
/// numerics, all random within the ranges that the key reference calls usual. Runs in some tens of milliseconds.
///
/// Cell sizes are 2, 2.5 or 4 m and corners are on multiples of 1/1024 m, so that moving a scene by whole cells,
/// mirroring and turning it are exact.
Scene random_scene(RandomNumbers& random, Made made);

/// Returns a plane of a random slope that falls to the east and is level across, with a release high on it.
Scene random_plane(RandomNumbers& random);

/// Returns the number of scenes of a test: its part of the hundred that are always run, or of FRANA_SCENES.
int scene_count(int of_a_hundred);
/// Returns FRANA_SEED, or 1.
std::uint64_t scene_seed();
/// Returns "FRANA_SEED=1, scene 17", for messages.
std::string scene_label(int scene);

}  // namespace frana::test
