// SPDX-License-Identifier: Apache-2.0
#include "app/input/prepare_inflow.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <numbers>

#include "app/input/layer_values.h"
#include "app/input/used_file.h"
#include "app/text/number_text.h"
#include "core/text.h"
#include "core/words/words.h"
#include "gis/access/table_in.h"
#include "gis/vector/vector_in.h"
#include "params/grammar/ini_file.h"
#include "params/grammar/value_text.h"
#include "params/keys/plausible.h"
#include "params/keys/scene_parameters.h"
#include "params/scene/read_scene.h"
#include "simulation/arrivals.h"
#include "simulation/scene_values.h"

namespace frana::app {
namespace {

/// A column and what its unit is in seconds, m3/s, m3 or m/s.
struct Column {
    std::size_t index = 0;
    double unit = 1;
    bool is_named = false;
};

/// The units of a column that are known, as letters and digits alone: "m3/s", "m3s" and "m3_s" are the same.
const std::map<std::string, std::map<std::string, double>> k_units{
    {"time", {{"s", 1}, {"sec", 1}, {"min", 60}, {"h", 3600}}},
    {"discharge", {{"m3s", 1}, {"cumecs", 1}, {"ls", 1e-3}}},
    {"volume", {{"m3", 1}}},
    {"velocity", {{"ms", 1}, {"kmh", 1 / 3.6}}},
    {"rain", {{"mmh", 1}, {"ms", k_mm_per_hour}}},
    {"depth", {{"mm", 1}, {"m", 1000}}},
    {"raster", {}},
};

/// What a table over time gives: a rate, or its sum since the start.
struct TableQuantity {
    const char *table, *rate, *sum, *unit;  ///< the unit of the sum
    const char* raster = nullptr;           ///< of files that give the rate by place; null: there are none
};
constexpr TableQuantity k_flow{"hydrograph", "discharge", "volume", "m3"},
    k_rain{"rain", "rain", "depth", "mm", "raster"};

std::string letters_of(const std::string& unit) {
    std::string letters;
    for (std::size_t i = 0; i < unit.size(); ++i) {
        const auto c = static_cast<unsigned char>(unit[i]);
        if (std::isalnum(c)) letters += static_cast<char>(c);
        if (unit.compare(i, 2, "\u00b3") == 0) letters += '3';
    }
    return letters;
}

/// Returns the index of a column: its name alone, or followed by a unit.
std::optional<Column> column_of(const gis::Table& table, const TableQuantity& of, const std::string& name,
                                const std::string& place, Problems& problems) {
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        std::string head = trimmed(table.columns[i]);
        std::transform(head.begin(), head.end(), head.begin(), [](unsigned char c) { return std::tolower(c); });
        const std::size_t end = std::min(head.find_first_of("_ (["), head.size());
        if (head.substr(0, end) != name) continue;
        const std::string unit = letters_of(head.substr(end));
        const auto& known = k_units.at(name);
        const auto found = known.find(unit);
        if (!unit.empty() && found == known.end()) {
            std::string units;
            for (const auto& [one, factor] : known) units += (units.empty() ? "" : ", ") + name + "_" + one;
            problems.add({std::string("the ") + of.table + "'s column has an unknown unit", place, table.columns[i],
                          units, "Convert the values, and name their unit or none"});
        }
        return Column{i, unit.empty() || found == known.end() ? 1 : found->second, !unit.empty()};
    }
    return std::nullopt;
}

struct Row {
    double time = 0, amount = 0, speed = 0;
};

struct Columns {
    Column time;
    std::optional<Column> amount, speed, raster;  ///< an amount, or rasters
    bool cumulative = false;
};

Columns columns_of(const gis::Table& table, const TableQuantity& of, const std::string& place) {
    Problems problems;
    const auto find = [&](const char* name) { return column_of(table, of, name, place, problems); };
    const auto time = find("time"), rate = find(of.rate), sum = find(of.sum), speed = find("velocity"),
               raster = of.raster != nullptr ? find(of.raster) : std::nullopt;
    const std::string names = joined(table.columns, ", "), what = std::string("the ") + of.table + " has ",
                      remedy = "Name the columns in line 1";
    if (!time) problems.add({what + "no column time", place, names, "", remedy});
    if (!rate && !sum && !raster)
        problems.add({what + "neither a column " + of.rate + " nor " + of.sum, place, names, "", remedy});
    if (rate && sum)
        problems.add({what + "a " + of.rate + " and a " + of.sum, place, names, "", "Keep one of the two"});
    if (raster && (rate || sum))
        problems.add(
            {what + "a " + of.raster + " and a " + (rate ? of.rate : of.sum), place, names, "", "Keep one of the two"});
    problems.throw_if_any();
    return {*time, rate ? rate : sum, speed, raster, sum.has_value()};
}

std::vector<Row> rows_of(const gis::Table& table, const Columns& columns, const TableQuantity& of,
                         const std::string& place) {
    Problems problems;
    std::vector<Row> rows;
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        const std::string line = "line " + std::to_string(i + 2);
        const auto number = [&](const Column& column) {
            const std::string& name = table.columns[column.index];
            const std::string text = trimmed(table.rows[i][column.index]);
            const auto value = number_from_text(text);
            if (!value)
                problems.add(
                    {line + ", column " + name + " is not a number", place, text, "", "Write decimals after a point"});
            else if (*value < 0 || *value > k_most_of_hydrograph)
                problems.add({line + ", column " + name + " is out of range", place, text,
                              "0 to " + shortest_text(k_most_of_hydrograph), "Correct the file"});
            return column.unit * value.value_or(0);
        };
        const auto number_if = [&](const std::optional<Column>& column) { return column ? number(*column) : 0; };
        const Row row{number(columns.time), number_if(columns.amount), number_if(columns.speed)};
        if (!rows.empty() && !(row.time > rows.back().time))
            problems.add({line + ": the times do not rise", place, shortest_text(row.time) + " s",
                          "after " + shortest_text(rows.back().time) + " s", "Sort the rows by time"});
        if (!rows.empty() && columns.cumulative && row.amount < rows.back().amount)
            problems.add({line + ": the " + of.sum + " falls", place, shortest_text(row.amount) + " " + of.unit,
                          "at least " + shortest_text(rows.back().amount) + " " + of.unit,
                          std::string("Give the ") + of.sum + " since the start, or name the column " + of.rate});
        rows.push_back(row);
    }
    problems.throw_if_any();
    return rows;
}

