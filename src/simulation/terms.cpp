// SPDX-License-Identifier: Apache-2.0
#include "simulation/terms.h"

#include <cmath>

#include "params/keys/laws.h"
#include "simulation/dispatch.h"
#include "simulation/dispatch_bed.h"

namespace frana {
namespace {

using Words = std::vector<std::string>;

void add_bed(const Scene& scene, Words& words) {
    const Material& m = scene.material;
    const MaterialZones& zones = scene.zones;
    for (const std::string& law : m.bed_friction) {
        if (!acts(law, m, zones)) continue;
        words.push_back(find_law(LawKind::bed_friction, law).sentence);
        if (law == "bingham") words.back() += m.exact_yield_ratio ? ", exact" : ", quadratic";
        if (law == "coulomb" && m.surface_pressure > 0) words.emplace_back("surface pressure");
    }
    for (const ZoneRaster& zone : k_zone_rasters)
        if (zones.*zone.raster && zone.of_bed_friction) words.push_back(std::string(zone.what) + " by zones");
    if (m.pore_pressure_ratio > 0)
        words.emplace_back(std::isfinite(m.pore_dissipation_time) ? "pore pressure that dissipates"
                                                                  : "constant pore pressure");
}

void add_exchange(const Entrainment& entrainment, Words& words) {
    if (entrainment.erodes()) words.push_back(find_law(LawKind::erosion, entrainment.erosion).sentence);
    if (entrainment.deposition) words.push_back(find_law(LawKind::deposition, "on").sentence);
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
    words.push_back(find_law(LawKind::bed_friction, "coulomb").sentence);
    switch (m.earth_pressure) {
        case StructuredMaterial::EarthPressure::hydrostatic:
            words.emplace_back("lateral earth pressure, hydrostatic beyond the strength");
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
    if (m.cohesion > 0 && m.confined_fraction > 0) words.emplace_back("release of confined fluid");
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
    if (m.manning > 0) words.push_back(find_law(LawKind::bed_friction, "manning").sentence);
    if (m.fluid_viscosity > 0) {
        words.push_back(find_law(LawKind::in_plane_stress, "bingham").sentence);
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
        const Law& bingham = find_law(LawKind::in_plane_stress, "bingham");
        if (material.viscosity > 0) words.push_back(bingham.sentence);
        if (material.yield_stress > 0) words.push_back(bingham.yield_sentence);
    }
    if (material.plane_stress == PlaneStressLaw::earth_pressure)
        words.push_back(find_law(LawKind::in_plane_stress, "earth-pressure").sentence);
    add_exchange(scene.entrainment, words);
    add_numerics(numerics, words);
    return words;
}

}  // namespace frana
