// SPDX-License-Identifier: Apache-2.0
#include "params/scene/read_keys.h"

#include "params/check/check_scene.h"
#include "params/keys/former_names.h"
#include "params/keys/scene_parameters.h"
#include "params/scene/scene_reader.h"

namespace frana {

SceneReading read_scene_keys(const std::vector<std::string>& keys, const std::vector<std::string>& given,
                             const std::string& materials_directory, const std::string& label) {
    SceneReading reading;
    reading.label = label;
    const KeySource source = override_source(keys, reading.override_label, reading.problems);
    SceneReader reader(reading, "");
    reader.apply_preset(source, {}, materials_directory);
    reader.apply(source);
    reader.drop_unread_of_preset();
    std::set<std::string> all = reader.given();
    all.insert(given.begin(), given.end());
    check_scene(reading.scene, all, label, reading.problems);
    return reading;
}

std::optional<Problem> problem_of_key(const std::string& name, const std::string& value) {
    const std::vector<Parameter>& parameters = scene_parameters();
    const Parameter* const parameter = find_parameter(parameters, present_name(name));
    if (parameter == nullptr) return unknown_key(parameters, name, name);
    SceneSpec scene;
    return read_value(*parameter, name, value, scene);
}

}  // namespace frana