/// The scene's own, or the one named in the line's column. Throws Error(input).
std::string hydrograph_file(const SceneReading& reading, const Feature& feature, std::size_t number) {
    const std::string& given = *reading.scene.inflow.hydrograph;
    const std::string k_attribute = "attribute:";
    if (given.rfind(k_attribute, 0) != 0) return given;
    const std::string column = trimmed(given.substr(k_attribute.size()));
    const auto found = feature.texts.find(column);
    if (found == feature.texts.end() || found->second.empty()) {
        throw Error(ErrorKind::input, Problem{"line " + std::to_string(number) + " has no attribute " + column,
                                              reading.where("inflow.hydrograph"), "", "", "Name one of its columns"});
    }
    const std::size_t slash = reading.scene.file.find_last_of('/');
    return absolute_path(found->second, reading.scene.file.substr(0, slash));
}

}  // namespace

Hydrograph read_hydrograph(const std::string& file, const Place& where, double gravity, double line_length) {
    const std::string place = where + ": " + file;
    const gis::Table table = gis::read_table(file, where);
    const Columns columns = columns_of(table, k_flow, place);
    const std::vector<Row> rows = rows_of(table, columns, k_flow, place);
    Hydrograph hydrograph{{},
                          columns.time.is_named,
                          columns.cumulative || columns.amount->is_named,
                          !columns.speed || columns.speed->is_named};
    std::vector<HydrographPoint>& points = hydrograph.points;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (!columns.cumulative) {
            points.push_back({rows[i].time, rows[i].amount, rows[i].speed});
        } else if (i > 0) {  // constant between two readings
            const double discharge = (rows[i].amount - rows[i - 1].amount) / (rows[i].time - rows[i - 1].time);
            points.push_back({rows[i - 1].time, discharge, rows[i - 1].speed});
            points.push_back({rows[i].time, discharge, rows[i].speed});
        }
    }
    if (!columns.speed)
        for (HydrographPoint& point : points) point.speed = critical_speed(gravity, point.discharge, line_length);
    Problems problems;
    check_hydrograph(points, place, problems);
    problems.throw_if_any();
    return hydrograph;
}

