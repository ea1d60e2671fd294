// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/error.h"
#include "facade/scene_data.h"
#include "params/keys/scene_spec.h"
#include "simulation/scene.h"

namespace frana::facade {

/// The areas that fail, checked. Cells without outline get one; thicknesses by cells have the volume of the cells.
std::vector<ReleaseArea> release_areas(const Scene::Data& data, const SceneSpec& spec, const GridSpec& grid,
                                       Problems& problems);

/// The values of [zones], checked, in the units of the engine.
MaterialZones material_zones(const Scene::Data& data, const SceneSpec& spec, const GridSpec& grid, Problems& problems);

}  // namespace frana::facade
