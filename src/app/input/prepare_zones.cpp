// SPDX-License-Identifier: Apache-2.0
#include "app/input/prepare_zones.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "analysis/trace.h"
#include "app/input/layer_values.h"
#include "app/input/on_demand.h"
#include "app/input/used_file.h"
#include "app/text/number_text.h"
#include "core/words/words.h"
#include "gis/raster/footprint.h"
#include "gis/raster/raster_in.h"
#include "gis/vector/vector_in.h"
#include "params/keys/laws.h"
#include "params/keys/plausible.h"
#include "params/keys/zone_keys.h"
#include "simulation/scene_values.h"

namespace frana::app {
namespace {

/// A key of [zones] and its value, or the column used for it.
struct Quantity {
    const ZoneKey* key;
    std::optional<SourceSpec> source;
    std::optional<Raster> MaterialZones::*target;
};

std::vector<Quantity> quantities(const ZonesSpec& spec) {
    std::vector<Quantity> list;
    for (const ZoneKey& key : zone_keys()) list.push_back({&key, spec.*key.source, raster_of(key)});
    return list;
}

bool quantity_by_attribute(const Quantity& quantity) {
    return quantity.source && quantity.source->kind == SourceSpec::Kind::attribute;
}

/// If no key names a column, columns with a standard name are used; a shapefile truncates names to ten letters.
void name_columns(const SceneReading& reading, const gis::PolygonLayer& layer, std::vector<Quantity>& list,
                  Findings found, Problems& problems) {
    if (std::any_of(list.begin(), list.end(), quantity_by_attribute)) return;
    const auto& numbers = layer.features.front().numbers;
    std::string known, expected;
    for (const auto& number : numbers) known += (known.empty() ? "" : ", ") + number.first;
    bool any = false;
    for (Quantity& quantity : list) {
        for (const std::string& column : quantity.key->columns) {
            expected += (expected.empty() ? "" : ", ") + column;
            for (const std::string& name : {column, column.substr(0, 10)}) {
                if (numbers.count(name) == 0 || quantity.source) continue;
                quantity.source = SourceSpec{SourceSpec::Kind::attribute, 0, name};
                found.log.note("zones: column " + name + " taken for " + quantity.key->name);
                any = true;
            }
        }
    }
    if (!any) {
        problems.add({"no column of the zones has a name that frana knows", reading.where("terrain.friction-zones"),
                      known.empty() ? "no numeric column" : known, expected,
                      "Name one, for example zones.friction-angle = attribute:NAME"});
    } else if (list[0].source && list[1].source) {
        problems.add({"the zones have a friction angle and a friction coefficient",
                      reading.where("terrain.friction-zones"), list[0].source->name + ", " + list[1].source->name, "",
                      "Name one of them in zones.friction-angle or zones.friction-coefficient"});
    }
}

/// The value of a feature; warns of one that is unusual, if a law uses it.
std::optional<double> zone_value(const SceneReading& reading, const Quantity& quantity, const gis::PolygonLayer& layer,
                                 std::size_t feature, Findings found, Problems& problems) {
    const auto value = value_of(reading, quantity.key->name, *quantity.source, layer, feature, problems);
    const bool is_used = !readers_of(quantity.key->name, laws_of(reading.scene)).empty();
    if (const auto warning = value && is_used ? implausible(quantity.key->name, *value) : std::nullopt)
        found.warn(*warning);
    return value;
}

Sentence fraction_of(std::int64_t cells, const GridSpec& grid) {
    return worded(
        "{1} m2, {2} % of the working grid",
        {numeral(grouped(static_cast<double>(cells) * grid.cell_area())),
         numeral(number_text(100.0 * static_cast<double>(cells) / static_cast<double>(grid.cell_count()), 3))});
}

/// Counts cells in no zone that are enclosed by zones.
std::int64_t enclosed_gaps(const std::vector<int>& times, const GridSpec& grid) {
    std::vector<char> open(times.size(), 0);
    std::vector<std::size_t> stack;
    const auto enter = [&](std::int64_t row, std::int64_t column) {
        if (row < 0 || column < 0 || row >= grid.rows || column >= grid.columns) return;
        const auto i = static_cast<std::size_t>(row * grid.columns + column);
        if (times[i] > 0 || open[i]) return;
        open[i] = 1;
        stack.push_back(i);
    };
    for (std::int64_t row = 0; row < grid.rows; ++row) {
        enter(row, 0);
        enter(row, grid.columns - 1);
    }
    for (std::int64_t column = 0; column < grid.columns; ++column) {
        enter(0, column);
        enter(grid.rows - 1, column);
    }
    while (!stack.empty()) {
        const auto i = static_cast<std::int64_t>(stack.back());
        stack.pop_back();
        for (const auto& [dr, dc] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}})
            enter(i / grid.columns + dr, i % grid.columns + dc);
    }
    std::int64_t enclosed = 0;
    for (std::size_t i = 0; i < times.size(); ++i) enclosed += times[i] == 0 && !open[i];
    return enclosed;
}

