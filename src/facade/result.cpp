// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/geometry.h"
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

/// As frana run counts them: the cells whose centres the outlines contain.
std::optional<GroundStatistics> ground_of_release(const frana::Scene& scene) {
    GroundSum sum(scene.terrain);
    const GridSpec& grid = scene.grid;
    const auto cell = [&](double distance) { return static_cast<std::int64_t>(std::floor(distance / grid.cell_size)); };
    for (const ReleaseArea& area : scene.release) {
        const InsideTest inside(area.outline);
        const Bounds box = bounds(area.outline);
        for (std::int64_t row = cell(grid.north - box.north); row <= cell(grid.north - box.south); ++row)
            for (std::int64_t column = cell(box.west - grid.west); column <= cell(box.east - grid.west); ++column)
                if (inside(grid.cell_centre(row, column))) sum.add(row, column);
    }
    return sum.statistics();
}

std::string summary_of(const RunResult& result, const EngineScene& prepared) {
    const SceneSpec& spec = prepared.spec;
    TraceFigures trace = trace_figures(result, prepared.scene.terrain, spec.output.trace_threshold);
    trace.release_ground = ground_of_release(prepared.scene);
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
    return json_text(json);
}

}  // namespace

std::shared_ptr<const Result::Data> result_data(RunResult result, const EngineScene& prepared, const Grid& grid) {
    auto data = std::make_shared<Result::Data>();
    data->grid = grid;
    data->recording = prepared.scene.recording;
    data->summary = summary_of(result, prepared);
    data->notes = prepared.warnings;
    data->notes.insert(data->notes.end(), result.notes.begin(), result.notes.end());
    data->result = std::move(result);
    // Read of the caller's memory while that is as it was; of a large map only where the flow came.
    const CellValues& bed = data->result.raster("bed").values;
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

std::vector<std::string> Result::notes() const {
    return data_->notes;
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
