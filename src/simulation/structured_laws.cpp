// SPDX-License-Identifier: Apache-2.0
#include "simulation/structured_laws.h"

#include <cmath>

namespace frana {
namespace {

using structured::VirtualMassLaw;

structured::FluidLaws fluid_laws(const StructuredMaterial& m, const Numerics& numerics) {
    structured::FluidLaws laws;
    laws.gravity = numerics.gravity;
    laws.cfl = numerics.cfl;
    laws.dry = m.dry_depth;
    laws.steep = numerics.slope_correction != SlopeCorrection::none;
    laws.wall = numerics.boundary == Boundary::wall;
    laws.gaps_are_open = numerics.nodata == NodataPolicy::stop;
    laws.manning = m.manning;
    laws.density = m.fluid_density;
    laws.viscosity = m.fluid_viscosity;
    laws.viscosity_growth = m.viscosity_growth;
    laws.velocity_shape = m.velocity_shape;
    laws.mobility = m.mobility;
    laws.solids_shape = m.solids_shape;
    return laws;
}

// Of solids with what they confine [kg/m3].
double coupled_density(const StructuredMaterial& m) {
    const double confined = can_fracture(m) ? (1 - m.solid_fraction) * m.confined_share : 0;
    return (m.solid_fraction * m.grain_density + confined * m.fluid_density) / (m.solid_fraction + confined);
}

VirtualMassLaw law_of(StructuredMaterial::VirtualMass law) {
    switch (law) {
        case StructuredMaterial::VirtualMass::none:
            return VirtualMassLaw::none;
        case StructuredMaterial::VirtualMass::pudasaini_2019:
            return VirtualMassLaw::pudasaini_2019;
        case StructuredMaterial::VirtualMass::pudasaini_2012:
            break;
    }
    return VirtualMassLaw::pudasaini_2012;
}

structured::EarthPressure law_of(StructuredMaterial::EarthPressure law) {
    switch (law) {
        case StructuredMaterial::EarthPressure::active:
            return structured::EarthPressure::active;
        case StructuredMaterial::EarthPressure::passive:
            return structured::EarthPressure::passive;
        case StructuredMaterial::EarthPressure::hydrostatic:
            break;
    }
    return structured::EarthPressure::hydrostatic;
}

}  // namespace

bool can_fracture(const StructuredMaterial& material) {
    return material.cohesion > 0;
}

bool has_fluid(const StructuredMaterial& material) {
    return !material.solids || material.solid_fraction < 1;
}

double released_density(const StructuredMaterial& m) {
    if (!m.solids) return m.fluid_density;
    return m.solid_fraction * m.grain_density + (1 - m.solid_fraction) * m.fluid_density;
}

structured::SolidMaterial solid_material(const StructuredMaterial& m) {
    return {m.solid_fraction, m.confined_share, m.cohesion, m.friction, m.bed_friction, m.grain_density,
            m.grain_diameter};
}

structured::Laws structured_laws(const StructuredMaterial& m, const Numerics& numerics, double cell_size) {
    structured::Laws laws(0.5 * cell_size);
    laws.fluid = fluid_laws(m, numerics);
    laws.gaps_are_walls = numerics.nodata != NodataPolicy::stop;
    structured::SolidLaws& solid = laws.solid;
    solid.gravity = numerics.gravity;
    solid.steep = laws.fluid.steep;
    solid.elastic = structured::Elasticity::from_young_and_bulk(m.young_modulus, m.bulk_modulus);
    solid.sin_dilatancy = m.sin_dilatancy;
    solid.earth_pressure = law_of(m.earth_pressure);
    solid.basal = {numerics.gravity, has_fluid(m) ? m.fluid_density : 0, m.pore_pressure_share};
    solid.fractures = can_fracture(m);
    solid.fragmentation.critical_strain = m.critical_strain;
    solid.fragmentation.measure =
        m.damage_by_distortion ? structured::DamageMeasure::equivalent : structured::DamageMeasure::volumetric;
    solid.wave_speed = solid.elastic.wave_speed(coupled_density(m));
    solid.spacing = cell_size / std::round(std::sqrt(static_cast<double>(numerics.particles_per_cell)));
    solid.viscosity = {m.linear_viscosity, m.quadratic_viscosity, m.sound_speed > 0 ? m.sound_speed : solid.wave_speed,
                       solid.kernel.length()};
    solid.artificial_stress = m.artificial_stress;
    structured::CouplingLaws& coupling = laws.coupling;
    coupling.drag.fluid.gravity = numerics.gravity;
    coupling.drag.fluid.density = m.fluid_density;
    coupling.drag.exponent = m.drag_exponent;
    coupling.drag.richardson_zaki = m.richardson_zaki;
    coupling.drag.smoothing_velocity = m.smoothing_velocity;
    coupling.virtual_mass.law = law_of(m.virtual_mass);
    coupling.block_size = m.block_size;
    coupling.void_ratio = (1 - m.solid_fraction) / m.solid_fraction;
    coupling.dry = m.dry_depth;
    return laws;
}

}  // namespace frana