void report_cover(const std::vector<int>& times, const GridSpec& grid, Findings found) {
    std::int64_t twice = 0, never = 0;
    for (const int n : times) {
        twice += n > 1;
        never += n == 0;
    }
    if (twice > 0)
        found.warn(
            worded("zones overlap on {1}: the later feature of the layer applies there", {fraction_of(twice, grid)}));
    if (const std::int64_t gaps = enclosed_gaps(times, grid); gaps > 0)
        found.warn(worded("gaps between the zones on {1}: the material's own values apply", {fraction_of(gaps, grid)}));
    if (never > 0)
        found.log.note("outside all zones, with the material's own values: " + fraction_of(never, grid).text());
}

void burn(const SceneReading& reading, const gis::PolygonLayer& layer, const GridSpec& grid,
          const std::vector<Quantity>& list, MaterialZones& zones, Findings found, Problems& problems) {
    std::vector<int> times(static_cast<std::size_t>(grid.cell_count()), 0);
    for (std::size_t f = 0; f < layer.features.size(); ++f) {
        std::vector<std::pair<Raster*, double>> values;
        for (const Quantity& quantity : list) {
            if (!quantity_by_attribute(quantity)) continue;
            const auto value = zone_value(reading, quantity, layer, f, found, problems);
            if (!value) continue;
            std::optional<Raster>& raster = zones.*quantity.target;
            if (!raster) raster.emplace(grid, k_no_data);
            values.emplace_back(&*raster, quantity.key->stored(*value));
        }
        gis::visit_cells(layer.features[f].shape.areas, grid, gis::Cover::centres,
                         [&](std::int64_t row, std::int64_t column) {
                             ++times[static_cast<std::size_t>(row * grid.columns + column)];
                             for (const auto& [raster, value] : values) raster->at(row, column) = value;
                         });
    }
    report_cover(times, grid, found);
}

/// The same where the ground is read where the flow comes: nothing is burned before a cell is asked for.
void burn_on_demand(const SceneReading& reading, const gis::PolygonLayer& layer, const GridSpec& grid,
                    const MultiPolygon& released, const std::vector<Quantity>& list, MaterialZones& zones,
                    Findings found, Problems& problems) {
    for (const Quantity& quantity : list) {
        if (!quantity_by_attribute(quantity)) continue;
        std::vector<std::optional<double>> values;
        for (std::size_t f = 0; f < layer.features.size(); ++f) {
            values.push_back(zone_value(reading, quantity, layer, f, found, problems));
            if (!values.back()) continue;
            values.back() = quantity.key->stored(*values.back());
            if (quantity.key->what == "friction")
                check_zone_friction(reading.scene, *values.back(), reading.where("terrain.friction-zones"), problems);
        }
        zones.*quantity.target = polygon_values_on_demand(grid, layer.features, values);
        look_under(released, *(zones.*quantity.target));
    }
    found.log.note(
        "zones are looked at where the release lies and where the flow comes: overlaps and gaps are not counted");
}

