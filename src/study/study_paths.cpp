// SPDX-License-Identifier: Apache-2.0
// Paths in a study file: absolute where it is used, relative where it is echoed.
#include "params/grammar/absolute_path.h"
#include "params/keys/scene_parameters.h"
#include "study/read_calibration.h"
#include "study/read_study.h"

namespace frana::study {
namespace {

std::string with_mapped_paths(const Parameter& parameter, const std::string& value, const FileMap& map) {
    SceneSpec scene;
    if (!parameter.map_files || parameter.read(scene, value)) return value;
    parameter.map_files(scene, map);
    return parameter.write(scene).value_or(value);
}

}  // namespace

std::string with_absolute_paths(const Parameter& parameter, const std::string& value, const std::string& folder) {
    return with_mapped_paths(parameter, value, [&](const std::string& path) { return absolute_path(path, folder); });
}

std::string with_files(const std::string& key, const std::string& value, const KeyedFileMap& map) {
    // A folder is where something is written, no input.
    static const std::vector<Parameter>& k_keys = scene_parameters();
    const Parameter* const parameter = find_parameter(k_keys, key);
    if (parameter == nullptr || !parameter->reads_files()) return value;
    return with_mapped_paths(*parameter, value, [&](const std::string& path) { return map(key, path); });
}

std::vector<std::string> with_files(std::vector<std::string> set, const KeyedFileMap& map) {
    for (std::string& one : set) {
        const auto equals = one.find('=');
        const std::string key = one.substr(0, equals);
        one = key + "=" + with_files(key, one.substr(equals + 1), map);
    }
    return set;
}

std::vector<Variation> with_files(std::vector<Variation> vary, const KeyedFileMap& map) {
    for (Variation& one : vary)
        for (std::string& value : one.distribution.values) value = with_files(one.key, value, map);
    return vary;
}

StudySpec with_files(StudySpec study, const KeyedFileMap& map) {
    if (!study.scene.empty()) study.scene = map("study.scene", study.scene);
    if (!study.table.empty()) study.table = map("study.sampling", study.table);
    study.set = with_files(std::move(study.set), map);
    study.vary = with_files(std::move(study.vary), map);
    return study;
}

StudySpec seen_from(StudySpec study, const std::string& folder) {
    return with_files(std::move(study),
                      [&](const std::string&, const std::string& path) { return relative_path(path, folder); });
}

CalibrationSpec with_files(CalibrationSpec calibration, const KeyedFileMap& map) {
    calibration.study = with_files(std::move(calibration.study), map);
    for (EventSpec& event : calibration.events) {
        event.set = with_files(std::move(event.set), map);
        event.vary = with_files(std::move(event.vary), map);
        event.members.study = with_files(std::move(event.members.study), map);
    }
    return calibration;
}

CalibrationSpec seen_from(CalibrationSpec calibration, const std::string& folder) {
    return with_files(std::move(calibration),
                      [&](const std::string&, const std::string& path) { return relative_path(path, folder); });
}

}  // namespace frana::study
