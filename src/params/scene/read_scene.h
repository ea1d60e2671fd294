// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/error.h"
#include "params/keys/scene_spec.h"

namespace frana {

/// A scene as far as it could be read, and everything that is wrong with it.
struct SceneReading {
    SceneSpec scene;
    Problems problems;
    std::vector<std::string> warnings;  ///< keys given by a former name
    std::string label;                  ///< the scene file as the user named it

    /// Where a key was given, for messages: "scene.ini: terrain.dtm" or "--set terrain.dtm".
    [[nodiscard]] std::string where(const std::string& name) const {
        return scene.origin_of(name) == Origin::command_line ? "--set " + name : label + ": " + name;
    }
};

/// Reads a scene: defaults, then the material preset it names, then the file, then `overrides`
/// ("section.key=value", as on the command line). Relative paths count from the scene file's folder and
/// become absolute. Every problem is collected: unknown keys (with the nearest known), values, missing keys,
/// contradictions. Throws Error(input) only when the file itself cannot be read as INI.
SceneReading read_scene(const std::string& path, const std::vector<std::string>& overrides,
                        const std::string& materials_directory);

/// Files of the user's that a run of the scene reads, the scene file first.
std::vector<std::string> input_files(const SceneSpec& scene);
/// A file that a key names.
struct NamedFile {
    std::string key, path;
};
/// In the order of the keys; without the scene's own file.
std::vector<NamedFile> named_files(const SceneSpec& scene);

}  // namespace frana
