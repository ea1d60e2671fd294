// SPDX-License-Identifier: Apache-2.0
#include "app/ensemble/polygon_members.h"

#include <string>

#include "app/input/layer_choice.h"
#include "core/geometry.h"

namespace frana::app {

PolygonMembers polygon_members(const SceneReading& scene, Problems& problems) {
    PolygonMembers members;
    const ReleaseSpec& release = scene.scene.release;
    const std::string where = scene.where("release.perimeter");
    if (!release.perimeter) {
        problems.add({"is missing, and study.per-polygon = on takes its polygons", where, "", "a vector file",
                      "Name the file of the release perimeters"});
        return members;
    }
    const std::string key = "release.perimeter-filter", own = release.perimeter_layer.filter.value_or("");
    try {
        const gis::PolygonLayer layer = gis::read_polygons(
            *release.perimeter, "", where, layer_choice(scene, release.perimeter_layer, "release.perimeter"));
        members.table.keys = {key};
        members.table.nominal = {true};
        double largest = 0;
        for (std::size_t i = 0; i < layer.conditions.size(); ++i) {
            const std::string& condition = layer.conditions[i];
            members.table.values.push_back({own.empty() ? condition : "(" + own + ") AND " + condition});
            members.table.numbers.push_back({static_cast<double>(i)});
            members.table.weights.push_back(1);
            const double size = area(layer.features[i].parts);
            if (size > largest) members.largest = i;
            largest = std::max(largest, size);
        }
    } catch (const Error& error) {
        problems.add(error);
    }
    return members;
}

}  // namespace frana::app
