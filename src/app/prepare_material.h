// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "params/scene_spec.h"
#include "simulation/scene.h"

namespace frana::app {

/// [material] in SI units, angles as tangents.
Material material_of(const MaterialSpec& spec);
/// [entrainment] in SI units, angles as tangents.
Entrainment entrainment_of(const EntrainmentSpec& spec);

}  // namespace frana::app
