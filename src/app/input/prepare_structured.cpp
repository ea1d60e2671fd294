// SPDX-License-Identifier: Apache-2.0
#include "app/input/prepare_structured.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "app/input/check_inputs.h"
#include "app/input/layer_values.h"
#include "app/input/on_demand.h"
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
#include "simulation/scene.h"
#include "simulation/scene_values.h"
#include "simulation/structured_laws.h"

namespace frana::app {
namespace {

/// Extremes over all materials of a scene.
struct Extremes {
    double cohesion = 0;        ///< [Pa]
    double strain = 0;          ///< elastic, at the uniaxial strength [-]
    double steepest_bed = 0;    ///< greatest bed friction, as an angle [degrees]
    double bed_over_own = 0;    ///< by how much it exceeds the material's own at most [degrees]
    double solid_fraction = 0;  ///< greatest
    double least_solid_fraction = 1;

    explicit Extremes(const StructuredMaterial& m) {
        const auto degrees = [](double tangent) { return std::atan(tangent) * 180 / std::numbers::pi; };
        visit_materials(m, [&](const SolidValues& solid) {
            cohesion = std::max(cohesion, solid.cohesion);
            steepest_bed = std::max(steepest_bed, degrees(solid.bed_friction));
            bed_over_own = std::max(bed_over_own, degrees(solid.bed_friction) - degrees(solid.friction));
            solid_fraction = std::max(solid_fraction, solid.solid_fraction);
            least_solid_fraction = std::min(least_solid_fraction, solid.solid_fraction);
            if (solid.cohesion > 0 && solid.friction >= 0)
                strain = std::max(strain, structured::DruckerPrager::of(solid.friction, solid.cohesion).uniaxial() *
                                              m.modulus_reduction / m.young_modulus);
        });
    }
};

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

void warn_of_keys_without_effect(const SceneReading& reading, const StructuredMaterial& m, const Extremes& e,
                                 RunLog& log) {
    if (m.fluid_viscosity == 0) {
        for (const char* key : {"structured.mobility", "structured.viscosity-growth",
                                "structured.solids-profile-factor", "structured.velocity-profile-factor"})
            if (is_given(reading, key))
                log.warn(worded("{1} has no effect: structured.fluid-viscosity is 0", {reading.where(key)}));
    }
    const std::string confined = "structured.confined-fraction";
    if (!is_given(reading, confined) || !(m.confined_fraction > 0)) return;
    if (e.cohesion == 0)
        log.warn(worded("{1} has no effect: without structured.cohesion nothing confines fluid, and all of it is free",
                        {reading.where(confined)}));
    else if (e.least_solid_fraction == 1)
        log.warn(worded("{1} has no effect: with structured.solid-fraction = 1 there are no pores",
                        {reading.where(confined)}));
}

/// Checks values of the structured model against each other, and the release's thickness against the cells. What has no
/// meaning is added to `problems`; what is legal and dubious, or given and without effect, is warned of.
void check_structured_values(const SceneReading& reading, const StructuredMaterial& m, const ReleaseInput& release,
                             const GridSpec& grid, RunLog& log, Problems& problems) {
    if (!m.solids) return;
    const Extremes e(m);
    for (const Problem& problem :
         structured_problems(m, grid.cell_size, [&](const std::string& key) { return reading.where(key); }))
        problems.add(problem);
    warn_of_keys_without_effect(reading, m, e, log);
    if (e.bed_over_own > 1e-6)
        log.warn(worded(
            "structured.bed-friction-angle is up to {1} degrees more than the material's internal-friction-angle: it "
            "would shear within itself and leave a layer on the bed, which the model does not compute. Take at most "
            "the internal angle",
            {numeral(number_text(e.bed_over_own, 3))}));
    if (e.strain > m.critical_strain)
        log.warn(worded(
            "at its strength the material has an elastic strain of {1}, more than structured.critical-strain = {2}: it "
            "loses its cohesion before it yields. Raise structured.young-modulus (and bulk-modulus) or the critical "
            "strain, or lower the cohesion",
            {numeral(number_text(e.strain, 2)), number_text(m.critical_strain, 2)}));
    // share/doc/structured.md, "Edges and cells".
    constexpr double k_edge = 0.81;
    const double thickness = thickest(release, grid),
                 least = k_edge * std::tan(e.steepest_bed * std::numbers::pi / 180) * grid.cell_size;
    if (thickness > 0 && thickness < least)
        log.warn(worded(
            "the release is at most {1} m thick, less than 0.81 tan({2} degrees) times the cell size, {3} m: its edges "
            "stand whatever their cohesion, and it breaks too little. Choose terrain.cell-size = {4} or less",
            {numeral(number_text(thickness, 3)), numeral(number_text(e.steepest_bed, 3)),
             numeral(number_text(least, 3)), number_text(0.5 * thickness / least * grid.cell_size, 2)}));
    const double shortest = k_least_length * grid.cell_size, longest = k_greatest_default * grid.cell_size;
    if (const double wanted = k_of_thickness * thickness;
        thickness > 0 && e.cohesion > 0 && !m.damage_length && (wanted < shortest || wanted > longest))
        log.warn(worded(
            "structured.damage-length is not given: on these cells it is a fourth of the thickness, but at least {1} m "
            "and at most {2} m, so that the loss of cohesion follows the cell size. Set it to the same value for all "
            "cell sizes",
            {numeral(number_text(shortest, 3)), numeral(number_text(longest, 3))}));
}

/// A key of [structured] whose value may vary from place to place, and the raster that was read for it.
struct Property {
    std::string key;
    const std::optional<SourceSpec>* source;
    double SolidValues::*value = nullptr;  ///< null: the depth of fluid
    bool degrees = false;                  ///< an angle, stored as its tangent
    std::optional<Raster> raster = {};
};

std::vector<Property> properties(const StructuredSpec& spec, bool solids) {
    std::vector<Property> list{{"structured.initial-fluid-depth", &spec.initial_fluid_depth}};
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
        gis::visit_cells(layer.features[f].parts, grid, gis::Cover::closed,
                         [&](std::int64_t row, std::int64_t column) { raster.at(row, column) = *value; });
    }
    if (property.value != nullptr) widen(raster);
    property.raster = std::move(raster);
}

/// Returns the polygons for attribute:NAME; null, with a problem added, if there are none.
const gis::PolygonLayer* polygons(const SceneReading& reading, const TerrainInput* ground, const ReleaseInput& release,
                                  const Property& asking, std::optional<gis::PolygonLayer>& own,
                                  std::vector<UsedFile>& files, RunLog& log, Problems& problems) {
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
    log.warn_of(key, own->warnings);
    files.push_back(used_polygons(worded("Zones"), *file, *own));
    if (ground == nullptr) return nullptr;
    report_transform(key, own->transform, ground->terrain.grid.cell_size, log);
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
                                      std::vector<UsedFile>& files, RunLog& log, Problems& problems) {
    const std::string& file = (*property.source)->name;
    if (ground == nullptr || !ground->on_demand)
        return read_zone_raster(reading, ground, property.key, file, nullptr, files, log, problems);
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
        return zone_raster_on_demand(reading, *ground, property.key, file, released, within, files, log);
    // Fluid lies where the file says, not only under the release.
    return positive_values_on_demand(reading, *ground, property.key, file, within, files, log);
}

}  // namespace

std::optional<StructuredMaterial> prepare_structured(const SceneReading& reading, const TerrainInput* ground,
                                                     const ReleaseInput& release, const std::optional<Raster>& walls,
                                                     std::vector<UsedFile>& files, RunLog& log, Problems& problems) {
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
        if (asking != list.end()) layer = polygons(reading, ground, release, *asking, own, files, log, problems);
    });
    for (Property& property : list) {
        attempt(problems, [&] {
            if (has_kind(property, SourceSpec::Kind::attribute) && layer != nullptr && ground != nullptr)
                burn(reading, *layer, ground->terrain.grid, property, problems);
            if (has_kind(property, SourceSpec::Kind::raster))
                property.raster = property_raster(reading, ground, released, property, files, log, problems);
        });
    }
    if (material->solids && release.solid_fraction)
        material->zones.push_back({&SolidValues::solid_fraction, *release.solid_fraction});
    if (ground == nullptr) return material;
    for (Property& property : list) {
        if (!property.raster) continue;
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
    check_structured_values(reading, *material, release, ground->terrain.grid, log, problems);
    bound_initial_fluid(spec.initial_fluid_depth, ground->terrain, walls, *material);
    return material;
}

}  // namespace frana::app
