// SPDX-License-Identifier: Apache-2.0
#include "simulation/scene_values.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/text.h"
#include "params/keys/laws.h"
#include "params/keys/material_parameters.h"
#include "simulation/arrivals.h"
#include "simulation/release.h"

namespace frana {
namespace {

void set(double& target, const std::optional<double>& value) {
    if (value) target = *value;
}

void set_tangent(double& target, const std::optional<double>& angle_deg) {
    if (angle_deg) target = tangent_of(*angle_deg);
}

/// Returns the number of a uniform property.
std::optional<double> constant(const std::optional<SourceSpec>& source) {
    if (!source || source->kind != SourceSpec::Kind::number) return std::nullopt;
    return source->number;
}

}  // namespace

std::optional<StructuredMaterial> structured_of(const SceneSpec& spec) {
    if (spec.material.model != "structured") return std::nullopt;
    const StructuredSpec& s = spec.structured;
    StructuredMaterial m;
    m.solids = s.phases == "solids-and-fluid";
    static_cast<StructuredValues&>(m) = s;
    for (const SolidKey& key : solid_keys()) {
        const std::optional<double> value = constant(s.*key.in_use(s).source);
        if (key.degrees())
            set_tangent(m.*key.value, value);
        else
            set(m.*key.value, value);
    }
    m.sin_dilatancy = std::sin(s.dilatancy_angle * std::numbers::pi / 180);
    m.pores = pore_pressure_of(spec.material);
    if (const double rain = constant(s.rain).value_or(0); rain > 0)
        m.rain.points = {{0, rain / k_mm_per_hour}, {spec.time.end, rain / k_mm_per_hour}};
    m.more_fluid = m.rain.falls();
    if (s.soil_conductivity)
        m.soil = GreenAmpt{constant(s.soil_conductivity).value_or(0) / k_mm_per_hour,
                           constant(s.soil_suction).value_or(0), constant(s.soil_moisture_deficit).value_or(0)};
    return m;
}

void set_values(const SceneSpec& spec, Scene& scene) {
    scene.terrain_contains_release = spec.release.dtm_contains_release;
    scene.release_volume = release_volume_of(spec.release);
    scene.material = spec.material;
    scene.entrainment = spec.entrainment;
    scene.numerics = spec.numerics;
    static_cast<TimeValues&>(scene.time) = spec.time;
    scene.time.end = spec.time.end;
    scene.time.stop_change = spec.time.stop_change;
    scene.time.trace_threshold = std::max(spec.output.trace_threshold, spec.numerics.minimum_depth);
    scene.time.frame_interval = frame_interval(spec);
    scene.recording.interval = spec.output.sample_interval.value_or(0);
    scene.recording.normal_depth = spec.output.depth == k_normal_depth;
    // What is of one moment is recorded where somebody uses it.
    const auto& scheme = spec.hazard.resolved;
    scene.recording.plane_stress = asks_for_plane_stress(spec.output);
    scene.recording.intensity = asks_for_intensity(spec.output) || !spec.output.momentum_flux_thresholds.empty() ||
                                (scheme && (scheme->uses(HazardQuantity::flux) || scheme->uses(HazardQuantity::head) ||
                                            scheme->uses(HazardQuantity::momentum)));
}

void set_uniform_details(const ReleaseSpec& spec, ReleaseArea& area) {
    area.normal_to_bed = spec.thickness_direction == "normal";
    area.start = constant(spec.start).value_or(0);
    area.speed = constant(spec.velocity).value_or(0);
    if (const auto degrees = constant(spec.direction)) area.azimuth = *degrees * std::numbers::pi / 180;
}

std::optional<double> release_volume_of(const ReleaseSpec& spec) {
    return constant(spec.volume);
}

bool check_hydrograph(const std::vector<HydrographPoint>& hydrograph, const Place& where, Problems& problems) {
    const auto refuse = [&](const char* what, const std::string& value, const std::string& limit, const char* remedy) {
        problems.add({what, where, value, limit, remedy});
        return false;
    };
    if (hydrograph.size() < 2)
        return refuse("the hydrograph has fewer than two rows", std::to_string(hydrograph.size()), "2 or more",
                      "Give its start and its end");
    const auto good = [](double value) { return value >= 0 && value <= k_most_of_hydrograph; };
    bool flows = false;
    double before = 0;
    for (const HydrographPoint& point : hydrograph) {
        const std::string time = shortest_text(point.time) + " s";
        if (!good(point.time) || !good(point.discharge) || !good(point.speed))
            return refuse(
                "the hydrograph is out of range",
                time + ", " + shortest_text(point.discharge) + " m3/s, " + shortest_text(point.speed) + " m/s",
                "0 to " + shortest_text(k_most_of_hydrograph), "Correct it");
        if (point.time < before)
            return refuse("the times of the hydrograph fall", time, shortest_text(before) + " s or later",
                          "Sort it by time");
        if (point.discharge > 0 && !(point.speed > 0))
            return refuse("the hydrograph has a discharge without velocity", "at " + time, "greater than 0 m/s",
                          "Correct it, or give no velocities for the critical speed");
        flows = flows || point.discharge > 0;
        before = point.time;
    }
    return flows || refuse("the hydrograph has no discharge", "", "", "Give a discharge above zero");
}

void check_thickness(double thickness, const Place& where, Problems& problems) {
    if (thickness >= k_least_thickness && thickness <= k_most_thickness) return;
    const bool thick = thickness > k_most_thickness;
    problems.add(
        {std::string("would be ") + (thick ? "thicker" : "thinner") + " than any landslide", where,
         shortest_text(thickness) + " m",
         (thick ? "at most " + shortest_text(k_most_thickness) : "at least " + shortest_text(k_least_thickness)) + " m",
         "Check the unit, the sign and the values that stand for no data"});
}

void check_names(std::vector<std::string> names, const Place& where, Problems& problems) {
    std::sort(names.begin(), names.end());
    const auto twice = std::adjacent_find(names.begin(), names.end());
    if (twice != names.end()) problems.add({"two have the same name", where, *twice, "", "Give each a unique name"});
}

void check_inside(const Polyline& places, const GridSpec& grid, const std::string& name, const Place& where,
                  Problems& problems) {
    const auto outside = std::find_if(places.begin(), places.end(), [box = grid.bounds()](const Point& p) {
        return !is_within({p.x, p.y, p.x, p.y}, box);
    });
    if (outside == places.end()) return;
    problems.add({"lies outside the working grid", where,
                  name + " at " + shortest_text(outside->x) + ", " + shortest_text(outside->y),
                  extent_text(grid.bounds()), "Move it, or take a larger DTM or terrain.bounds"});
}

void check_zone_friction(const SceneSpec& spec, double greatest, const Place& where, Problems& problems) {
    for (const Law* law : laws_of(spec)) {
        if (!(greatest > law->greatest_friction)) continue;
        problems.add({"the friction by place is too large for the law " + law->word, where,
                      shortest_text(std::round(greatest * 1e4) / 1e4), "0 to " + shortest_text(law->greatest_friction),
                      "The law is not defined above that"});
    }
}

namespace {

/// The values of a zone raster, and where it has none those of the table.
Raster filled_by_table(const std::optional<Raster>& zones, const std::shared_ptr<const FrictionByPlace>& friction,
                       double FrictionPair::*value) {
    const Raster& terrain = friction->terrain();
    const auto source = [zones, friction, value](const CellWindow& window, double* cells) {
        for (std::int64_t row = window.row; row < window.row + window.rows; ++row)
            for (std::int64_t column = window.column; column < window.column + window.columns; ++column, ++cells) {
                *cells = zones ? zones->at(row, column) : k_no_data;
                if (!std::isnan(*cells)) continue;
                if (const auto place = friction->at(row, column)) *cells = place->values.*value;
            }
    };
    const GridSpec& grid = terrain.grid;
    Raster raster;
    raster.grid = grid;
    if (terrain.values.is_tiled()) {
        raster.values = CellValues::tiled(grid.rows, grid.columns, k_no_data, source);
    } else {
        raster = Raster(grid);
        source({0, 0, grid.rows, grid.columns}, raster.values.data());
    }
    return raster;
}

}  // namespace

std::shared_ptr<const FrictionByPlace> set_table_friction(const SceneSpec& spec, std::optional<Raster> forest,
                                                          const Place& where, Scene& scene, Problems& problems) {
    const FrictionTableSpec& keys = spec.friction_table;
    if (!keys.resolved || !keys.return_period) return nullptr;
    FrictionChoice choice{
        .table = *keys.resolved, .friction_factor = keys.friction_factor, .turbulence_factor = keys.turbulence_factor};
    FrictionTable& table = choice.table;
    if (!keys.altitude_limits.empty()) table.altitudes = keys.altitude_limits;
    choice.period = static_cast<std::size_t>(
        std::find(table.periods.begin(), table.periods.end(), *keys.return_period) - table.periods.begin());
    choice.volume = keys.volume ? *keys.volume : make_release(scene).volume;
    for (const Inflow& inflow : scene.inflows)
        if (!keys.volume) choice.volume += volume_of(inflow, scene.time.end);
    double greatest = 0;
    for (std::size_t kind = 0; kind < table.terrain.size(); ++kind)
        for (std::size_t band = 0; band <= table.altitudes.size(); ++band)
            for (const bool forested : {false, forest.has_value()})
                greatest = std::max(greatest, choice.at(kind, band, forested).coefficient);
    check_zone_friction(spec, greatest, where, problems);
    const auto friction = std::make_shared<const FrictionByPlace>(std::move(choice), scene.terrain, std::move(forest));
    MaterialZones& zones = scene.zones;
    zones.friction_coefficient = filled_by_table(zones.friction_coefficient, friction, &FrictionPair::coefficient);
    zones.turbulence = filled_by_table(zones.turbulence, friction, &FrictionPair::turbulence);
    return friction;
}

std::optional<Raster> MaterialZones::*raster_of(const ZoneKey& key) {
    return std::find_if(std::begin(k_zone_rasters), std::end(k_zone_rasters),
                        [&](const ZoneRaster& raster) { return raster.what == key.what; })
        ->raster;
}

void check_zone_use(const ZoneKey& key, const SceneSpec& spec, const Place& where, Problems& problems) {
    if (!readers_of(key.name, laws_of(spec)).empty()) return;
    problems.add({"gives the " + key.what + ", which the scene's laws do not use", where, "", "",
                  "Set " + selected_by(readers_of(key.name)) + ", or remove the values"});
}

}  // namespace frana
