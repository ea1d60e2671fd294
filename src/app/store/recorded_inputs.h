// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/input/prepare.h"
#include "app/text/run_log.h"
#include "params/scene/read_scene.h"

namespace frana::app {

/// Returns inputs.json of a result: each file that a key of the scene names, with its place relative to the result, its
/// absolute place at the time, and the checksum of its bytes (of files up to 1 GB). With the files beside it that
/// belong to it (shapefile, .prj, world file).
std::string recorded_inputs(const Prepared& prepared);
/// The same of a result in `folder` (empty: not known yet) for other files, each once.
std::string recorded_inputs(const std::vector<NamedFile>& files, const std::string& folder);

/// Names those of the files whose content is not that recorded in inputs.json of a result's folder, which may have
/// been moved with them: what is computed from them is not that result.
/// @param where names a key in messages
Warnings changed_inputs(const std::vector<NamedFile>& files, const std::string& folder,
                        const std::function<std::string(const std::string& key)>& where);
/// The same for a scene file of a result, or of a member of a study's, without the keys that the command line sets.
Warnings changed_inputs(const SceneReading& reading);
/// The same for the scene of a study.
Warnings changed_inputs(const std::string& study_file, const SceneReading& scene);

}  // namespace frana::app
