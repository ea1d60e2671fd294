// SPDX-License-Identifier: Apache-2.0
#include "app/ensemble/polygon_members.h"

#include <filesystem>
#include <map>
#include <set>

#include "app/input/layer_choice.h"
#include "core/shortest_text.h"
#include "params/grammar/nearest_name.h"
#include "params/grammar/value_text.h"
#include "params/keys/scene_parameters.h"
#include "study/read_study.h"

namespace frana::app {
namespace {

std::optional<std::string> text_in(const PolygonFeature& feature, const std::string& column) {
    if (const auto text = feature.texts.find(column); text != feature.texts.end()) {
        const std::string value = trimmed(text->second);
        if (value.empty()) return std::nullopt;
        return value;
    }
    if (const auto number = feature.numbers.find(column); number != feature.numbers.end())
        return shortest_text(number->second);
    return std::nullopt;
}

/// A column that no polygon has is mistyped.
void require_columns(const study::RegionSpec& region, const gis::PolygonLayer& layer, const std::string& label,
                     Problems& problems) {
    std::set<std::string> known;
    for (const PolygonFeature& feature : layer.features) {
        for (const auto& [name, value] : feature.numbers) known.insert(name);
        for (const auto& [name, value] : feature.texts) known.insert(name);
    }
    const std::vector<std::string> names(known.begin(), known.end());
    const auto require = [&](const std::string& key, const std::string& column) {
        if (known.count(column) > 0) return;
        const std::string nearest = nearest_name(column, names);
        problems.add({"is no column in which a polygon of the release perimeter has a value", label + ": " + key,
                      column, "",
                      !nearest.empty() ? "Did you mean " + nearest + "?"
                      : names.empty()  ? "The layer has no attributes"
                                       : "Its columns are " + joined(names, ", ")});
    };
    for (const auto& [key, column] :
         {std::pair{"region.name", region.name}, std::pair{"region.group", region.group},
          std::pair{"region.scenario", region.scenario}, std::pair{"region.return-period", region.return_period}})
        if (column) require(key, *column);
    for (const study::RegionSpec::Column& one : region.columns) require("columns." + one.key, one.column);
}

Slope slope_of(const study::RegionSpec& region, const PolygonFeature& feature) {
    Slope slope;
    const auto word = [&](const std::optional<std::string>& column) {
        return column ? text_in(feature, *column).value_or("") : "";
    };
    slope.name = word(region.name);
    slope.group = word(region.group);
    slope.scenario = word(region.scenario);
    if (region.scenario && slope.scenario.empty()) slope.problem = "column " + *region.scenario + " has no value";
    if (!region.return_period) return slope;
    const std::string years = word(region.return_period);
    slope.return_period = number_from_text(years);
    if (years.empty())
        slope.problem = "column " + *region.return_period + " has no value";
    else if (!slope.return_period || !(*slope.return_period > 0))
        slope.problem = "column " + *region.return_period + " has no return period: " + years;
    return slope;
}

void require_one_period(const std::vector<Slope>& slopes, const std::string& label, Problems& problems) {
    std::map<std::string, std::set<double>> periods;
    for (const Slope& slope : slopes)
        if (slope.return_period && !slope.scenario.empty()) periods[slope.scenario].insert(*slope.return_period);
    for (const auto& [scenario, all] : periods) {
        if (all.size() < 2) continue;
        problems.add({"gives scenario " + scenario + " several return periods", label + ": region.return-period",
                      shortest_text(*all.begin()) + " and " + shortest_text(*all.rbegin()) + " years",
                      "one for each scenario", "Correct the column, or give the events different scenarios"});
    }
}

/// Adds the columns of a region to the values of its members.
void add_columns(const study::StudySpec& study, const gis::PolygonLayer& layer, PolygonMembers& members) {
    const study::RegionSpec& region = *study.region;
    const std::vector<Parameter>& parameters = scene_parameters();
    const std::string folder = std::filesystem::path(study.file).parent_path().string();
    for (const study::RegionSpec::Column& one : region.columns) {
        members.table.keys.push_back(one.key);
        members.table.nominal.push_back(true);
    }
    for (std::size_t i = 0; i < layer.features.size(); ++i) {
        Slope slope = slope_of(region, layer.features[i]);
        if (!layer.unusable[i].empty()) slope.problem = layer.unusable[i];
        for (const study::RegionSpec::Column& one : region.columns) {
            const auto text = text_in(layer.features[i], one.column);
            if (!text) slope.problem = "column " + one.column + " for " + one.key + " has no value";
            members.table.values[i].push_back(
                text ? study::with_absolute_paths(*find_parameter(parameters, one.key), *text, folder) : "");
            members.table.numbers[i].push_back(text ? number_from_text(*text).value_or(0) : 0);
        }
        members.slopes.push_back(std::move(slope));
    }
}

}  // namespace

PolygonMembers polygon_members(const study::StudySpec& study, const std::string& label, const SceneReading& scene,
                               Problems& problems) {
    PolygonMembers members;
    const ReleaseSpec& release = scene.scene.release;
    const std::string where = scene.where("release.perimeter");
    if (!release.perimeter) {
        problems.add({"is missing, and " + std::string(study.region ? "a region" : "study.per-polygon = on") +
                          " takes its polygons",
                      where, "", "a vector file", "Name the file of the release perimeters"});
        return members;
    }
    const std::string key = "release.perimeter-filter", own = release.perimeter_layer.filter.value_or("");
    try {
        gis::LayerChoice choice = layer_choice(scene, release.perimeter_layer, "release.perimeter");
        choice.keep_unusable = study.region.has_value();
        const gis::PolygonLayer layer = gis::read_polygons(*release.perimeter, "", where, choice);
        members.table.keys = {key};
        members.table.nominal = {true};
        for (std::size_t i = 0; i < layer.conditions.size(); ++i) {
            const std::string& condition = layer.conditions[i];
            members.table.values.push_back({own.empty() ? condition : "(" + own + ") AND " + condition});
            members.table.numbers.push_back({static_cast<double>(i)});
            members.table.weights.push_back(1);
            members.sizes.push_back(area(layer.features[i].parts));
        }
        if (!study.region) return members;
        require_columns(*study.region, layer, label, problems);
        add_columns(study, layer, members);
        require_one_period(members.slopes, label, problems);
    } catch (const Error& error) {
        problems.add(error);
    }
    return members;
}

}  // namespace frana::app
