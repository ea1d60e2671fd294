// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/vtk/functions.h"

namespace frana::render {

/// See VtkFunctions.
std::unique_ptr<TerrainScene> terrain_scene(const std::vector<SceneSurface>& surfaces, int width, int height);

}  // namespace frana::render
