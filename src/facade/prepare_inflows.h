// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/error.h"
#include "facade/scene_data.h"
#include "params/keys/scene_spec.h"
#include "simulation/scene.h"

namespace frana::facade {

/// The inflows, checked as frana run checks those of files; where they lie on the ground is checked by the engine.
std::vector<frana::Inflow> inflows_of(const Scene::Data& data, const SceneSpec& spec, Problems& problems);

/// Refuses inflows with more particles than can be counted. Needs the grid, the numerics and the end of the scene.
void check_inflow_counts(const frana::Scene& scene, Problems& problems);

}  // namespace frana::facade
