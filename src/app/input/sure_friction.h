// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "params/keys/scene_spec.h"

namespace frana::app {

/// Returns the tangent of the slope up to which the bed's friction holds material everywhere; 0 where places differ,
/// and where no law at the bed resists with it: the structured model's fluid, RAMMS's yield term alone, laws of fluids.
double sure_friction(const SceneSpec& scene);

}  // namespace frana::app
