// SPDX-License-Identifier: Apache-2.0
#include "simulation/terms.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>

#include "params/keys/laws.h"
#include "physics/friction_coulomb.h"
#include "physics/friction_manning.h"
#include "physics/stress_bingham.h"
#include "simulation/dispatch.h"

namespace frana {
namespace {

using Terms = std::vector<std::string>;

constexpr const char* k_by_zones = " by zones";

void add_pores(const PorePressure& pores, Terms& terms) {
    if (pores.active())
        terms.emplace_back(pores.dissipates() ? "pore pressure that dissipates" : "constant pore pressure");
    if (pores.dilates()) terms.emplace_back("dilatancy");
}

void add_bed(const Scene& scene, Terms& terms) {
    const Material& m = scene.material;
    const MaterialZones& zones = scene.zones;
    for (const std::string& law : bed_friction_terms(m)) {
        if (!acts(law, m, zones)) continue;
        terms.push_back(find_law(LawKind::bed_friction, law).sentence);
        if (law == CoulombFriction::word && m.of<CoulombFriction>().surface_pressure > 0)
            terms.emplace_back("surface pressure");
    }
    for (const ZoneRaster& zone : k_zone_rasters)
        if (zones.*zone.raster && zone.of_bed_friction) terms.push_back(zone.what + std::string(k_by_zones));
    add_pores(pore_pressure_of(m), terms);
}

void add_exchange(const Entrainment& entrainment, Terms& terms) {
    if (entrainment.erodes()) terms.push_back(find_law(LawKind::erosion, entrainment.erosion).sentence);
    if (entrainment.deposition) terms.push_back(find_law(LawKind::deposition, "on").sentence);
    if (entrainment.detrainment) terms.push_back(find_law(LawKind::detrainment, "on").sentence);
}

void add_finite_volumes(Terms& terms) {
    terms.push_back(std::string("finite volumes") + ", " + "MUSCL with hydrostatic reconstruction" + ", HLL");
}

void add_numerics(const Numerics& numerics, Terms& terms) {
    if (numerics.scheme == Scheme::finite_volume) return add_finite_volumes(terms);
    const char* transfer = std::find_if(std::begin(k_transfers), std::end(k_transfers), [&](const TransferRow& row) {
                               return row.transfer == transfer_of(numerics);
                           })->term;
    if (numerics.scheme == Scheme::paper) {
        terms.push_back(std::string("bilinear shape functions") + ", " + transfer);
        return;
    }
    terms.push_back(std::string("quadratic B-splines") + ", " + transfer);
    if (well_balanced(numerics)) terms.emplace_back("reference level per node");
    terms.emplace_back("area relaxation");
    terms.emplace_back("compressive artificial viscosity");
    if (transfer_of(numerics) == Transfer::apic) terms.emplace_back("splitting and merging");
}

void add_solids(const StructuredMaterial& m, bool fluid, Terms& terms) {
    terms.emplace_back("elasticity and Drucker-Prager plasticity of solids");
    terms.push_back(find_law(LawKind::bed_friction, CoulombFriction::word).sentence);
    terms.push_back(std::string("lateral earth pressure") + ", " + "hydrostatic beyond the strength");
    if (m.cohesion > 0) terms.emplace_back("cohesion lost with strain");
    add_pores(m.pores, terms);
    if (!fluid) return;
    if (m.cohesion > 0 && m.confined_fraction > 0) terms.emplace_back("release of confined fluid");
    terms.emplace_back("buoyancy");
    terms.emplace_back("drag");
    terms.emplace_back("virtual mass");
}

Terms structured_terms(const Scene& scene) {
    const StructuredMaterial& m = *scene.structured;
    const bool fluid = !m.solids || m.solid_fraction < 1 || m.rain.falls();
    Terms terms{"hydrostatic pressure", "bed slope"};
    if (slope_correction(scene.numerics) != SlopeCorrection::none) terms.emplace_back("slope correction: normal");
    if (m.solids) add_solids(m, fluid, terms);
    if (!fluid) return terms;
    if (m.rain.falls()) terms.emplace_back("rain");
    if (m.soil) terms.emplace_back("Green-Ampt infiltration");
    if (m.manning > 0) terms.push_back(find_law(LawKind::bed_friction, ManningFriction::word).sentence);
    if (m.fluid_viscosity > 0) {
        terms.push_back(find_law(LawKind::in_plane_stress, BinghamStress::word).sentence);
        terms.emplace_back("viscous shear at the bed");
    }
    add_finite_volumes(terms);
    return terms;
}

}  // namespace

std::vector<std::string> list_terms(const Scene& scene) {
    if (scene.structured) return structured_terms(scene);
    const Material& material = scene.material;
    const Numerics& numerics = scene.numerics;
    Terms terms{"hydrostatic pressure", "bed slope"};
    if (slope_correction(numerics) == SlopeCorrection::normal) terms.emplace_back("slope correction: normal");
    if (slope_correction(numerics) == SlopeCorrection::surface) terms.emplace_back("slope correction: surface");
    if (curvature(numerics)) terms.emplace_back("curvature of the bed");
    if (flight(numerics)) terms.emplace_back("flight over edges");
    add_bed(scene, terms);
    if (const std::string stress = in_plane_stress(material); stress != "none") {
        const Law& law = find_law(LawKind::in_plane_stress, stress);
        const bool bingham = stress == BinghamStress::word;
        if (!bingham || material.of<BinghamStress>().viscosity > 0) terms.push_back(law.sentence);
        if (bingham && material.of<BinghamStress>().yield_stress > 0) terms.push_back(law.yield_sentence);
    }
    add_exchange(scene.entrainment, terms);
    add_numerics(numerics, terms);
    return terms;
}

}  // namespace frana
