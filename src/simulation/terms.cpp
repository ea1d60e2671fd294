// SPDX-License-Identifier: Apache-2.0
#include "simulation/terms.h"

#include <cmath>

#include "simulation/dispatch.h"

namespace frana {
namespace {

using Words = std::vector<std::string>;

void add_bed_term(BedTerm term, const Material& m, const MaterialZones& zones, Words& words) {
    switch (term) {
        case BedTerm::coulomb:
            if (!(m.friction_coefficient > 0) && !zones.friction_coefficient) return;
            words.emplace_back("Coulomb bed friction");
            if (m.surface_pressure > 0) words.emplace_back("surface pressure");
            return;
        case BedTerm::turbulence:
            if (std::isfinite(m.turbulence) || zones.turbulence) words.emplace_back("turbulent bed friction");
            return;
        case BedTerm::cohesion:
            words.emplace_back("cohesion at the bed");
            return;
        case BedTerm::ramms_yield:
            words.emplace_back("RAMMS yield term");
            return;
        case BedTerm::bingham:
            words.emplace_back(m.exact_yield_ratio ? "Bingham bed resistance, exact"
                                                   : "Bingham bed resistance, quadratic");
            return;
        case BedTerm::herschel_bulkley:
            words.emplace_back("Herschel-Bulkley bed resistance");
            return;
        case BedTerm::obrien_julien:
            words.emplace_back("O'Brien-Julien bed resistance");
            return;
        case BedTerm::manning:
            words.emplace_back("Manning bed resistance");
            return;
        case BedTerm::chezy:
            words.emplace_back("Chezy bed resistance");
            return;
        case BedTerm::pouliquen_forterre:
            words.emplace_back("Pouliquen-Forterre bed friction");
            return;
    }
}

void add_bed(const Scene& scene, Words& words) {
    const Material& m = scene.material;
    const MaterialZones& zones = scene.zones;
    for (const BedTerm term : m.bed_friction) add_bed_term(term, m, zones, words);
    if (zones.friction_coefficient) words.emplace_back("friction by zones");
    if (zones.turbulence) words.emplace_back("turbulence by zones");
    if (zones.cohesion) words.emplace_back("cohesion by zones");
    if (m.pore_pressure_ratio > 0)
        words.emplace_back(std::isfinite(m.pore_dissipation_time) ? "pore pressure that dissipates"
                                                                  : "constant pore pressure");
}

void add_exchange(const Entrainment& entrainment, Words& words) {
    switch (entrainment.erosion) {
        case ErosionLaw::none:
            break;
        case ErosionLaw::shear_stress:
            words.emplace_back("erosion by excess shear stress");
            break;
        case ErosionLaw::growth:
            words.emplace_back("erosion by exponential growth");
            break;
        case ErosionLaw::mechanical:
            words.emplace_back("mechanical erosion");
            break;
    }
    if (entrainment.deposition) words.emplace_back("deposition under a critical shear stress");
}

void add_numerics(const Numerics& numerics, Words& words) {
    static constexpr const char* k_transfers[] = {"PIC", "FLIP", "APIC"};
    const char* transfer = k_transfers[static_cast<int>(transfer_of(numerics))];
    if (numerics.scheme == Scheme::paper) {
        words.push_back(std::string("bilinear shape functions, ") + transfer);
        return;
    }
    words.push_back(std::string("quadratic B-splines, ") + transfer);
    if (numerics.well_balanced) words.emplace_back("reference level per node");
    words.emplace_back("area relaxation");
    words.emplace_back("compressive artificial viscosity");
    if (transfer_of(numerics) == Transfer::apic) words.emplace_back("splitting and merging");
}

void add_solids(const StructuredMaterial& m, bool fluid, Words& words) {
    words.emplace_back("elasticity and Drucker-Prager plasticity of solids");
    words.emplace_back("Coulomb bed friction");
    switch (m.earth_pressure) {
        case StructuredMaterial::EarthPressure::hydrostatic:
            words.emplace_back("lateral earth pressure, hydrostatic in broken material");
            break;
        case StructuredMaterial::EarthPressure::active:
            words.emplace_back("lateral earth pressure, active");
            break;
        case StructuredMaterial::EarthPressure::passive:
            words.emplace_back("lateral earth pressure, active and passive");
            break;
    }
    if (m.cohesion > 0) words.emplace_back("cohesion lost with strain");
    if (!fluid) return;
    if (m.cohesion > 0 && m.confined_share > 0) words.emplace_back("release of confined fluid");
    words.emplace_back("buoyancy");
    words.emplace_back("drag");
    if (m.virtual_mass != StructuredMaterial::VirtualMass::none) words.emplace_back("virtual mass");
}

Words structured_terms(const Scene& scene) {
    const StructuredMaterial& m = *scene.structured;
    const bool fluid = !m.solids || m.solid_fraction < 1;
    Words words{"hydrostatic pressure", "bed slope"};
    if (scene.numerics.slope_correction != SlopeCorrection::none) words.emplace_back("slope correction: normal");
    if (m.solids) add_solids(m, fluid, words);
    if (!fluid) return words;
    if (m.manning > 0) words.emplace_back("Manning bed resistance");
    if (m.fluid_viscosity > 0) {
        words.emplace_back("in-plane viscosity");
        if (m.velocity_shape > 0) words.emplace_back("viscous shear at the bed");
    }
    words.emplace_back("finite volumes, MUSCL with hydrostatic reconstruction, HLL");
    return words;
}

}  // namespace

std::vector<std::string> list_terms(const Scene& scene) {
    if (scene.structured) return structured_terms(scene);
    const Material& material = scene.material;
    const Numerics& numerics = scene.numerics;
    Words words{"hydrostatic pressure", "bed slope"};
    if (numerics.slope_correction == SlopeCorrection::normal) words.emplace_back("slope correction: normal");
    if (numerics.slope_correction == SlopeCorrection::surface) words.emplace_back("slope correction: surface");
    if (numerics.curvature) words.emplace_back("curvature of the bed");
    if (flies(numerics)) words.emplace_back("flight over edges");
    add_bed(scene, words);
    if (material.plane_stress == PlaneStressLaw::bingham) {
        if (material.viscosity > 0) words.emplace_back("in-plane viscosity");
        if (material.yield_stress > 0) words.emplace_back("in-plane yield stress");
    }
    if (material.plane_stress == PlaneStressLaw::earth_pressure) words.emplace_back("earth pressure");
    add_exchange(scene.entrainment, words);
    add_numerics(numerics, words);
    return words;
}

}  // namespace frana
