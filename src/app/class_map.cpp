// SPDX-License-Identifier: Apache-2.0
#include "app/class_map.h"

#include "app/version.h"

namespace frana::app {

void draw_class_map(const MapSource& source, const std::string& what, const std::string& legend,
                    const Raster& classes, const std::vector<render::ClassLabel>& categories,
                    const std::string& path) {
    render::MapSpec spec;
    spec.title = source.title + ": " + what;
    spec.subtitle = source.subtitle;
    spec.legend_title = legend;
    spec.attribution = std::string("Simulated with ") + k_program + " " + k_version;
    spec.terrain = source.terrain.values.empty() ? nullptr : &source.terrain;
    spec.layer = &classes;
    spec.categories = categories;
    if (!source.release.empty())
        spec.outlines.push_back({"Release", source.release, {20, 20, 20}, 2.5, true});
    if (!source.scar.empty()) spec.outlines.push_back({"Surveyed scar", source.scar, {120, 0, 80}, 3, false});
    spec.side_notes = source.notes;
    spec.convergence_deg = source.convergence_deg;
    spec.crs_label = source.crs_label;
    spec.width = source.size.width;
    spec.height = source.size.height;
    render::write_png(path, render::draw_map(spec));
}

}  // namespace frana::app
