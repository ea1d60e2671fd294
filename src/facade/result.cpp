// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "analysis/exposure.h"
#include "core/json.h"
#include "facade/frana.h"
#include "facade/inside.h"
#include "params/keys/result_rasters.h"
#include "simulation/run_summary.h"

namespace frana::facade {

std::string version() {
    return FRANA_VERSION;
}

Error::Error(const std::string& text, std::vector<Problem> problems)
    : std::runtime_error(text), problems_(std::move(problems)) {}
Error::~Error() = default;

RunFailed::RunFailed(const std::string& text, std::vector<Problem> problems, Result result)
    : Error(text, std::move(problems)), result_(std::move(result)) {}
RunFailed::~RunFailed() = default;

namespace {

RasterInfo info_of(const std::string& name) {
    const ResultRaster* const row = find_result_raster(name);
    return row == nullptr ? RasterInfo{name, name, ""} : RasterInfo{name, row->title, row->unit};
}

/// The memory of values side by side, which the owner keeps.
Raster raster_of(const std::string& name, const frana::Raster& raster, const Grid& grid,
                 std::shared_ptr<const void> keeper) {
    const double* const first = raster.values.data();
    return {info_of(name), grid, {first, raster.values.size()}, std::move(keeper)};
}

/// A value of a table's rows.
template <class Row>
struct Column {
    const char *name, *unit;
    double Row::*value;
};

/// The rows of each gauge or section.
template <class Named, class Row, std::size_t count>
std::vector<Record> records_of(const std::vector<Named>& named, const std::vector<Row>& rows, std::size_t Row::*index,
                               const Column<Row> (&columns)[count]) {
    std::vector<Record> records;
    for (const Named& one : named) {
        Record& record = records.emplace_back(Record{one.name, {}});
        for (const Column<Row>& column : columns) record.columns.push_back({column.name, column.unit, {}});
    }
    for (const Row& row : rows)
        for (std::size_t c = 0; c < count; ++c) records[row.*index].columns[c].values.push_back(row.*columns[c].value);
    return records;
}

[[noreturn]] void refuse_name(const std::string& name, const std::vector<RasterInfo>& rasters) {
    std::string names;
    for (const RasterInfo& raster : rasters) names += (names.empty() ? "" : ", ") + raster.name;
    refuse({"is no raster of this result", name, "", names, "Choose one of them"});
}

void require_finite(const MixedShape& shape) {
    const auto check = [](const std::vector<frana::Point>& points) {
        for (const frana::Point& p : points)
            if (!std::isfinite(p.x) || !std::isfinite(p.y))
                refuse({"has a point that is not finite", "exposure", shortest_text(p.x) + ", " + shortest_text(p.y),
                        "", "Correct the feature"});
    };
    check(shape.points);
    for (const Polyline& line : shape.lines) check(line);
    for (const frana::Polygon& polygon : shape.areas) {
        check(polygon.outer);
        for (const frana::Ring& hole : polygon.holes) check(hole);
    }
}

std::string summary_of(const RunResult& result, const EngineScene& prepared, const TraceFigures& trace,
                       const std::vector<std::string>& warnings) {
    const SceneSpec& spec = prepared.spec;
    Json json{{"program", "frana"},
              {"version", FRANA_VERSION},
              {"model", spec.material.model},
              {"scheme", word_of(spec.numerics.scheme, k_schemes)},
              {"slope_correction", word_of(slope_correction(spec.numerics), k_slope_corrections)}};
    add_end(json, result, spec);
    add_particles(json, result);
    json["terms"] = result.terms;
    add_flow(json, result, spec);
    add_trace(json, trace);
    add_run_problems(json, result);
    json["warnings"] = warnings;
    return json_text(json);
}

}  // namespace

std::shared_ptr<const Result::Data> result_data(RunResult result, const EngineScene& prepared, const Grid& grid) {
    auto data = std::make_shared<Result::Data>();
    data->grid = grid;
    data->recording = prepared.scene.recording;
    TraceFigures trace = trace_figures(result, prepared.scene.terrain, prepared.spec.output.trace_threshold);
    trace.release_ground = prepared.release_ground;
    data->warnings = texts_of(result.warnings);
    data->summary = summary_of(result, prepared, trace, data->warnings);
    data->result = std::move(result);
    // Read of the caller's memory while that is as it was; of a large map only where the flow came.
    const CellValues& bed = data->result.raster(RasterName::bed).values;
    if (static_cast<std::int64_t>(bed.size()) <= CellValues::k_most_dense) static_cast<void>(bed.dense());
    return data;
}

std::vector<RasterInfo> Result::rasters() const {
    std::vector<RasterInfo> list;
    for (const ResultRaster& row : result_rasters())
        if (data_->result.find_raster(row.name) != nullptr) list.push_back(info_of(row.name));
    return list;
}

Raster Result::raster(const std::string& name) const {
    const frana::Raster* const raster = data_->result.find_raster(name);
    if (raster == nullptr) refuse_name(name, rasters());
    return raster_of(name, *raster, data_->grid, data_);
}

std::vector<Series> Result::series() const {
    static constexpr Column<SeriesRow> k_columns[] = {{"time", "s", &SeriesRow::time},
                                                      {"dt", "s", &SeriesRow::dt},
                                                      {"volume", "m3", &SeriesRow::volume},
                                                      {"volume_left", "m3", &SeriesRow::volume_left},
                                                      {"max_depth", "m", &SeriesRow::max_depth},
                                                      {"max_speed", "m/s", &SeriesRow::max_speed},
                                                      {"front_distance", "m", &SeriesRow::front_distance},
                                                      {"kinetic_energy", "J", &SeriesRow::kinetic_energy},
                                                      {"covered_area", "m2", &SeriesRow::covered_area},
                                                      {"volume_entered", "m3", &SeriesRow::volume_entered},
                                                      {"volume_inflow", "m3", &SeriesRow::volume_inflow},
                                                      {"volume_eroded", "m3", &SeriesRow::volume_eroded},
                                                      {"volume_deposited", "m3", &SeriesRow::volume_deposited}};
    std::vector<Series> list;
    for (const Column<SeriesRow>& column : k_columns) {
        Series& series = list.emplace_back(Series{column.name, column.unit, {}});
        for (const SeriesRow& row : data_->result.series) series.values.push_back(row.*column.value);
    }
    return list;
}

std::vector<Record> Result::gauges() const {
    static constexpr Column<GaugeRow> k_columns[] = {
        {"time", "s", &GaugeRow::time}, {"depth", "m", &GaugeRow::depth}, {"speed", "m/s", &GaugeRow::speed}};
    return records_of(data_->recording.gauges, data_->result.gauges, &GaugeRow::gauge, k_columns);
}

std::vector<Record> Result::sections() const {
    static constexpr Column<SectionRow> k_columns[] = {
        {"time", "s", &SectionRow::time},           {"discharge", "m3/s", &SectionRow::discharge},
        {"volume", "m3", &SectionRow::volume},      {"wetted_width", "m", &SectionRow::wetted_width},
        {"max_depth", "m", &SectionRow::max_depth}, {"max_speed", "m/s", &SectionRow::max_speed}};
    return records_of(data_->recording.sections, data_->result.sections, &SectionRow::section, k_columns);
}

std::string Result::summary() const {
    return data_->summary;
}

double Result::number(const std::string& key) const {
    std::string path = "/" + key;
    for (char& c : path)
        if (c == '.') c = '/';
    const Json summary = Json::parse(data_->summary);
    const Json::json_pointer pointer(path);
    if (summary.contains(pointer)) {
        const Json& value = summary.at(pointer);
        if (value.is_number()) return value.get<double>();
        if (value.is_null()) return std::numeric_limits<double>::quiet_NaN();
    }
    refuse({"is no number of the summary", key, "", "", "See Result::summary()"});
}

std::string Result::stop_reason() const {
    return stop_word(data_->result.stop_reason);
}

std::vector<std::string> Result::warnings() const {
    return data_->warnings;
}

std::vector<std::string> Result::notes() const {
    return data_->result.notes;
}

std::vector<Exposure> Result::exposure(const std::vector<Exposed>& features) const {
    const RunResult& result = data_->result;
    const frana::Raster& bed = result.raster(RasterName::bed);
    const bool is_known = static_cast<std::int64_t>(bed.values.size()) <= CellValues::k_most_dense;
    const ReachedPlaces reached(result);
    const ExposureRasters rasters{&reached(RasterName::max_depth), &reached(RasterName::max_velocity),
                                  &reached(RasterName::max_pressure), &reached(RasterName::arrival_time),
                                  is_known ? &bed : nullptr};
    std::vector<Exposure> all;
    for (const Exposed& feature : features) {
        MixedShape shape{area_of(feature.areas), {}, {}};
        for (const std::vector<Point>& line : feature.lines) shape.lines.push_back(points_of(line));
        shape.points = points_of(feature.points);
        require_finite(shape);
        const ExposureValues values = exposure_values({touched_cells(shape, bed.grid)}, rasters).front();
        const ExposureRow row = exposure_row(shape, values, bed.grid.bounds());
        all.push_back({row.is_reached(), row.number("max_depth_m"), row.number("max_velocity_ms"),
                       row.number("max_pressure_kpa"), row.number("arrival_s"), row.texts.front().second});
    }
    return all;
}

int Frame::index() const noexcept {
    return data_->frame.index;
}

double Frame::time() const noexcept {
    return data_->frame.time;
}

std::vector<RasterInfo> Frame::rasters() const {
    std::vector<RasterInfo> list{info_of("depth"), info_of("velocity")};
    for (const NamedRaster& raster : data_->frame.more) list.push_back(info_of(raster.name));
    return list;
}

Raster Frame::raster(const std::string& name) const {
    const frana::Frame& frame = data_->frame;
    const auto found = [&](const frana::Raster& raster) { return raster_of(name, raster, data_->grid, data_); };
    if (name == "depth") return found(frame.depth);
    if (name == "velocity") return found(frame.velocity);
    for (const NamedRaster& raster : frame.more)
        if (raster.name == name) return found(raster.values);
    refuse_name(name, rasters());
}

}  // namespace frana::facade
