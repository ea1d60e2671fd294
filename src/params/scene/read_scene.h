// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/session.h"
#include "core/words/sentence.h"
#include "params/keys/scene_spec.h"

namespace frana {

/// A scene as far as it could be read, with all its problems.
struct SceneReading {
    SceneSpec scene;
    Session session;
    Problems problems;
    std::vector<Sentence> warnings;  ///< keys given by a former name
    std::string label;               ///< the scene file as the user named it
    std::string override_label;      ///< before the name of a key that was overridden: "--set "

    std::map<std::string, std::string> written;  ///< by the key's name: the second name under which it was given

    /// Returns where a key was given, for messages, in the words of the user: "scene.ini: terrain.dtm" or "--set
    /// terrain.dtm".
    [[nodiscard]] std::string where(const std::string& name) const {
        const auto second = written.find(name);
        return (scene.origin_of(name) == Origin::command_line ? override_label : label + ": ") +
               (second == written.end() ? name : second->second);
    }
};

/// Reads a scene: defaults, then the material preset it names, then the file, then `overrides` ("section.key=value", as
/// on the command line). Relative paths are relative to the scene file's folder and become absolute. Every problem is
/// collected: unknown keys (with the nearest known), values, missing keys, contradictions. Throws Error(input) only if
/// the file itself cannot be read as INI.
/// @param override_label before the names of overridden keys in messages
SceneReading read_scene(const std::string& path, const std::vector<std::string>& overrides,
                        const std::string& materials_directory, const std::string& override_label = "--set ");

/// Returns the input files of a scene, the scene file first.
std::vector<std::string> input_files(const SceneSpec& scene);
/// A file named by a key.
struct NamedFile {
    std::string key, path;
};
/// Returns the files named by keys, in the order of the keys; without the scene file itself.
std::vector<NamedFile> named_files(const SceneSpec& scene);

}  // namespace frana
