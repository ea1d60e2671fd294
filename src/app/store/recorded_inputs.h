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

/// For a scene file of a result, which may have been moved: compares its inputs with inputs.json beside it, or of the
/// study whose member it is. A file
/// that is missing is taken from its place at the time if that has the same content; another content is warned of. A
/// key that the command line sets is not compared. Throws Error(input) with every file that is missing, its key,
/// checksum and the places where it was sought.
void find_recorded_inputs(SceneReading& reading, RunLog& log);
/// A text that names inputs: a scene, a study.
struct NamingText {
    /// Maps the path that a key names to another.
    using FileMap = std::function<std::string(const std::string& key, const std::string& path)>;

    std::function<void(const FileMap&)> map_files;             ///< replaces each file by what the map returns
    std::function<std::string(const std::string& key)> where;  ///< for messages
    std::function<bool(const std::string& key)> is_replaced;   ///< by the command line
    bool is_study = false;                                     ///< no key of it can be set on the command line
    bool warns_only = false;                                   ///< files are missed elsewhere
};

/// The same for any text in a result's folder.
void find_recorded_files(const NamingText& text, const std::string& folder, RunLog& log);

/// Warns of files named by the scene of a study whose content is not that recorded beside the study file.
void warn_of_changed_inputs(const std::string& study_file, const SceneReading& scene, RunLog& log);

}  // namespace frana::app
