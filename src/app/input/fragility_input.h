// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "analysis/fragility.h"
#include "app/input/used_file.h"
#include "core/error.h"
#include "gis/vector/vector_in.h"
#include "params/scene/read_scene.h"

namespace frana::app {

/// Returns the classes of a CSV file with a row for each state of damage (share/doc/region.md). Adds every problem that
/// it finds; then the classes may be incomplete. Throws Error(input) if the file is no table.
std::vector<FragilityClass> read_fragility(const std::string& path, const Place& where, Problems& problems);

/// Returns what a scene's exposed features are worth and how they break, and adds the file to those used. Throws
/// Error(input) if the file or a column cannot be used.
Fragility fragility_of(const SceneReading& reading, const gis::FeatureLayer& layer, std::vector<UsedFile>& files);

}  // namespace frana::app
