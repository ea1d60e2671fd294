// SPDX-License-Identifier: Apache-2.0
#include "app/input/layer_values.h"

#include <algorithm>
#include <set>

#include "core/text.h"
#include "gis/crs/crs.h"
#include "params/grammar/value_text.h"
#include "params/keys/plausible.h"
#include "params/keys/scene_parameters.h"

namespace frana::app {

gis::LayerChoice layer_choice(const SceneReading& reading, const LayerSpec& spec, const std::string& key) {
    return {spec.filter.value_or(""),
            spec.crs ? reading.session.read(gis::crs_from_user, *spec.crs, reading.where(key + "-crs")) : ""};
}

namespace {

/// The attributes in which any feature has a number.
std::string numeric_columns(const gis::PolygonLayer& layer) {
    std::set<std::string> names;
    for (const Feature& feature : layer.features)
        for (const auto& number : feature.numbers) names.insert(number.first);
    std::string known;
    for (const std::string& name : names) known += (known.empty() ? "" : ", ") + name;
    return known;
}

/// The number of a feature in a column. One text makes a column of numbers a column of texts.
std::optional<double> number_in(const Feature& feature, const std::string& column) {
    if (const auto number = feature.numbers.find(column); number != feature.numbers.end()) return number->second;
    const auto text = feature.texts.find(column);
    return text == feature.texts.end() ? std::nullopt : number_from_text(trimmed(text->second));
}

/// Why no feature has a number in a column: one problem for the whole layer.
Problem missing_column(const gis::PolygonLayer& layer, const std::string& column, const Place& where) {
    const bool is_text = std::any_of(layer.features.begin(), layer.features.end(),
                                     [&](const Feature& f) { return f.texts.count(column) > 0; });
    const std::string known = numeric_columns(layer);
    const std::string remedy =
        known.empty() ? "Give the layer a numeric attribute" : "Name one of its numeric attributes, or fill the column";
    return {(is_text ? "finds text, no number in the attribute " : "finds no number in the attribute ") + column +
                " of " + (layer.features.size() == 1 ? feature_name(layer, 0) : "any feature of " + layer.layer_name) +
                (known.empty() ? ", nor in another" : ""),
            where, "", known.empty() ? "" : "attributes with numbers: " + known, remedy};
}

/// The number that a feature has in the file, whatever part of the layer was read, as GDAL and QGIS count.
std::string feature_number(const gis::PolygonLayer& layer, std::size_t feature) {
    const std::string& condition = layer.conditions[feature];
    return condition.substr(condition.rfind(' ') + 1);
}

}  // namespace

std::string feature_name(const gis::PolygonLayer& layer, std::size_t feature) {
    return "feature " + feature_number(layer, feature) + " of " + layer.layer_name;
}

std::string target_crs(const SceneReading& reading, const TerrainInput* ground) {
    if (ground != nullptr) return ground->terrain.grid.crs_wkt;
    return reading.scene.terrain.crs == "local" ? "" : reading.session.read(gis::crs_from_user, "EPSG:4326", "");
}

bool within_limits(const SceneReading& reading, const std::string& key, double value, const std::string& what,
                   Problems& problems) {
    const std::vector<Parameter>& parameters = scene_parameters();
    const Parameter* const parameter = find_parameter(parameters, key);
    if (parameter == nullptr || !parameter->fits || parameter->fits(value)) return true;
    const PlausibleRange* const plausible = plausible_range(key);
    const bool meant = plausible != nullptr && plausible->is_refused && value > 0 && value < plausible->least;
    problems.add({what + " is out of range", reading.where(key),
                  shortest_text(value) + (parameter->unit.empty() ? "" : " " + parameter->unit), parameter->limits,
                  meant ? plausible->meant(value).text() : "Correct it in the file"});
    return false;
}

std::optional<double> value_of(const SceneReading& reading, const std::string& key, const SourceSpec& source,
                               const gis::PolygonLayer& layer, std::size_t feature, Problems& problems) {
    if (source.kind == SourceSpec::Kind::number) return source.number;
    const Feature& from = layer.features[feature];
    const std::optional<double> found = number_in(from, source.name);
    if (!found) {
        // Told once for the layer, not for each feature.
        const auto lacks = [&](const Feature& f) { return !number_in(f, source.name); };
        const auto first = std::find_if(layer.features.begin(), layer.features.end(), lacks) - layer.features.begin();
        if (first != static_cast<std::ptrdiff_t>(feature)) return std::nullopt;
        const auto lacking = std::count_if(layer.features.begin(), layer.features.end(), lacks);
        if (lacking == static_cast<std::ptrdiff_t>(layer.features.size())) {
            problems.add(missing_column(layer, source.name, reading.where(key)));
            return std::nullopt;
        }
        const bool is_text = from.texts.count(source.name) > 0;
        problems.add({(is_text ? "is no number in the attribute " : "is empty (NULL) in the attribute ") + source.name +
                          " of " + std::to_string(lacking) + " of " + std::to_string(layer.features.size()) +
                          " features of " + layer.layer_name + ", the first of them feature " +
                          feature_number(layer, feature),
                      reading.where(key), "", "a number in each", "Fill the column, or leave these features out"});
        return std::nullopt;
    }
    if (!within_limits(reading, key, *found, feature_name(layer, feature) + ", attribute " + source.name + ",",
                       problems))
        return std::nullopt;
    return found;
}

bool is_on_ground(const SceneReading& reading, const std::string& key, const Bounds& box, const TerrainInput& ground,
                  bool may_reach_beyond, Problems& problems) {
    const Bounds map = ground.terrain.grid.bounds();
    const bool apart = are_apart(map, box);
    if (is_within(box, map) || (may_reach_beyond && !apart)) return true;
    problems.add({apart ? "lies outside the DTM" : "reaches beyond the DTM", reading.where(key), extent_text(box),
                  "the working grid's " + extent_text(map) + ", in " + ground.crs_label,
                  apart ? "Check the coordinate reference systems of both files"
                        : "Take a larger DTM or terrain.bounds, or clip the layer"});
    return false;
}

}  // namespace frana::app
