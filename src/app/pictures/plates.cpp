// SPDX-License-Identifier: Apache-2.0
#include "app/pictures/plates.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>

#include "analysis/trace.h"
#include "app/pictures/charts.h"
#include "app/store/result_files.h"
#include "app/store/vector_layers.h"
#include "app/text/number_text.h"
#include "core/error.h"
#include "core/text.h"
#include "params/grammar/value_text.h"
#include "params/keys/scene_spec.h"
#include "render/map/plate.h"

namespace frana::app {
namespace {

constexpr const char *k_initial_state = "initial_state", *k_snapshots = "snapshots", *k_stresses = "stresses",
                     *k_comparison = "comparison";

/// Draws a map without the parts that a plate has only once.
render::Page lean_map(const MapSource& source, const MapLayer& layer, const std::string& subtitle, int width,
                      int height) {
    render::MapSpec spec = unprinted(map_spec(source, layer));
    spec.title.clear();
    spec.subtitle = subtitle;
    spec.attribution.clear();
    spec.crs_label.clear();
    spec.side_notes = layer.time ? std::vector<std::string>{} : layer.notes;
    spec.inset = false;
    spec.longitude_latitude = nullptr;
    spec.width = width;
    spec.height = height;
    return render::map_page(spec);
}

render::Page lean_view(const MapSource& source, const MapLayer& layer, const std::string& subtitle, int width,
                       int height) {
    render::ViewSpec spec = view_spec(source, layer);
    spec.title.clear();
    spec.subtitle = subtitle;
    spec.attribution.clear();
    spec.crs_label.clear();
    spec.side_notes.clear();
    spec.width = width;
    spec.height = height;
    return render::view_page(spec);
}

/// Returns four times from soon after the start to the end.
std::vector<double> snapshot_times(const std::vector<StoredFrame>& frames) {
    const double last = frames.back().time;
    std::vector<double> times;
    for (const double fraction : {0.1, 0.3, 0.6, 1.0}) times.push_back(fraction * last);
    return times;
}

struct Snapshots {
    std::vector<MapLayer> depths;
    std::string name, title, subtitle;
};

render::Plate plate_of(const Snapshots& snapshots, const MapSource& source) {
    render::Plate plate{page_title(source, snapshots.title), snapshots.subtitle, source.crs_label, 2, {}};
    for (const MapLayer& layer : snapshots.depths) {
        plate.parts.push_back([&](int width, int height) {
            return lean_map(
                source, layer,
                source.style.words("t = {1} s", {source.style.words.number(number_text(layer.time.value_or(0), 4))}),
                width, height);
        });
    }
    return plate;
}

/// Hydrostatic: the weight of the vertical column on the map's square metre.
MapLayer normal_stress(const MapLayer& depth, double density, double gravity, double greatest_depth,
                       const Words& words) {
    MapLayer layer = depth;
    const double kilopascal = density * gravity / 1000;
    layer.values.values.change_each_stored([&](std::size_t, double& value) { value *= kilopascal; });
    layer.title = words("Normal stress");
    layer.unit = "kPa";
    layer.palette = "velocity";
    layer.classes = class_bounds(false, greatest_depth * kilopascal);
    return layer;
}

/// Returns density [kg/m3] and gravity [m/s2] of the run; none for a mixture, whose density varies from place to place.
/// Throws Error(input) if the result does not contain them.
std::optional<std::pair<double, double>> column_weight(const ResultReader& result) {
    if (result.scene_value("material.model") == "structured" || result.scene_value("output.depth") == k_normal_depth)
        return std::nullopt;
    const auto number = [&](const std::string& key) {
        const auto text = result.scene_value(key);
        if (const auto value = text ? number_from_text(*text) : std::nullopt) return *value;
        throw Error(ErrorKind::input,
                    Problem{"does not contain " + key + ", which the normal stress on the bed needs",
                            result.path(k_scene_file), text.value_or(""), "", "The file is damaged or not from a run"});
    };
    return std::pair{number("material.density"), number("numerics.gravity")};
}

/// Draws the plate; its parts are small, and their messages are completed with the plate's name.
render::Page draw(const render::Plate& plate, const std::string& name, Size size) {
    try {
        return render::draw_plate(plate, size.width, size.height);
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::input) throw;
        throw Error(ErrorKind::input,
                    Problem{"cannot be drawn: " + std::string(error.what()), "plate " + name,
                            std::to_string(size.width) + "x" + std::to_string(size.height), "",
                            "The page has four parts; draw it larger, for example with --size 1600x1200"});
    }
}

}  // namespace

