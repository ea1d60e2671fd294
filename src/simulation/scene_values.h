// SPDX-License-Identifier: Apache-2.0
// From the words and units of scene files to the engine's values, as far as they come from no file.
#pragma once

#include <optional>

#include "params/keys/scene_spec.h"
#include "simulation/scene.h"

namespace frana {

/// Returns [structured], if that is the scene's model; without properties that vary from place to place.
std::optional<StructuredMaterial> structured_of(const SceneSpec& spec);
Numerics numerics_of(const SceneSpec& spec);
TimeControl time_of(const SceneSpec& spec);

/// Sets what the numbers of [release] say of an area: how its thickness is measured, when it fails, how fast it starts.
/// The volume of all areas is the scene's (release_volume_of).
void set_uniform_details(const ReleaseSpec& spec, ReleaseArea& area);
std::optional<double> release_volume_of(const ReleaseSpec& spec);

}  // namespace frana