void read_polygon_zones(const SceneReading& reading, const TerrainInput* ground, const MultiPolygon& released,
                        std::vector<Quantity>& list, MaterialZones& zones, std::vector<UsedFile>& files, Findings found,
                        Problems& problems) {
    const std::string key = "terrain.friction-zones", file = *reading.scene.terrain.friction_zones;
    const gis::PolygonLayer layer =
        reading.session.read(gis::read_polygons, file, target_crs(reading, ground), reading.where(key), {});
    found.log.note("zones " + file + ": " + std::to_string(layer.features.size()) + " features in " + layer.crs_label);
    found.warn_of(worded("Zones"), layer.warnings);
    files.push_back(used_polygons(worded("Zones"), file, layer));
    name_columns(reading, layer, list, found, problems);
    if (ground == nullptr) return;
    report_transform(worded("Zones"), layer.transform, ground->terrain.grid.cell_size, found);
    if (!is_on_ground(reading, key, layer.bounds, *ground, true, problems)) return;
    const GridSpec& grid = ground->terrain.grid;
    if (ground->on_demand) {
        burn_on_demand(reading, layer, grid, released, list, zones, found, problems);
    } else {
        burn(reading, layer, grid, list, zones, found, problems);
    }
}

/// A raster of zones of which nothing is read yet but what lies under the release.
Raster friction_raster_on_demand(const SceneReading& reading, const TerrainInput& ground, const Quantity& quantity,
                                 const MultiPolygon& released, std::vector<UsedFile>& files, Findings found) {
    double least_limit = HUGE_VAL;
    for (const Law* law : laws_of(reading.scene)) least_limit = std::min(least_limit, law->greatest_friction);
    // Called as long as the run lasts.
    const auto convert = [reading, of = *quantity.key, least_limit](double read) {
        const double value = of.stored(read);
        const bool may_be_wrong = !of.range.has(read) || (of.what == "friction" && value > least_limit);
        if (!may_be_wrong) return value;
        Problems problems;
        (void)within_limits(reading, of.name, read, "a value of the raster", problems);
        if (of.what == "friction")
            check_zone_friction(reading.scene, value, reading.where("terrain.friction-zones"), problems);
        problems.throw_if_any();
        return value;
    };
    return zone_raster_on_demand(reading, ground, quantity.key->name, quantity.source->name, released, convert, files,
                                 found);
}

}  // namespace

std::optional<Raster> read_zone_raster(const SceneReading& reading, const TerrainInput* ground, const std::string& key,
                                       const std::string& file, bool tell_gaps, std::vector<UsedFile>& files,
                                       Findings found, Problems& problems) {
    const Place where = reading.where(key);
    const gis::RasterInfo info = reading.session.read(gis::inspect_raster, file, where);
    if (ground == nullptr) return std::nullopt;
    const GridSpec& grid = ground->terrain.grid;
    if (!grid.crs_wkt.empty() && info.crs_wkt.empty()) {
        problems.add({"has no coordinate reference system", where, file, "", k_state_zone_crs});
        return std::nullopt;
    }
    gis::RasterRead read = reading.session.read(gis::read_raster_on, file, grid, "", gis::Resampling::automatic,
                                                "metre", std::nullopt, "");
    found.warn_of(key, read.warnings);
    report_transform(key, read.transform, grid.cell_size, found);
    files.push_back(used_raster("Zones: " + key, info, read));
    if (read.nodata_cells >= grid.cell_count()) {
        problems.add({"has no value anywhere on the working grid", where, file, "",
                      "Check its position and coordinate reference system"});
        return std::nullopt;
    }
    double least = std::numeric_limits<double>::infinity(), greatest = -least;
    for (const double value : read.raster.values) {
        if (std::isnan(value)) continue;
        least = std::min(least, value);
        greatest = std::max(greatest, value);
    }
    if (!within_limits(reading, key, least, "the raster's least value", problems) ||
        !within_limits(reading, key, greatest, "the raster's greatest value", problems))
        return std::nullopt;
    for (const double value : {least, greatest})
        if (const auto warning = implausible(key, value)) found.warn(*warning);
    if (read.nodata_cells > 0 && tell_gaps)
        found.warn(
            worded("{1}: no value on {2}, the material's own applies", {key, fraction_of(read.nodata_cells, grid)}));
    return std::move(read.raster);
}

