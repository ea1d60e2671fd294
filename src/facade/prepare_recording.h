// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/error.h"
#include "facade/scene_data.h"
#include "params/keys/scene_spec.h"
#include "simulation/scene.h"

namespace frana::facade {

/// The gauges and cross-sections, checked as frana run checks those of files.
Recording recording_of(const Scene::Data& data, const SceneSpec& spec, const GridSpec& grid, Problems& problems);

}  // namespace frana::facade
