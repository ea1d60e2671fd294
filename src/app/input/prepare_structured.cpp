// SPDX-License-Identifier: Apache-2.0
#include "app/input/prepare_structured.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "app/input/check_inputs.h"
#include "app/input/layer_values.h"
#include "app/input/on_demand.h"
#include "app/input/prepare_inflow.h"
#include "app/input/prepare_release.h"
#include "app/input/prepare_zones.h"
#include "app/input/used_file.h"
#include "app/text/number_text.h"
#include "core/words/words.h"
#include "gis/raster/footprint.h"
#include "models/structured/solid/solid_laws.h"
#include "params/keys/material_parameters.h"
#include "params/keys/scene_parameters.h"
#include "simulation/run_check.h"
#include "simulation/run_warnings.h"
#include "simulation/scene.h"
#include "simulation/scene_values.h"
#include "simulation/structured_laws.h"

namespace frana::app {
namespace {

bool is_given(const SceneReading& reading, const std::string& key) {
    return reading.scene.origin_of(key) != Origin::default_value;
}

/// The greatest thickness of anything released [m].
double thickest(const ReleaseInput& release, const GridSpec& grid) {
    double most = 0;
    for (const ReleaseArea& area : release.areas) {
        if (!area.thickness_raster) {
            most = std::max(most, area.thickness);
            continue;
        }
        const Raster& thickness = *area.thickness_raster;
        gis::visit_cells(area.outline, grid, gis::Cover::centres, [&](std::int64_t row, std::int64_t column) {
            if (const double h = thickness.at(row, column); h > most) most = h;
        });
    }
    return most;
}

/// Checks values of the structured model against each other, and the release's thickness against the cells. What has no
/// meaning is added to `problems`; what is legal and dubious, or given and without effect, is warned of.
void check_structured_values(const SceneReading& reading, const StructuredMaterial& m, const ReleaseInput& release,
                             const GridSpec& grid, Findings found, Problems& problems) {
    if (!m.solids) return;
    const auto where = [&](const std::string& key) { return reading.where(key); };
    for (const Problem& problem : structured_problems(m, grid.cell_size, where)) problems.add(problem);
    found.warn_all(structured_warnings(m, thickest(release, grid), grid.cell_size, where,
                                       [&](const std::string& key) { return is_given(reading, key); }));
}

/// A key of [structured] whose value may vary from place to place, and the raster that was read for it.
struct Property {
    std::string key;
    const std::optional<SourceSpec>* source;
    double SolidValues::*value = nullptr;  ///< null: the soil's, or the depth of fluid
    bool degrees = false;                  ///< an angle, stored as its tangent
    double GreenAmpt::*soil = nullptr;
    std::optional<Raster> raster = {};
};

std::vector<Property> properties(const StructuredSpec& spec, bool solids) {
    std::vector<Property> list{
        {"structured.initial-fluid-depth", &spec.initial_fluid_depth},
        {"structured.soil-conductivity", &spec.soil_conductivity, nullptr, false, &GreenAmpt::conductivity},
        {"structured.soil-suction", &spec.soil_suction, nullptr, false, &GreenAmpt::suction},
        {"structured.soil-moisture-deficit", &spec.soil_moisture_deficit, nullptr, false, &GreenAmpt::deficit}};
    if (!solids) return list;
    for (const SolidKey& key : solid_keys()) {
        const SolidKey& used = key.in_use(spec);
        list.push_back({used.name, &(spec.*used.source), key.value, key.degrees()});
    }
    return list;
}

bool has_kind(const Property& property, SourceSpec::Kind kind) {
    return *property.source && (*property.source)->kind == kind;
}

/// Gives cells that only the edge of an outline touches the value of a neighbour inside.
void widen(Raster& raster) {
    constexpr std::pair<int, int> k_beside[] = {{-1, 0}, {1, 0}, {0, -1}, {0, 1}, {-1, -1}, {-1, 1}, {1, -1}, {1, 1}};
    const Raster before = raster;
    const GridSpec& grid = raster.grid;
    const auto exists = [&](std::int64_t row, std::int64_t column) {
        return row >= 0 && column >= 0 && row < grid.rows && column < grid.columns;
    };
    const auto take_from_neighbour = [&](std::int64_t row, std::int64_t column) {
        for (const auto& [dr, dc] : k_beside) {
            if (!exists(row + dr, column + dc) || !before.has_data(row + dr, column + dc)) continue;
            raster.at(row, column) = before.at(row + dr, column + dc);
            return;
        }
    };
    before.values.for_each_stored([&](std::size_t cell, double value) {
        if (std::isnan(value)) return;
        const std::int64_t row = static_cast<std::int64_t>(cell) / grid.columns,
                           column = static_cast<std::int64_t>(cell) % grid.columns;
        for (const auto& [dr, dc] : k_beside)
            if (exists(row + dr, column + dc) && !before.has_data(row + dr, column + dc))
                take_from_neighbour(row + dr, column + dc);
    });
}

void burn(const SceneReading& reading, const gis::PolygonLayer& layer, const GridSpec& grid, Property& property,
          Problems& problems) {
    Raster raster(grid, k_no_data);
    for (std::size_t f = 0; f < layer.features.size(); ++f) {
        const auto value = value_of(reading, property.key, **property.source, layer, f, problems);
        if (!value) return;
        gis::visit_cells(layer.features[f].shape.areas, grid, gis::Cover::closed,
                         [&](std::int64_t row, std::int64_t column) { raster.at(row, column) = *value; });
    }
    if (property.value != nullptr) widen(raster);
    property.raster = std::move(raster);
}

/// Returns the polygons for attribute:NAME; null, with a problem added, if there are none.
const gis::PolygonLayer* polygons(const SceneReading& reading, const TerrainInput* ground, const ReleaseInput& release,
                                  const Property& asking, std::optional<gis::PolygonLayer>& own,
                                  std::vector<UsedFile>& files, Findings found, Problems& problems) {
    const auto& file = reading.scene.structured.zones;
    if (!file) {
        if (release.perimeter) return &*release.perimeter;
        if (!reading.scene.release.perimeter)
            problems.add({"names a column, but the scene has no polygons", reading.where(asking.key),
                          text_of(**asking.source), "", "Set structured.zones or release.perimeter"});
        return nullptr;
    }
    const std::string key = "structured.zones";
    own = reading.session.read(gis::read_polygons, *file, target_crs(reading, ground), reading.where(key), {});
    found.warn_of(key, own->warnings);
    files.push_back(used_polygons(worded("Zones"), *file, *own));
    if (ground == nullptr) return nullptr;
    report_transform(key, own->transform, ground->terrain.grid.cell_size, found);
    return is_on_ground(reading, key, own->bounds, *ground, true, problems) ? &*own : nullptr;
}

/// A property without a uniform value must be known wherever something is released.
void check_cover(const SceneReading& reading, const ReleaseInput& release, const Property& property,
                 const std::optional<Raster>& solid_fraction, Problems& problems) {
    const Raster& raster = *property.raster;
    std::int64_t missing = 0;
    Point first;
    for (const ReleaseArea& area : release.areas) {
        gis::visit_cells(area.outline, raster.grid, gis::Cover::centres, [&](std::int64_t row, std::int64_t column) {
            const std::size_t i = raster.index(row, column);
            const bool empty = area.thickness_raster && !(area.thickness_raster->values[i] > 0);
            const bool no_solids = solid_fraction && solid_fraction->values[i] == 0;
            if (empty || no_solids || !std::isnan(raster.values[i])) return;
            if (missing++ == 0) first = raster.grid.cell_centre(row, column);
        });
    }
    if (missing == 0) return;
    problems.add({"has no value on part of the release", reading.where(property.key),
                  grouped(missing) + " cells, the first at " + number_text(first.x, 9) + ", " + number_text(first.y, 9),
                  "", "Extend the polygons or the raster to all of it"});
}

/// Limits the fluid's place and depth.
void bound_initial_fluid(const std::optional<SourceSpec>& source, const Raster& terrain,
                         const std::optional<Raster>& walls, StructuredMaterial& m) {
    if (source && source->kind == SourceSpec::Kind::number && source->number > 0)
        m.initial_fluid = Raster(terrain.grid, source->number);
    if (!m.initial_fluid) return;
    m.initial_fluid->values.change_each_stored([&](std::size_t cell, double& depth) {
        if (!(depth > 0)) return;
        if (std::isnan(terrain.values[cell]) || (walls && walls->values[cell] == 1)) depth = k_no_data;
    });
    m.more_fluid = true;
}

/// Of a property only the values in cells that the release touches are ever used.
Raster under_release(const Raster& raster, const MultiPolygon& released) {
    Raster kept(raster.grid, k_no_data);
    gis::visit_cells(released, raster.grid, gis::Cover::closed, [&](std::int64_t row, std::int64_t column) {
        if (const double value = raster.at(row, column); !std::isnan(value)) kept.at(row, column) = value;
    });
    return kept;
}

/// A raster of a property on the working grid, in the unit of the scene file.
std::optional<Raster> property_raster(const SceneReading& reading, const TerrainInput* ground,
                                      const MultiPolygon& released, const Property& property,
                                      std::vector<UsedFile>& files, Findings found, Problems& problems) {
    const std::string& file = (*property.source)->name;
    if (ground == nullptr || !ground->on_demand)
        return read_zone_raster(reading, ground, property.key, file, false, files, found, problems);
    const std::vector<Parameter>& parameters = scene_parameters();
    const auto within = [reading, key = property.key,
                         fits = find_parameter(parameters, property.key)->fits](double value) {
        if (!fits || fits(value)) return value;
        Problems wrong;
        (void)within_limits(reading, key, value, "a value of the raster", wrong);
        wrong.throw_if_any();
        return value;
    };
    if (property.value != nullptr)
        return zone_raster_on_demand(reading, *ground, property.key, file, released, within, files, found);
    // Fluid lies where the file says, not only under the release.
    return positive_values_on_demand(reading, *ground, property.key, file, within, files, found);
}

/// Rain over time from a table, the same everywhere or by place.
void prepare_rain(const SceneReading& reading, const TerrainInput* ground, StructuredMaterial& material,
                  std::vector<UsedFile>& files, Findings found, Problems& problems) {
    const std::string key = "structured.rain", &table = reading.scene.structured.rain->name;
    RainTable read = read_rain(table, reading.where(key));
    material.rain = std::move(read.rain);
    if (!read.rasters.empty() && ground != nullptr && ground->on_demand) {
        problems.add({"has rasters, and the terrain is too large to be read as a whole", reading.where(key), table, "",
                      "Cut it with terrain.bounds, or give a rain that is the same everywhere"});
        read.rasters.clear();
    }
    for (std::size_t i = 0; i < read.rasters.size(); ++i) {
        if (read.rasters[i].empty()) continue;
        auto raster = read_zone_raster(reading, ground, key, read.rasters[i], false, files, found, problems);
        if (!raster) continue;
        for (double& intensity : raster->values) intensity /= k_mm_per_hour;
        material.rain_maps.push_back(
            {material.rain.points[i].time, material.rain.points[i + 1].time, std::move(*raster)});
    }
    files.push_back(used_rain(table, material.rain));
    material.more_fluid = true;
}

}  // namespace

std::optional<StructuredMaterial> prepare_structured(const SceneReading& reading, const TerrainInput* ground,
                                                     const ReleaseInput& release, const std::optional<Raster>& walls,
                                                     std::vector<UsedFile>& files, Findings found, Problems& problems) {
    std::optional<StructuredMaterial> material = structured_of(reading.scene);
    if (!material) return material;
    const StructuredSpec& spec = reading.scene.structured;
    const MultiPolygon released = all_outlines(release);
    std::vector<Property> list = properties(spec, material->solids);
    const gis::PolygonLayer* layer = nullptr;
    std::optional<gis::PolygonLayer> own;
    const auto asking = std::find_if(list.begin(), list.end(),
                                     [](const Property& p) { return has_kind(p, SourceSpec::Kind::attribute); });
    attempt(problems, [&] {
        if (asking != list.end()) layer = polygons(reading, ground, release, *asking, own, files, found, problems);
    });
    for (Property& property : list) {
        attempt(problems, [&] {
            if (has_kind(property, SourceSpec::Kind::attribute) && layer != nullptr && ground != nullptr)
                burn(reading, *layer, ground->terrain.grid, property, problems);
            if (has_kind(property, SourceSpec::Kind::raster))
                property.raster = property_raster(reading, ground, released, property, files, found, problems);
        });
    }
    if (spec.rain && spec.rain->kind == SourceSpec::Kind::table)
        attempt(problems, [&] { prepare_rain(reading, ground, *material, files, found, problems); });
    if (material->solids && release.solid_fraction)
        material->zones.push_back({&SolidValues::solid_fraction, *release.solid_fraction});
    if (ground == nullptr) return material;
    for (Property& property : list) {
        if (!property.raster) continue;
        if (property.soil != nullptr) {
            if (property.soil == &GreenAmpt::conductivity)
                property.raster->values.change_each_stored([](std::size_t, double& k) { k /= k_mm_per_hour; });
            material->soil_zones.push_back({property.soil, std::move(*property.raster)});
            continue;
        }
        if (property.value == nullptr) {
            material->initial_fluid = std::move(property.raster);
            continue;
        }
        check_cover(reading, release, property, release.solid_fraction, problems);
        Raster kept = under_release(*property.raster, released);
        if (property.degrees)
            kept.values.change_each_stored(
                [](std::size_t, double& value) { value = std::tan(value * std::numbers::pi / 180); });
        material->zones.push_back({property.value, std::move(kept)});
    }
    check_structured_values(reading, *material, release, ground->terrain.grid, found, problems);
    bound_initial_fluid(spec.initial_fluid_depth, ground->terrain, walls, *material);
    return material;
}

}  // namespace frana::app