std::optional<Raster> prepare_forest(const SceneReading& reading, const TerrainInput* ground,
                                     std::vector<UsedFile>& files, Findings found, Problems& problems) {
    const std::optional<std::string>& file = reading.scene.friction_table.forest;
    if (!file) return std::nullopt;
    return attempt(problems, [&]() -> std::optional<Raster> {
        const std::string key = "material.forest";
        const gis::PolygonLayer layer =
            reading.session.read(gis::read_polygons, *file, target_crs(reading, ground), reading.where(key), {});
        found.log.note(key + " " + *file + ": " + std::to_string(layer.features.size()) + " features in " +
                       layer.crs_label);
        found.warn_of(key, layer.warnings);
        files.push_back(used_polygons(worded("Forest"), *file, layer));
        if (ground == nullptr) return std::nullopt;
        report_transform(key, layer.transform, ground->terrain.grid.cell_size, found);
        if (!is_on_ground(reading, key, layer.bounds, *ground, true, problems)) return std::nullopt;
        return polygon_values_on_demand(ground->terrain.grid, layer.features,
                                        std::vector<std::optional<double>>(layer.features.size(), 1.0));
    });
}

namespace {

/// "5 000 – 25 000 m³"
std::string limits_text(const std::vector<double>& limits, std::size_t at, const std::string& unit) {
    const auto limit = [&](std::size_t which) { return grouped(limits[which]); };
    return (at == 0               ? "< " + limit(0)
            : at == limits.size() ? "≥ " + limit(at - 1)
                                  : limit(at - 1) + " – " + limit(at)) +
           " " + unit;
}

}  // namespace

Sentence class_text(const std::vector<double>& limits, std::size_t at, const std::string& unit) {
    return limits.empty() ? Sentence(worded("all")) : numeral(limits_text(limits, at, unit));
}

Sentence friction_text(const FrictionChoice& choice) {
    const FrictionTable& table = choice.table;
    const auto close = choice.close_class();
    return worded(
        "{1}, {2} years, {3} m³ (class {4}); source {5}; {6}",
        {table.called.c_str(), numeral(shortest_text(table.periods[choice.period])), numeral(grouped(choice.volume)),
         close ? numeral(limits_text(table.volumes, choice.volume_class(), "m³") +
                         "; ± 5 %: " + limits_text(table.volumes, *close, "m³"))
               : class_text(table.volumes, choice.volume_class(), "m³"),
         table.named_source,
         table.is_source_read() ? worded("read at {1}", {table.read_at}) : Sentence(worded("not read"))});
}

MaterialZones prepare_zones(const SceneReading& reading, const TerrainInput* ground, const MultiPolygon& released,
                            std::vector<UsedFile>& files, Findings found, Problems& problems) {
    MaterialZones zones;
    std::vector<Quantity> list = quantities(reading.scene.zones);
    attempt(problems, [&] {
        if (reading.scene.terrain.friction_zones)
            read_polygon_zones(reading, ground, released, list, zones, files, found, problems);
    });
    for (const Quantity& quantity : list) {
        if (!quantity.source || quantity.source->kind != SourceSpec::Kind::raster) continue;
        attempt(problems, [&] {
            if (ground != nullptr && ground->on_demand) {
                zones.*quantity.target = friction_raster_on_demand(reading, *ground, quantity, released, files, found);
                return;
            }
            std::optional<Raster> raster = read_zone_raster(reading, ground, quantity.key->name, quantity.source->name,
                                                            true, files, found, problems);
            if (!raster) return;
            for (double& value : raster->values) value = quantity.key->stored(value);
            zones.*quantity.target = std::move(raster);
        });
    }
    return zones;
}

void refuse_unused_zones(const SceneReading& reading, const Scene& scene, Problems& problems) {
    std::string reported;  // friction once, though it has two keys
    for (const Quantity& quantity : quantities(reading.scene.zones)) {
        const ZoneKey& key = *quantity.key;
        if (!(scene.zones.*quantity.target) || key.what == reported) continue;
        check_zone_use(key, reading.scene, reading.where("terrain.friction-zones"), problems);
        reported = key.what;
    }
    if (const auto& friction = scene.zones.friction_coefficient; friction && !friction->values.is_tiled())
        check_zone_friction(reading.scene, maximum(*friction), reading.where("terrain.friction-zones"), problems);
}

}  // namespace frana::app
