// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "facade/scene_data.h"
#include "params/keys/scene_spec.h"
#include "simulation/scene.h"

namespace frana::facade {

/// What the engine runs.
struct EngineScene {
    SceneSpec spec;
    frana::Scene scene;
    std::vector<std::string> warnings;
};

/// Throws the engine's Error(input) with every problem of the scene, in the words of scene files.
EngineScene prepare_scene(const Scene::Data& data);

}  // namespace frana::facade
