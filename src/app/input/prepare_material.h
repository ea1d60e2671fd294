// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "params/keys/scene_spec.h"
#include "simulation/scene.h"

namespace frana::app {

/// Returns [material] in SI units, angles as tangents.
Material material_of(const MaterialSpec& spec);
/// Returns [structured], if that is the scene's model; without properties that vary from place to place
/// (prepare_structured.h).
std::optional<StructuredMaterial> structured_of(const SceneSpec& spec);
/// Returns [entrainment] in SI units, angles as tangents.
Entrainment entrainment_of(const EntrainmentSpec& spec);

}  // namespace frana::app