RainTable read_rain(const std::string& file, const Place& where) {
    const std::string place = where + ": " + file;
    const gis::Table table = gis::read_table(file, where);
    const Columns columns = columns_of(table, k_rain, place);
    const std::vector<Row> rows = rows_of(table, columns, k_rain, place);
    RainTable read;
    Rain& rain = read.rain;
    if (columns.raster) {
        const std::string folder = file.substr(0, file.find_last_of('/'));
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const std::string name = trimmed(table.rows[i][columns.raster->index]);
            rain.points.push_back({rows[i].time, 0});
            read.rasters.push_back(name.empty() ? "" : absolute_path(name, folder));
        }
        if (rows.size() >= 2 && read.rasters.back().empty()) return read;
        throw Error(ErrorKind::input, Problem{"does not say when the rain ends", place, "", "",
                                              "Add a last row with that time and no raster"});
    }
    double heaviest = 0;
    const auto add = [&](double time, double rate) {
        heaviest = std::max(heaviest, rate);
        rain.points.push_back({time, rate / k_mm_per_hour});
    };
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (!columns.cumulative) {
            add(rows[i].time, rows[i].amount);
        } else if (i > 0) {  // constant between two readings
            const double rate = 3600 * (rows[i].amount - rows[i - 1].amount) / (rows[i].time - rows[i - 1].time);
            add(rows[i - 1].time, rate);
            add(rows[i].time, rate);
        }
    }
    const Parameter& key = *find_parameter(scene_parameters(), "structured.rain");
    if (heaviest > 0 && key.fits(heaviest)) return read;
    const PlausibleRange* const other = range_without(key.name(), heaviest);
    throw Error(ErrorKind::input,
                Problem{"the heaviest rain is not plausible", place, shortest_text(heaviest) + " mm/h",
                        key.limits + " [" + key.unit + "]",
                        other != nullptr ? other->meant(heaviest).text()
                                         : "Correct the column, or name its unit: rain_mm/h, depth_mm"});
}

namespace {

/// Warns of values that mean something else in another unit, where none is named.
void question_units(const Hydrograph& hydrograph, double line_length, double end, Findings found) {
    constexpr double k_most_hours = 48, k_part_of_run = 0.01, k_deep = 20;
    const double last = hydrograph.points.back().time;
    double depth = 0, speed = 0;
    for (const HydrographPoint& point : hydrograph.points) {
        speed = std::max(speed, point.speed);
        if (point.discharge > 0) depth = std::max(depth, point.discharge / (line_length * point.speed));
    }
    if (!hydrograph.has_time_unit && last <= k_most_hours && last < k_part_of_run * end)
        found.warn(worded("hydrograph ends at {1} s of {2} s: time_s or time_h?",
                          {numeral(shortest_text(last)), numeral(grouped(end))}));
    if (!hydrograph.has_discharge_unit && depth > k_deep)
        found.warn(worded("hydrograph {1} m deep on its line: discharge_l/s?", {numeral(number_text(depth, 3))}));
    if (const auto warning = implausible(k_hydrograph_velocity, speed); warning && !hydrograph.has_speed_unit)
        found.warn(*warning);
}

/// Warns of a hydrograph of which a part would flow in after the end of the run.
void warn_of_late_volume(const std::vector<HydrographPoint>& points, double end, Findings found) {
    constexpr double k_late = 0.05;
    double all = 0, late = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const HydrographPoint &a = points[i - 1], &b = points[i];
        const double length = b.time - a.time, volume = length * (a.discharge + b.discharge) / 2;
        all += volume;
        if (b.time <= end) continue;
        const double from = std::clamp((end - a.time) / length, 0.0, 1.0);
        const double at = a.discharge + from * (b.discharge - a.discharge);
        late += (1 - from) * length * (at + b.discharge) / 2;
    }
    if (late > k_late * all)
        found.warn(worded("{1} % of the hydrograph's {2} m3 after time.end = {3} s",
                          {numeral(number_text(100 * late / all, 2)), numeral(grouped(all)), numeral(grouped(end))}));
}

}  // namespace

