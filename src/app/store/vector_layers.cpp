// SPDX-License-Identifier: Apache-2.0
#include "app/store/vector_layers.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include "app/store/result_files.h"
#include "app/text/number_text.h"
#include "core/colour.h"
#include "core/words/words.h"
#include "gis/vector/vector_style.h"
#include "params/keys/result_rasters.h"
#include "simulation/run_summary.h"

namespace frana::app {
namespace {

// The number of colours distinguishable in a legend.
constexpr int k_classes = 8;

/// Returns the greatest of some factors (rising, the first 1) times a power of ten below a value; with a small
/// tolerance, so that 0.3 is not below 3 tenths.
double round_below(double value, std::initializer_list<double> factors) {
    const double limit = value * (1 - 1e-9);
    const double decade = std::pow(10.0, std::floor(std::log10(limit)));
    double best = decade;
    for (const double factor : factors)
        if (factor * decade < limit) best = factor * decade;
    return best;
}

/// Returns the least round number that is not below a value.
double round_above(double value) {
    const double decade = std::pow(10.0, std::floor(std::log10(value)));
    for (const double factor : {1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0})
        if (factor * decade >= value * (1 - 1e-9)) return factor * decade;
    return 10 * decade;
}

/// From a round number above the maximum downwards: 40, 30, 20, 10, then 5, 2, 1, 0.5 ... and finally 0.
std::vector<double> progressive_classes(double maximum) {
    const double top = round_above(maximum);
    const double decade = std::pow(10.0, std::floor(std::log10(top * (1 + 1e-9))));
    std::vector<double> bounds{top};
    while (bounds.size() < k_classes) {
        const double last = bounds.back();
        bounds.push_back(last > decade * (1 + 1e-9) ? round_below(last, {1, 2, 3, 5}) : round_below(last, {1, 2, 5}));
    }
    bounds.push_back(0);
    return {bounds.rbegin(), bounds.rend()};
}

}  // namespace

std::vector<ResultRaster> main_rasters() {
    std::vector<ResultRaster> rows = result_rasters();
    std::erase_if(rows,
                  [](const ResultRaster& row) { return row.kind != ResultRaster::Kind::flow || !row.when.empty(); });
    return rows;
}

std::vector<double> class_bounds(const ResultRaster& row, double maximum) {
    if (!row.bounds.empty()) return row.bounds;
    std::vector<double> bounds = fixed_classes(row.classes);
    constexpr std::size_t k_fewest = 5;  // bounds: fewer show nothing of a flow
    const auto last = std::find_if(bounds.begin(), bounds.end(), [&](double bound) { return bound >= maximum; });
    if (last != bounds.end()) bounds.erase(last + 1, bounds.end());
    return bounds.size() >= k_fewest ? bounds : class_bounds(row.progressive, maximum);
}

std::vector<double> class_bounds(const ResultRaster& row, const Raster& values, const Raster& release) {
    double moved = k_no_data, all = k_no_data;
    values.values.for_each_stored([&](std::size_t cell, double value) {
        all = std::fmax(all, value);
        if (!(release.values[cell] > 0)) moved = std::fmax(moved, value);
    });
    std::vector<double> bounds = class_bounds(row, moved > 0 ? moved : all);
    if (row.bounds.empty() && all > bounds.back()) bounds.push_back(std::numeric_limits<double>::infinity());
    return bounds;
}

std::vector<double> class_bounds(bool progressive, double maximum) {
    if (!(maximum > 0)) return nice_classes(0, k_classes);
    return progressive ? progressive_classes(maximum) : nice_classes(maximum, k_classes);
}

namespace {

using gis::Shape;

const std::string k_name = "name";  // attribute that labels a feature

/// Attributes of the layers, besides the names of rasters.
struct Attribute {
    const char *name, *title, *unit = "";
};
constexpr Attribute k_attributes[] = {
    {"name", worded("Name")},
    {"area_m2", worded("Area"), "m²"},
    {"length_m", worded("Length"), "m"},
    {"threshold_m", worded("Depth threshold"), "m"},
    {"thickness_vertical_m", worded("Thickness, vertical"), "m"},
    {"thickness_normal_m", worded("Thickness, normal to the bed"), "m"},
    {"volume_m3", worded("Volume"), "m³"},
    {"start_s", worded("Start"), "s"},
    {"max_depth_m", worded("Maximum depth"), "m"},
    {"max_depth_p999_m", worded("99.9th percentile of depth"), "m"},
    {"max_velocity_ms", worded("Maximum velocity"), "m/s"},
    {"max_velocity_p999_ms", worded("99.9th percentile of speed"), "m/s"},
    {"max_pressure_kpa", worded("Maximum dynamic pressure"), "kPa"},
    {"arrival_s", worded("Arrival time"), "s"},
    {"runout_m", worded("Run-out"), "m"},
    {"drop_m", worded("Drop"), "m"},
    {"reach_angle_deg", worded("Angle of reach"), "°"},
    {"distance_m", worded("Distance"), "m"},
    {"probability", worded("Probability")},
    {"class", worded("Class")},
    {"thresholds", worded("Thresholds")},
    {"scheme", worded("Scheme")},
    {"source", worded("Source")},
    {"zones_m2", worded("Area of all generalised zones"), "m²"},
    {"exposed", worded("Exposed features")},
    {"count", worded("Count")},
    {"reached", worded("Reached (1: yes)")},
    {"expected_damage", worded("Expected damage")},
    {"annual_damage", worded("Expected damage a year")},
    {"intensity", worded("Intensity")},
    {"degree_scenario", worded("Scenario")},
    {"degree_source", worded("Source")},
};

}  // namespace

const std::vector<ExposureLook>& exposure_looks() {
    static const std::vector<ExposureLook> k_table{
        {1, worded("Exposed, reached"), {200, 0, 130}, 3, false},
        {0, worded("Exposed, not reached"), {0, 105, 60}, 1.8, false},
        {std::nan(""), worded("Exposed, unknown"), {110, 110, 110}, 1.4, true},
    };
    return k_table;
}

gis::StyleText VectorLayer::style(const Words& words) const {
    if (file != k_exposure_file) return gis::style_of(name, shape, look);
    std::vector<gis::ValueLook> looks;
    for (const ExposureLook& one : exposure_looks())
        looks.push_back(
            {one.reached, words(one.label), {one.colour, look.width_mm, one.dashed && shape != Shape::point, ""}});
    return gis::style_of(name, shape, k_reached, looks);
}

const std::vector<VectorLayer>& vector_layers() {
    static const std::vector<VectorLayer> k_table{
        {k_gauge_places, "gauges", worded("Gauges"), Shape::point, {{150, 0, 60}, 2.5, false, k_name}},
        {k_gauge_places, "sections", worded("Cross-sections"), Shape::line, {{70, 50, 120}, 0.6, false, k_name}},
        {k_exposure_file, "exposure_points", worded("Exposed features"), Shape::point, {{}, 3, false, ""}},
        {k_exposure_file, "exposure_lines", worded("Exposed features"), Shape::line, {{}, 0.8, false, ""}},
        {k_exposure_file, "exposure_areas", worded("Exposed features"), Shape::area, {{}, 0.6, false, ""}},
        {k_comparison_outline, "scar", worded("Observed outline"), Shape::area, {k_scar_colour, 0.7, false, ""}},
        {k_outlines_file, "scar", worded("Observed outline"), Shape::area, {k_scar_colour, 0.7, false, ""}},
        {k_outlines_file, "release", worded("Release"), Shape::area, {k_release_colour, 0.6, true, k_name}},
        {k_outlines_file, "deposit", worded("Deposit"), Shape::area, {{120, 70, 0}, 0.4, false, ""}},
        {k_outlines_file, "trace", worded("Covered area"), Shape::area, {{60, 60, 60}, 0.4, false, ""}},
        {k_outlines_file, probability_layer("95"), "Reached by 95 %", Shape::area, {k_likely_colour, 0.5, false, ""}},
        {k_outlines_file,
         probability_layer("50"),
         "Reached by 50 %",
         Shape::area,
         {k_even_chance_colour, 0.5, false, ""}},
        {k_outlines_file, probability_layer("05"), "Reached by 5 %", Shape::area, {k_unlikely_colour, 0.5, true, ""}},
        {k_profile_lines, "lines", worded("Profiles"), Shape::line, {{70, 50, 120}, 0.5, true, k_name}},
        {k_profile_lines,
         "stations",
         worded("Stations of the profiles"),
         Shape::point,
         {{70, 50, 120}, 0.8, false, ""}},
        {k_member_outlines, "slopes", worded("Slopes"), Shape::area, {k_release_colour, 0.5, false, k_name}},
        {k_member_outlines, "members", worded("Runs"), Shape::area, {{90, 90, 90}, 0.2, false, ""}},
    };
    return k_table;
}

gis::AttributeTitles attribute_titles(const Words& words) {
    gis::AttributeTitles titles;
    for (const Attribute& one : k_attributes) titles.emplace_back(one.name, with_unit(words(one.title), one.unit));
    for (const ResultRaster& row : result_rasters()) {
        if (row.by_value) continue;
        titles.emplace_back(row.name, with_unit(words(row.title), row.unit));
    }
    return titles;
}

std::string layer_title(const VectorLayer& row, const Words& words) {
    static const std::string k_reached_by = worded("Reached by {1} %");
    const NumberPattern pattern(row.title);
    return pattern.text == k_reached_by ? pattern.in(words) : words(row.title);
}

gis::StyleText style_in(const VectorLayer& row, const Words& words) {
    return gis::titled(row.style(words), layer_title(row, words), attribute_titles(words));
}

void write_result_shapes(const std::string& gpkg_path, const std::string& crs_wkt, std::vector<gis::ShapeLayer> layers,
                         const Words& words) {
    const std::string file = std::filesystem::path(gpkg_path).filename().string();
    for (gis::ShapeLayer& layer : layers)
        for (const VectorLayer& row : vector_layers())
            if (layer.style.qml.empty() && row.file == file && row.name == layer.name)
                layer.style = style_in(row, words);
    gis::write_shapes(gpkg_path, crs_wkt, layers);
}

}  // namespace frana::app
