// SPDX-License-Identifier: Apache-2.0
#include "app/store/provenance.h"

#include <filesystem>

#include "app/text/text_hash.h"
#include "app/text/version.h"
#include "core/utf8.h"
#include "params/grammar/absolute_path.h"
#include "params/keys/scene_parameters.h"
#include "params/scene/write_scene.h"

namespace frana::app {

SceneSpec seen_from(SceneSpec scene, const std::string& folder) {
    for (const Parameter& parameter : scene_parameters())
        if (parameter.reads_files())
            parameter.map_files(scene, [&](const std::string& path) { return relative_path(path, folder); });
    return scene;
}

std::string echoed_scene(const Prepared& prepared) {
    if (prepared.result_folder.empty()) return echoed_scene_here(prepared);
    Prepared moved;
    moved.spec = seen_from(prepared.spec, prepared.result_folder);
    moved.resolved = prepared.resolved;
    return echoed_scene_here(moved);
}

std::string echoed_scene_here(const Prepared& prepared) {
    SceneSpec spec = prepared.spec;
    // The echo is in another folder: values derived from the scene file's own name must be written out.
    spec.output.title = spec.output.title.value_or(scene_name(spec));
    // The directory contains this result now; a repeated run uses its own unless specified.
    spec.output.directory.reset();
    return scene_text(spec, prepared.resolved);
}

namespace {

/// The scene with the names of its files alone: the same wherever they and the result lie.
std::string scene_without_places(const Prepared& prepared) {
    Prepared named;
    named.spec = prepared.spec;
    for (const Parameter& parameter : scene_parameters())
        if (parameter.reads_files())
            parameter.map_files(
                named.spec, [](const std::string& path) { return std::filesystem::path(path).filename().string(); });
    named.resolved = prepared.resolved;
    return echoed_scene_here(named);
}

}  // namespace

std::map<std::string, std::string> provenance(const Prepared& prepared) {
    return {{"PROGRAM", k_program},
            {"VERSION", k_version},
            {"SCENE", valid_utf8(scene_name(prepared.spec))},
            {"SCENE_HASH", text_hash(scene_without_places(prepared))},
            {"TIFFTAG_SOFTWARE", std::string(k_program) + " " + k_version}};
}

}  // namespace frana::app