std::vector<Inflow> prepare_inflow(const SceneReading& reading, const TerrainInput* ground,
                                   std::vector<UsedFile>& files, Findings found, Problems& problems) {
    std::vector<Inflow> inflows;
    const InflowSpec& spec = reading.scene.inflow;
    if (!spec.line || !spec.hydrograph) return inflows;
    attempt(problems, [&] {
        const gis::FeatureLayer layer = reading.session.read(gis::read_lines, *spec.line, target_crs(reading, ground),
                                                             reading.where("inflow.line"));
        found.log.note("inflow " + *spec.line + ": " + std::to_string(layer.features.size()) + " lines in " +
                       layer.crs_label);
        files.push_back(used_lines(worded("Inflow line"), *spec.line, layer));
        if (ground != nullptr)
            report_transform(worded("Inflow line"), layer.transform, ground->terrain.grid.cell_size, found);
        if (layer.features.size() > 1 && spec.hydrograph->rfind("attribute:", 0) != 0) {
            problems.add({"the layer contains several lines for one hydrograph", reading.where("inflow.line"),
                          std::to_string(layer.features.size()) + " lines", "1",
                          "Give each line its own: inflow.hydrograph = attribute:NAME"});
            return;
        }
        for (std::size_t i = 0; i < layer.features.size(); ++i) {
            const Feature& feature = layer.features[i];
            Inflow inflow;
            inflow.line = feature.shape.lines.front();
            std::string hydrograph;
            if (spec.direction) inflow.azimuth = *spec.direction * std::numbers::pi / 180;
            const double length = ground != nullptr ? length_of(inflow.line) : 1;
            const auto read_it = [&] {
                hydrograph = hydrograph_file(reading, feature, i + 1);
                const Hydrograph read = read_hydrograph(hydrograph, reading.where("inflow.hydrograph"),
                                                        reading.scene.numerics.gravity, length);
                if (ground != nullptr) question_units(read, length, reading.scene.time.end, found);
                inflow.hydrograph = read.points;
            };
            if (!attempt(problems, read_it)) continue;
            const auto flows = [](const HydrographPoint& point) { return point.discharge > 0; };
            const auto first = std::find_if(inflow.hydrograph.begin(), inflow.hydrograph.end(), flows);
            // Between two rows the discharge is linear.
            const double begins = (first == inflow.hydrograph.begin() ? first : first - 1)->time;
            if (begins >= reading.scene.time.end)
                problems.add({"the hydrograph begins after the end of the run",
                              reading.where("inflow.hydrograph") + ": " + hydrograph, shortest_text(begins) + " s",
                              "before " + shortest_text(reading.scene.time.end) + " s",
                              "Raise time.end, or correct the column time"});
            if (ground == nullptr) continue;
            const Bounds box = bounds(MultiPolygon{{inflow.line, {}}});
            if (!is_on_ground(reading, "inflow.line", box, *ground, false, problems)) continue;
            warn_of_late_volume(inflow.hydrograph, reading.scene.time.end, found);
            found.log.note("line " + std::to_string(i + 1) + ": " + number_text(length, 4) + " m, from " +
                           shortest_text(inflow.hydrograph.front().time) + " s to " +
                           shortest_text(inflow.hydrograph.back().time) + " s");
            files.push_back(used_hydrograph(hydrograph, inflow.hydrograph));
            inflows.push_back(std::move(inflow));
        }
    });
    return inflows;
}

}  // namespace frana::app
