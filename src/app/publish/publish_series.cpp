// SPDX-License-Identifier: Apache-2.0
#include "app/publish/publish_series.h"

#include <cmath>

#include "analysis/ground_statistics.h"
#include "analysis/runout.h"
#include "analysis/trace.h"
#include "app/store/result_files.h"
#include "app/store/vector_layers.h"
#include "app/text/text_file.h"
#include "app/text/text_table.h"
#include "core/text.h"
#include "params/keys/output_parameters.h"
#include "params/keys/result_rasters.h"

namespace frana::app {
namespace {

std::string line_of(std::vector<std::string> cells, std::initializer_list<double> numbers) {
    for (const double number : numbers) cells.push_back(shortest_text(number));
    return csv_line(cells);
}

}  // namespace

std::string timeseries_csv(const std::vector<SeriesRow>& series) {
    std::string text =
        "time_s,step,dt_s,volume_m3,volume_left_m3,max_depth_m,max_speed_ms,front_distance_m,kinetic_energy_j,"
        "covered_area_m2,volume_entered_m3,volume_inflow_m3,volume_eroded_m3,volume_deposited_m3\n";
    for (const SeriesRow& row : series) {
        text += line_of(
            {shortest_text(row.time), std::to_string(row.step)},
            {row.dt, row.volume, row.volume_left, row.max_depth, row.max_speed, row.front_distance, row.kinetic_energy,
             row.covered_area, row.volume_entered, row.volume_inflow, row.volume_eroded, row.volume_deposited});
    }
    return text;
}

namespace {

const std::string k_flow_path = "flow path";

/// A column of a profile besides the rasters of the result.
struct Column {
    std::string name;
    const Raster* raster;
};

std::vector<Column> columns_of(const RunResult& result) {
    std::vector<Column> columns{{"bed_m", &result.raster(RasterName::bed)}, {"release_m", &result.raster("release")}};
    for (const ResultRaster& row : main_rasters()) columns.push_back({row.name, result.find_raster(row.name)});
    return columns;
}

std::vector<gis::NamedLine> profile_lines(const Prepared& prepared, const RunResult& result, const Runout& run_out) {
    std::vector<gis::NamedLine> lines;
    if (run_out.horizontal_m > 0)
        lines.push_back({k_flow_path, flow_path(result.raster(RasterName::max_depth), run_out.top, run_out.tip)});
    lines.insert(lines.end(), prepared.extra.profiles.begin(), prepared.extra.profiles.end());
    return lines;
}

/// Returns gauges.csv: time_s,gauge,depth_m,speed_ms.
std::string gauges_csv(const std::vector<GaugeRow>& rows, const std::vector<Gauge>& gauges) {
    std::string text = "time_s,gauge,depth_m,speed_ms\n";
    for (const GaugeRow& row : rows) {
        text += line_of({shortest_text(row.time), gauges[row.gauge].name}, {row.depth, row.speed});
    }
    return text;
}

/// Returns sections.csv: time_s,section,discharge_m3s,volume_m3,wetted_width_m,max_depth_m,max_speed_ms.
std::string sections_csv(const std::vector<SectionRow>& rows, const std::vector<CrossSection>& sections) {
    std::string text = "time_s,section,discharge_m3s,volume_m3,wetted_width_m,max_depth_m,max_speed_ms\n";
    for (const SectionRow& row : rows) {
        text += line_of({shortest_text(row.time), sections[row.section].name},
                        {row.discharge, row.volume, row.wetted_width, row.max_depth, row.max_speed});
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
    gis::ShapeLayer lines{"sections", {}, gis::Shape::line}, points{"gauges", {}, gis::Shape::point};
    for (const CrossSection& section : recording.sections)
        lines.features.push_back({{{}, {section.line}, {}}, {}, {{"name", section.name}}});
    for (const Gauge& gauge : recording.gauges)
        points.features.push_back({{{}, {}, {gauge.place}}, {}, {{"name", gauge.name}}});
    write_result_shapes(directory.path(k_gauge_places), prepared.scene.grid.crs_wkt, {lines, points},
                        words_of(prepared.spec));
}

void publish_profiles(const Prepared& prepared, const RunResult& result, const Runout& run_out,
                      const ResultDirectory& directory) {
    const std::vector<Column> columns = columns_of(result);
    gis::ShapeLayer lines{"lines", {}, gis::Shape::line}, points{"stations", {}, gis::Shape::point};
    // Of max_depth and final_depth; what was released is vertical.
    const std::string direction = result.depth_is_normal ? k_normal : k_vertical;
    std::string text = "line,distance_m,x,y";
    for (const Column& column : columns) text += "," + column.name;
    text += ",depth_direction\n";
    for (const gis::NamedLine& line : profile_lines(prepared, result, run_out)) {
        lines.features.push_back({{{}, {line.line}, {}}, {}, {{"name", line.name}}});
        for (const Station& station : stations(line.line, prepared.scene.grid.cell_size)) {
            Feature point{{{}, {}, {station.place}},
                          {{"distance_m", station.distance}},
                          {{"name", line.name}, {"depth_direction", direction}}};
            std::vector<std::string> cells{line.name, shortest_text(station.distance), shortest_text(station.place.x),
                                           shortest_text(station.place.y)};
            for (const Column& column : columns) {
                const double value = point.numbers[column.name] = cell_value(*column.raster, station.place);
                cells.push_back(std::isnan(value) ? "" : shortest_text(value));
            }
            cells.push_back(direction);
            text += csv_line(cells);
            points.features.push_back(std::move(point));
        }
    }
    write_text_file(directory.path(k_profile_table), text);
    write_result_shapes(directory.path(k_profile_lines), prepared.scene.grid.crs_wkt, {lines, points},
                        words_of(prepared.spec));
}

}  // namespace frana::app
