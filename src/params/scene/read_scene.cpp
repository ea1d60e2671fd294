// SPDX-License-Identifier: Apache-2.0
#include "params/scene/read_scene.h"

#include <filesystem>

#include "params/check/check_scene.h"
#include "params/keys/scene_parameters.h"
#include "params/scene/scene_reader.h"

namespace frana {

namespace fs = std::filesystem;

std::vector<NamedFile> named_files(const SceneSpec& scene) {
    std::vector<NamedFile> files;
    SceneSpec copy = scene;
    for (const Parameter& parameter : scene_parameters()) {
        if (!parameter.reads_files()) continue;
        parameter.map_files(copy, [&](const std::string& path) {
            files.push_back({parameter.name(), path});
            return path;
        });
    }
    return files;
}

std::vector<std::string> input_files(const SceneSpec& scene) {
    std::vector<std::string> files{scene.file};
    for (const NamedFile& named : named_files(scene)) files.push_back(named.path);
    return files;
}

SceneReading read_scene(const std::string& path, const std::vector<std::string>& overrides,
                        const std::string& materials_directory, const std::string& override_label) {
    SceneReading reading;
    reading.label = path;
    reading.override_label = override_label;
    const fs::path absolute = fs::absolute(path).lexically_normal();
    reading.scene.file = absolute.string();
    if (has_control_characters(reading.scene.file)) {
        throw Error(ErrorKind::input,
                    Problem{"the scene's path contains a line break or another control character, "
                            "which the result's own scene file cannot contain",
                            without_control_characters(path), without_control_characters(reading.scene.file), "",
                            "Rename the file or folder"});
    }

    const KeySource file{Origin::scene_file, path, read_ini(path)};
    const KeySource command_line = override_source(overrides, override_label, reading.problems);
    SceneReader reader(reading, absolute.parent_path().string());
    reader.apply_preset(command_line, file, materials_directory);
    reader.apply(file);
    reader.apply(command_line);
    reader.drop_unread_of_preset();
    check_scene(reading.scene, reader.given(), path, reading.problems);
    return reading;
}

}  // namespace frana
