// SPDX-License-Identifier: Apache-2.0
#include "app/pictures/exposure_marks.h"

#include <cmath>
#include <filesystem>

#include "app/store/result_files.h"
#include "app/store/vector_layers.h"
#include "app/text/number_text.h"
#include "gis/vector/exposed_in.h"
#include "gis/vector/vector_in.h"

namespace frana::app {
namespace {

/// The features of all layers of the file.
std::vector<gis::ExposedFeature> features_of(const std::string& gpkg, const std::string& crs_wkt) {
    std::vector<gis::ExposedFeature> all;
    for (const VectorLayer& row : vector_layers()) {
        if (row.file != k_exposure_file || !gis::has_layer(gpkg, row.name, "RESULT_DIR")) continue;
        gis::ExposedLayer layer = gis::read_exposed(gpkg + "|layer=" + row.name, crs_wkt, "RESULT_DIR", "", "");
        for (gis::ExposedFeature& one : layer.features) all.push_back(std::move(one));
    }
    return all;
}

/// Whether the attribute of a feature is that of a look; NULL is NaN.
bool has_value(const gis::ExposedFeature& feature, double value) {
    const auto found = feature.numbers.find(k_reached);
    const double own = found == feature.numbers.end() ? k_no_data : found->second;
    return own == value || (std::isnan(own) && std::isnan(value));
}

void add(const MixedShape& shape, render::Outline& outline) {
    outline.polygons.insert(outline.polygons.end(), shape.areas.begin(), shape.areas.end());
    outline.lines.insert(outline.lines.end(), shape.lines.begin(), shape.lines.end());
    for (const Point& place : shape.points) outline.places.push_back({"", place});
}

}  // namespace

std::vector<render::Outline> exposure_marks(const std::string& gpkg, const std::string& crs_wkt, const Words& words) {
    std::vector<render::Outline> marks;
    if (!std::filesystem::exists(gpkg)) return marks;
    const std::vector<gis::ExposedFeature> features = features_of(gpkg, crs_wkt);
    const std::vector<ExposureLook>& looks = exposure_looks();
    for (auto look = looks.rbegin(); look != looks.rend(); ++look) {
        render::Outline outline{"", {}, look->colour, look->width_px, look->dashed};
        std::size_t count = 0;
        for (const gis::ExposedFeature& one : features) {
            if (one.shape.empty() || !has_value(one, look->reached)) continue;
            add(one.shape, outline);
            ++count;
        }
        if (count == 0) continue;
        outline.label = words.labelled(words(look->label), words.number(grouped(static_cast<double>(count))));
        marks.push_back(std::move(outline));
    }
    return marks;
}

}  // namespace frana::app
