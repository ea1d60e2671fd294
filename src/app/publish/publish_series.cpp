// SPDX-License-Identifier: Apache-2.0
#include "app/publish/publish_series.h"

#include <algorithm>
#include <cmath>

#include "analysis/ground_statistics.h"
#include "analysis/runout.h"
#include "analysis/trace.h"
#include "app/store/result_files.h"
#include "app/store/scene_identity.h"
#include "app/store/vector_layers.h"
#include "app/text/text_file.h"
#include "app/text/text_table.h"
#include "core/text.h"
#include "gis/raster/raster_out.h"
#include "gis/raster/styles.h"
#include "params/keys/output_parameters.h"

namespace frana::app {

std::string timeseries_csv(const std::vector<SeriesRow>& series) {
    std::string text =
        "time_s,step,dt_s,volume_m3,volume_left_m3,max_depth_m,max_speed_ms,front_distance_m,kinetic_energy_"
        "j,"
        "covered_area_m2,volume_entered_m3,volume_inflow_m3,volume_eroded_m3,volume_deposited_m3\n";
    for (const SeriesRow& row : series) {
        text += shortest_text(row.time);
        text += ',';
        text += std::to_string(row.step);
        for (const double value :
             {row.dt, row.volume, row.volume_left, row.max_depth, row.max_speed, row.front_distance, row.kinetic_energy,
              row.covered_area, row.volume_entered, row.volume_inflow, row.volume_eroded, row.volume_deposited}) {
            text += ',';
            text += shortest_text(value);
        }
        text += '\n';
    }
    return text;
}

namespace {

/// Zero where there is ground but no flow, as in AvaFrame's own files.
Raster filled(const Raster& values, const Raster& terrain) {
    Raster raster = values;
    terrain.values.for_each_stored([&](std::size_t cell, double ground) {
        if (!std::isnan(ground) && std::isnan(std::as_const(raster).values[cell])) raster.values[cell] = 0;
    });
    return raster;
}

/// With the classes of the result's own raster of that quantity; nothing is drawn where there was no flow.
void write_peak_style(const std::string& path, const Raster& raster, const PeakFile& file, const ClassSpec& classes,
                      const Words& words) {
    const ResultRaster& row = *find_result_raster(file.like);
    const std::vector<double> bounds = class_bounds(row, classes, maximum(raster));
    gis::write_styles(path, gis::class_stops(palette(row.palette), bounds, file.unit, words, true), file.unit,
                      gis::StyleKind::classed, file.text);
}

/// Returns AvaFrame's name of a simulation: RELEASE_HASH_C_null_dfa, where no part may contain an underscore.
std::string avaframe_name(const std::string& scene, const std::string& hash) {
    std::string release = shortened_name(scene), digits;
    std::replace(release.begin(), release.end(), '_', '-');
    for (const char c : hash)
        if (c != '-' && digits.size() < 10) digits += c;
    return release + "_" + digits + "_C_null_dfa";
}

}  // namespace

void publish_avaframe(const Prepared& prepared, const RunResult& result, const ResultDirectory& directory) {
    if (prepared.spec.output.names != "avaframe") return;
    directory.make_folder(k_peak_folder);
    const auto origin = provenance(prepared);
    const std::string name =
        std::string(k_peak_folder) + "/" + avaframe_name(scene_name(prepared.spec), origin.at("SCENE_HASH"));
    const Raster thickness = result.depth_is_normal ? result.raster("max_depth")
                                                    : normal_depth(result.raster("max_depth"), result.raster("bed"));
    const Raster* const values_of[] = {&result.raster("max_pressure"), &thickness, &result.raster("max_velocity")};
    static_assert(std::size(values_of) == std::size(k_peak_files));
    for (std::size_t i = 0; i < std::size(k_peak_files); ++i) {
        const auto& [kind, text, unit, like] = k_peak_files[i];
        const Raster& values = *values_of[i];
        const Raster raster = filled(values, prepared.scene.terrain);
        const std::string stem = directory.path(name + "_" + kind);
        gis::write_geotiff(stem + ".tif", raster, {kind, text, unit, origin});
        write_peak_style(stem + ".tif", raster, k_peak_files[i], prepared.spec.output.classes, words_of(prepared.spec));
    }
}

namespace {

const std::string k_flow_path = "flow path";

/// A column of a profile besides the rasters of the result.
struct Column {
    std::string name;
    const Raster* raster;
};

std::vector<Column> columns_of(const RunResult& result) {
    std::vector<Column> columns{{"bed_m", &result.raster("bed")}, {"release_m", &result.raster("release")}};
    for (const ResultRaster& row : main_rasters()) columns.push_back({row.name, result.find_raster(row.name)});
    return columns;
}

std::vector<gis::NamedLine> profile_lines(const Prepared& prepared, const RunResult& result, const Runout& run_out) {
    std::vector<gis::NamedLine> lines;
    if (run_out.horizontal_m > 0)
        lines.push_back({k_flow_path, flow_path(result.raster("max_depth"), run_out.top, run_out.tip)});
    lines.insert(lines.end(), prepared.extra.profiles.begin(), prepared.extra.profiles.end());
    return lines;
}

void add_numbers(std::string& text, std::initializer_list<double> numbers) {
    for (const double number : numbers) text += "," + shortest_text(number);
}

/// Returns gauges.csv: time_s,gauge,depth_m,speed_ms.
std::string gauges_csv(const std::vector<GaugeRow>& rows, const std::vector<Gauge>& gauges) {
    std::string text = "time_s,gauge,depth_m,speed_ms\n";
    for (const GaugeRow& row : rows) {
        text += shortest_text(row.time) + "," + csv_cell(gauges[row.gauge].name);
        add_numbers(text, {row.depth, row.speed});
        text += '\n';
    }
    return text;
}

/// Returns sections.csv: time_s,section,discharge_m3s,volume_m3,wetted_width_m,max_depth_m,max_speed_ms.
std::string sections_csv(const std::vector<SectionRow>& rows, const std::vector<CrossSection>& sections) {
    std::string text = "time_s,section,discharge_m3s,volume_m3,wetted_width_m,max_depth_m,max_speed_ms\n";
    for (const SectionRow& row : rows) {
        text += shortest_text(row.time) + "," + csv_cell(sections[row.section].name);
        add_numbers(text, {row.discharge, row.volume, row.wetted_width, row.max_depth, row.max_speed});
        text += '\n';
    }
    return text;
}

}  // namespace

void publish_series(const Prepared& prepared, const RunResult& result, const ResultDirectory& directory) {
    const Recording& recording = prepared.scene.recording;
    if (!recording.gauges.empty())
        write_text_file(directory.path(k_gauge_table), gauges_csv(result.gauges, recording.gauges));
    if (!recording.sections.empty())
        write_text_file(directory.path(k_section_table), sections_csv(result.sections, recording.sections));
    if (recording.gauges.empty() && recording.sections.empty()) return;
    gis::LineLayer lines{"sections", {}};
    gis::PointLayer points{"gauges", {}};
    for (const CrossSection& section : recording.sections)
        lines.features.push_back({section.line, {}, {{"name", section.name}}});
    for (const Gauge& gauge : recording.gauges) points.features.push_back({gauge.place, {}, {{"name", gauge.name}}});
    write_result_lines_and_points(directory.path(k_gauge_places), prepared.scene.grid.crs_wkt, lines, points,
                                  words_of(prepared.spec));
}

void publish_profiles(const Prepared& prepared, const RunResult& result, const Runout& run_out,
                      const ResultDirectory& directory) {
    const std::vector<Column> columns = columns_of(result);
    gis::LineLayer lines{"lines", {}};
    gis::PointLayer points{"stations", {}};
    // Of max_depth and final_depth; what was released is vertical.
    const std::string direction = result.depth_is_normal ? k_normal : k_vertical;
    std::string text = "line,distance_m,x,y";
    for (const Column& column : columns) text += "," + column.name;
    text += ",depth_direction\n";
    for (const gis::NamedLine& line : profile_lines(prepared, result, run_out)) {
        lines.features.push_back({line.line, {}, {{"name", line.name}}});
        for (const Station& station : stations(line.line, prepared.scene.grid.cell_size)) {
            gis::PointFeature point{station.place,
                                    {{"distance_m", station.distance}},
                                    {{"name", line.name}, {"depth_direction", direction}}};
            text += csv_cell(line.name);
            add_numbers(text, {station.distance, station.place.x, station.place.y});
            for (const Column& column : columns) {
                const double value = cell_value(*column.raster, station.place);
                point.numbers[column.name] = value;
                text += "," + (std::isnan(value) ? "" : shortest_text(value));
            }
            text += "," + direction + '\n';
            points.features.push_back(std::move(point));
        }
    }
    write_text_file(directory.path(k_profile_table), text);
    write_result_lines_and_points(directory.path(k_profile_lines), prepared.scene.grid.crs_wkt, lines, points,
                                  words_of(prepared.spec));
}

}  // namespace frana::app
