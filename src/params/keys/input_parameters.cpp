// SPDX-License-Identifier: Apache-2.0
#include "params/keys/input_parameters.h"

#include <algorithm>

#include "params/keys/declare.h"

namespace frana {
namespace {

using declare::number;
using declare::Range;
using declare::text;

void insert(std::vector<Parameter>& list, const Parameter& parameter) {
    const auto last =
        std::find_if(list.rbegin(), list.rend(), [&](const Parameter& p) { return p.section == parameter.section; });
    list.insert(last.base(), parameter);
}

/// KEY-layer, KEY-filter and KEY-crs: how to read the vector file of KEY. `layer`: the LayerSpec of a scene.
template <class Layer>
void add_layer_choice(std::vector<Parameter>& list, const std::string& key, Layer layer) {
    insert(list, text(
                     key + "-layer", [=](auto& scene) -> auto& { return layer(scene).name; }, "text",
                     "Layer to read if the file contains several.", "the only one with areas"));
    insert(list, text(
                     key + "-filter", [=](auto& scene) -> auto& { return layer(scene).filter; }, "text",
                     "Condition on the attributes, as in SQL: kind = 'scar' AND year > 2000.", "all features"));
    insert(list, text(
                     key + "-crs", [=](auto& scene) -> auto& { return layer(scene).crs; }, "text",
                     "CRS, if the file names none or a wrong one.", "the file's own"));
}

}  // namespace

void add_input_parameters(std::vector<Parameter>& list) {
    insert(list,
           number(
               "terrain.nodata-value", [](auto& scene) -> auto& { return scene.terrain.nodata_value; }, "",
               Range{-1e300, 1e300}, "Additional stored value that means no elevation, such as 0 around the edge.",
               "only what the file declares"));
    add_layer_choice(
        list, "release.perimeter", [](auto& scene) -> auto& { return scene.release.perimeter_layer; });
    insert(list, text(
                     "release.thickness-crs", [](auto& scene) -> auto& { return scene.release.thickness_crs; }, "text",
                     "CRS of the thickness rasters, if they name none or a wrong one.", "the files' own"));
    add_layer_choice(
        list, "observed.perimeter", [](auto& scene) -> auto& { return scene.observed.perimeter_layer; });
}

}  // namespace frana
