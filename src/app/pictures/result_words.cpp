// SPDX-License-Identifier: Apache-2.0
// What a result's own scene and outlines say besides their values.
#include "app/pictures/result_reader.h"
#include "gis/vector/vector_in.h"
#include "params/keys/scene_parameters.h"

namespace frana::app {

ClassSpec ResultReader::classes() const {
    static const std::vector<Parameter> k_keys = scene_parameters();
    SceneSpec scene;
    for (const Parameter& key : k_keys)
        if (key.name().starts_with("output.classes"))
            if (const auto text = scene_value(key.name())) key.read(scene, *text);
    return scene.output.classes;
}

std::vector<std::string> ResultReader::release_names(const std::string& crs_wkt) const {
    const std::string file = path(k_outlines_file);
    if (!has(k_outlines_file) || !gis::has_layer(file, "release", "RESULT_DIR")) return {};
    std::vector<std::string> names;
    bool named = false;  // else these are the areas' numbers
    for (const PolygonFeature& one : gis::read_polygons(file + "|layer=release", crs_wkt, "RESULT_DIR").features) {
        const auto name = one.texts.find("name");
        if (name == one.texts.end()) return {};
        names.push_back(name->second);
        named = named || name->second != std::to_string(names.size());
    }
    if (!named) names.clear();
    return names;
}

}  // namespace frana::app
