// SPDX-License-Identifier: Apache-2.0
#include "app/input/layer_values.h"

#include <algorithm>
#include <cmath>

#include "app/text/number_text.h"
#include "core/shortest_text.h"
#include "gis/crs/crs.h"
#include "params/keys/scene_parameters.h"

namespace frana::app {
namespace {

std::string columns_of(const PolygonFeature& feature) {
    std::string known;
    for (const auto& number : feature.numbers) known += (known.empty() ? "" : ", ") + number.first;
    return known.empty() ? "the layer has no numeric attribute" : known;
}

}  // namespace

std::string target_crs(const SceneReading& reading, const TerrainInput* ground) {
    if (ground != nullptr) return ground->terrain.grid.crs_wkt;
    return reading.scene.terrain.crs == "local" ? "" : gis::crs_from_user("EPSG:4326", "");
}

bool within_limits(const SceneReading& reading, const std::string& key, double value, const std::string& what,
                   Problems& problems) {
    const std::vector<Parameter> parameters = scene_parameters();
    const Parameter* const parameter = find_parameter(parameters, key);
    if (parameter == nullptr || !parameter->fits || parameter->fits(value)) return true;
    problems.add({what + " is out of range", reading.where(key),
                  shortest_text(value) + (parameter->unit.empty() ? "" : " " + parameter->unit), parameter->limits,
                  "Correct it in the file"});
    return false;
}

std::optional<double> value_of(const SceneReading& reading, const std::string& key, const SourceSpec& source,
                               const gis::PolygonLayer& layer, std::size_t feature, Problems& problems) {
    if (source.kind == SourceSpec::Kind::number) return source.number;
    const PolygonFeature& from = layer.features[feature];
    const std::string name = "feature " + std::to_string(feature + 1) + " of " + layer.layer_name;
    const auto found = from.numbers.find(source.name);
    if (found == from.numbers.end()) {
        // A column that only some features have a number in is told once, not for each of them.
        const auto lacks = [&](const PolygonFeature& f) { return f.numbers.count(source.name) == 0; };
        const auto lacking = std::count_if(layer.features.begin(), layer.features.end(), lacks);
        if (lacking < static_cast<std::ptrdiff_t>(layer.features.size())) {
            if (std::find_if(layer.features.begin(), layer.features.end(), lacks) - layer.features.begin() !=
                static_cast<std::ptrdiff_t>(feature))
                return std::nullopt;
            problems.add({"is empty (NULL) in the attribute " + source.name + " of " + std::to_string(lacking) +
                              " of " + std::to_string(layer.features.size()) + " features of " + layer.layer_name +
                              ", the first of them feature " + std::to_string(feature + 1),
                          reading.where(key), "", "a number in each", "Fill the column, or leave these features out"});
            return std::nullopt;
        }
        problems.add({name + " has no number in the attribute " + source.name, reading.where(key), "", columns_of(from),
                      "Name one of its attributes"});
        return std::nullopt;
    }
    if (!within_limits(reading, key, found->second, name + ", attribute " + source.name + ",", problems))
        return std::nullopt;
    return found->second;
}

bool is_on_ground(const SceneReading& reading, const std::string& key, const Bounds& box, const TerrainInput& ground,
                  bool may_reach_beyond, Problems& problems) {
    const Bounds map = ground.terrain.grid.bounds();
    const bool apart = box.east <= map.west || box.west >= map.east || box.north <= map.south || box.south >= map.north;
    const bool within =
        box.west >= map.west && box.east <= map.east && box.south >= map.south && box.north <= map.north;
    if (within || (may_reach_beyond && !apart)) return true;
    problems.add({apart ? "lies outside the DTM" : "reaches beyond the DTM", reading.where(key), extent_text(box),
                  "the working grid's " + extent_text(map) + ", in " + ground.crs_label,
                  apart ? "Check the coordinate reference systems of both files"
                        : "Clip the layer, or take a larger DTM or terrain.bounds"});
    return false;
}

}  // namespace frana::app