std::vector<std::string> plate_files(const MapSource& source, const std::string& folder) {
    std::vector<std::string> files;
    for (const char* name : {k_initial_state, k_snapshots, k_stresses, k_comparison}) {
        const auto more = picture_files(source.style, (std::filesystem::path(folder) / name).string(), false);
        files.insert(files.end(), more.begin(), more.end());
    }
    return files;
}

std::vector<std::string> draw_plates(const ResultReader& result, const MapSource& source, const std::string& folder) {
    std::vector<std::string> files;
    const Size size = source.style.size;
    const auto write = [&](const std::string& name, const render::Plate& plate) {
        const render::Page page = draw(plate, name, size);
        for (const std::string& file :
             write_plain_picture(page, source.style, plate.title, (std::filesystem::path(folder) / name).string()))
            files.push_back(file);
    };

    const Words& words = source.style.words;
    Snapshots depths{{}, "snapshots", words("snapshots of the depth"), source.subtitle};
    for (const double time : snapshot_times(result.frames()))
        depths.depths.push_back(result.map_layer("depth@" + shortest_text(time)));

    MapLayer start = result.map_layer("depth@0");
    start.classes = depths.depths.front().classes;
    write(k_initial_state,
          {page_title(source, words("initial state")),
           source.subtitle,
           source.crs_label,
           2,
           {[&](int w, int h) { return lean_map(source, start, words("thickness on the map"), w, h); },
            [&](int w, int h) { return lean_view(source, start, words("from before the slope"), w, h); }}});
    write(k_snapshots, plate_of(depths, source));

    if (const auto weight = column_weight(result)) {
        const auto [density, gravity] = *weight;
        double greatest = maximum(start.values);
        for (const MapLayer& layer : depths.depths) greatest = std::max(greatest, maximum(layer.values));
        Snapshots stresses{{},
                           "stresses",
                           words("normal stress on the bed"),
                           words("hydrostatic: density {1} kg/m\u00B3 times gravity {2} m/s\u00B2 times vertical depth",
                                 {words.number(number_text(density)), words.number(number_text(gravity))})};
        for (const MapLayer& layer : depths.depths)
            stresses.depths.push_back(normal_stress(layer, density, gravity, greatest, words));
        write(k_stresses, plate_of(stresses, source));
    }

    if (!result.has(raster_file("comparison"))) return files;
    MapLayer comparison = result.map_layer("comparison");
    Problems problems;
    const std::vector<NamedChart> charts = result_charts(result, source, problems);
    problems.throw_if_any();
    render::Plate last{page_title(source, words("profile and comparison with the observed outline")),
                       source.subtitle,
                       source.crs_label,
                       2,
                       {}};
    if (!charts.empty() && charts.front().name.starts_with("profile")) {
        last.parts.push_back([&](int w, int h) {
            render::Chart chart = charts.front().chart;
            chart.title = "";
            chart.subtitle = words("longitudinal profile along the flow path");
            return render::chart_page(chart, w, h);
        });
    }
    last.parts.push_back(
        [&](int w, int h) { return lean_map(source, comparison, words("hits, false alarms, misses"), w, h); });
    write(k_comparison, last);
    return files;
}

}  // namespace frana::app
