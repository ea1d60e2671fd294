// SPDX-License-Identifier: Apache-2.0
#include "simulation/structured_laws.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "simulation/scene.h"

namespace frana {
namespace {

structured::FluidLaws fluid_laws(const StructuredMaterial& m, const Numerics& numerics) {
    structured::FluidLaws laws;
    laws.gravity = numerics.gravity;
    laws.cfl = numerics.cfl.value_or(k_courant_of_sweeps);
    laws.dry = m.dry_depth;
    laws.steep = slope_correction(numerics) != SlopeCorrection::none;
    laws.wall = numerics.boundary == Boundary::wall;
    laws.gaps_are_open = numerics.nodata == NodataPolicy::stop;
    laws.manning = m.manning;
    laws.manning_on_total = m.manning_on_total;
    laws.density = m.fluid_density;
    laws.viscosity = m.fluid_viscosity;
    laws.rain = m.rain;
    laws.manning_in_sweeps = m.rain.falls() && m.manning > 0 && m.fluid_viscosity == 0;
    return laws;
}

structured::SolidMaterial uniform_material(const StructuredMaterial& m) {
    return {m, m.pores.initial.ratio};
}

structured::SolidMaterial material_of_cell(const StructuredMaterial& m, std::size_t cell) {
    structured::SolidMaterial solid = uniform_material(m);
    for (const SolidZone& zone : m.zones)
        if (!std::isnan(zone.raster.values[cell])) solid.*zone.value = zone.raster.values[cell];
    return solid;
}

// Density of solids with their confined fluid [kg/m3].
double coupled_density(const StructuredMaterial& m, const structured::SolidMaterial& solid) {
    return (solid.solid_fraction * solid.grain_density + solid.confined_fluid() * m.fluid_density) /
           (solid.solid_fraction + solid.confined_fluid());
}

structured::Elasticity elasticity(const StructuredMaterial& m) {
    return structured::Elasticity::from_young_and_bulk(m.young_modulus, m.bulk_modulus);
}

template <class Visit>
void for_each_zone_cell(const StructuredMaterial& m, const Visit& visit) {
    for (const SolidZone& zone : m.zones)
        zone.raster.values.for_each_stored([&](std::size_t cell, double value) {
            if (!std::isnan(value)) visit(material_of_cell(m, cell));
        });
}

// Calls visit for the uniform material and for that of every cell that a zone changes.
template <class Visit>
void for_each_material(const StructuredMaterial& m, const Visit& visit) {
    visit(uniform_material(m));
    for_each_zone_cell(m, visit);
}

// Elastic waves are fastest in the lightest material.
double least_coupled_density(const StructuredMaterial& m) {
    double least = std::numeric_limits<double>::infinity();
    for_each_material(m, [&](const structured::SolidMaterial& solid) {
        if (solid.solid_fraction > 0) least = std::min(least, coupled_density(m, solid));
    });
    return least;
}

// Whether a value that may vary from place to place passes a test anywhere.
template <class Test>
bool anywhere(const StructuredMaterial& m, double SolidValues::*value, const Test& test) {
    for (const SolidZone& zone : m.zones) {
        if (zone.value != value) continue;
        bool passes = false;
        zone.raster.values.for_each_stored([&](std::size_t, double v) { passes = passes || test(v); });  // NaN: never
        return passes;
    }
    return test(m.*value);
}

}  // namespace

void visit_materials(const StructuredMaterial& m, const std::function<void(const SolidValues&)>& visit) {
    if (m.zones.empty()) visit(uniform_material(m));
    for_each_zone_cell(m, visit);
}

bool can_fracture(const StructuredMaterial& m) {
    return anywhere(m, &SolidValues::cohesion, [](double cohesion) { return cohesion > 0; });
}

bool has_fluid(const StructuredMaterial& m) {
    return !m.solids || m.more_fluid ||
           anywhere(m, &SolidValues::solid_fraction, [](double fraction) { return fraction < 1; });
}

double whole_density(const StructuredMaterial& m, const structured::SolidMaterial& solid) {
    if (!m.solids) return m.fluid_density;
    return solid.solid_fraction * solid.grain_density + (1 - solid.solid_fraction) * m.fluid_density;
}

structured::SolidMaterial material_at(const StructuredMaterial& m, const GridSpec& grid, Point local) {
    if (m.zones.empty()) return uniform_material(m);
    const Cell cell = cell_of(grid, local);
    return material_of_cell(m, static_cast<std::size_t>(cell.row * grid.columns + cell.column));
}

double recoil_speed(const StructuredMaterial& m) {
    if (!m.solids) return 0;
    const structured::Elasticity waves = elasticity(m);
    double greatest = 0;
    for_each_material(m, [&](const structured::SolidMaterial& solid) {
        if (!(solid.cohesion > 0 && solid.solid_fraction > 0)) return;
        const double strength = 2 * solid.cohesion * (std::hypot(1, solid.friction) - solid.friction);
        const double density = coupled_density(m, solid);
        greatest = std::max(greatest, 2 * strength / (density * waves.wave_speed(density)));
    });
    return greatest;
}

structured::Laws structured_laws(const StructuredMaterial& m, const Numerics& numerics, const GridSpec& grid,
                                 double thickness) {
    const double cell = grid.cell_size;
    structured::Laws laws(cell, m.damage_length.value_or(std::clamp(k_of_thickness * thickness, k_least_length * cell,
                                                                    k_greatest_default * cell)));
    laws.fluid = fluid_laws(m, numerics);
    laws.gaps_are_walls = numerics.nodata != NodataPolicy::stop;
    structured::SolidLaws& solid = laws.solid;
    solid.gravity = numerics.gravity;
    solid.steep = laws.fluid.steep;
    solid.elastic = elasticity(m);
    solid.sin_dilatancy = m.sin_dilatancy;
    solid.basal = {numerics.gravity, has_fluid(m) ? m.fluid_density : 0, m.pore_pressure_fraction};
    solid.pores = m.pores;
    solid.fractures = can_fracture(m);
    solid.fragmentation.critical_strain = m.critical_strain;
    solid.wave_speed = solid.elastic.wave_speed(least_coupled_density(m));
    solid.spacing = grid.cell_size / std::round(std::sqrt(static_cast<double>(numerics.particles_per_cell)));
    solid.side = std::max(solid.side, 1.2 * solid.spacing);
    structured::CouplingLaws& coupling = laws.coupling;
    coupling.drag.fluid.gravity = numerics.gravity;
    coupling.drag.fluid.density = m.fluid_density;
    coupling.dry = m.dry_depth;
    return laws;
}

}  // namespace frana
