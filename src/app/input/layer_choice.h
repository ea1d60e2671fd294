// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "gis/vector/vector_in.h"
#include "params/scene/read_scene.h"

namespace frana::app {

/// Returns the choice of the keys KEY-layer, KEY-filter and KEY-crs. Throws Error(input) for an unknown CRS.
gis::LayerChoice layer_choice(const SceneReading& reading, const LayerSpec& spec, const std::string& key);

}  // namespace frana::app
