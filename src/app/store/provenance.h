// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>

#include "app/input/prepare.h"

namespace frana::app {

/// What every raster says about where it comes from: PROGRAM, VERSION, SCENE, SCENE_HASH, TIFFTAG_SOFTWARE.
std::map<std::string, std::string> provenance(const Prepared& prepared);

/// The scene as scene.ini of the result holds it.
std::string echoed_scene(const Prepared& prepared);

}  // namespace frana::app
