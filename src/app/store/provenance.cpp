// SPDX-License-Identifier: Apache-2.0
#include "app/store/provenance.h"

#include <filesystem>

#include "app/text/text_hash.h"
#include "app/text/version.h"
#include "core/utf8.h"
#include "gis/raster/raster_text.h"
#include "params/grammar/absolute_path.h"
#include "params/keys/result_rasters.h"
#include "params/keys/scene_parameters.h"
#include "params/scene/write_scene.h"

namespace frana::app {
namespace {

std::string echo(const SceneSpec& scene, const std::map<std::string, std::string>& resolved) {
    SceneSpec spec = scene;
    // The echo is in another folder: values derived from the scene file's own name must be written out.
    spec.output.title = spec.output.title.value_or(scene_name(spec));
    // The directory contains this result now; a repeated run uses its own unless specified.
    spec.output.directory.reset();
    return scene_text(spec, resolved);
}

}  // namespace

SceneSpec seen_from(SceneSpec scene, const std::string& folder) {
    for (const Parameter& parameter : scene_parameters())
        if (parameter.reads_files())
            parameter.map_files(scene, [&](const std::string& path) { return relative_path(path, folder); });
    return scene;
}

SceneSpec without_places(SceneSpec scene) {
    for (const Parameter& parameter : scene_parameters())
        if (parameter.reads_files())
            parameter.map_files(
                scene, [](const std::string& path) { return std::filesystem::path(path).filename().string(); });
    return scene;
}

std::string echoed_scene(const Prepared& prepared) {
    const std::string& folder = prepared.result_folder;
    return echo(folder.empty() ? prepared.spec : seen_from(prepared.spec, folder), prepared.resolved);
}

std::string echoed_scene(const SceneSpec& scene, const std::string& folder) {
    return echo(seen_from(scene, folder), {});
}

std::string echoed_scene_without_places(const Prepared& prepared) {
    return echo(without_places(prepared.spec), prepared.resolved);
}

std::map<std::string, std::string> provenance(const Prepared& prepared) {
    return {{"PROGRAM", k_program},
            {"VERSION", k_version},
            {"SCENE", valid_utf8(scene_name(prepared.spec))},
            {"SCENE_HASH", text_hash(echoed_scene_without_places(prepared))},
            {gis::k_depth_item, prepared.spec.output.depth == k_normal_depth ? k_normal : k_vertical},
            {"TIFFTAG_SOFTWARE", std::string(k_program) + " " + k_version}};
}

}  // namespace frana::app
