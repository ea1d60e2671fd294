// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>

#include "app/input/prepare.h"

namespace frana::app {

/// Returns the provenance in every raster: PROGRAM, VERSION, SCENE, SCENE_HASH, DEPTH (gis::k_depth_item),
/// TIFFTAG_SOFTWARE.
std::map<std::string, std::string> provenance(const Prepared& prepared);

/// Returns the scene as in the result's scene.ini: its paths are relative to the result's folder, so that both can be
/// moved.
std::string echoed_scene(const Prepared& prepared);
/// The same of a scene that is in a folder of the result.
std::string echoed_scene(const SceneSpec& scene, const std::string& folder);
/// As the first, with the names of the files alone.
std::string echoed_scene_without_places(const Prepared& prepared);

/// Returns a scene whose files are named relative to a folder.
SceneSpec seen_from(SceneSpec scene, const std::string& folder);
/// Returns a scene with the names of its files alone: the same wherever they and the result are.
SceneSpec without_places(SceneSpec scene);

}  // namespace frana::app
