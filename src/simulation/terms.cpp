// SPDX-License-Identifier: Apache-2.0
#include "simulation/terms.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>

#include "params/keys/laws.h"
#include "physics/laws.h"
#include "simulation/dispatch.h"

namespace frana {
namespace {

using Terms = std::vector<std::string>;

constexpr const char* k_by_zones = " by zones";

void add_pores(const PorePressure& pores, Terms& terms) {
    if (pores.active())
        terms.emplace_back(pores.dissipates() ? worded("pore pressure that dissipates")
                                              : worded("constant pore pressure"));
    if (pores.dilates()) terms.emplace_back(worded("dilatancy"));
}

void add_bed(const Scene& scene, Terms& terms) {
    const Material& m = scene.material;
    const MaterialZones& zones = scene.zones;
    for (const std::string& law : bed_friction_terms(m)) {
        if (!acts(law, m, zones)) continue;
        terms.push_back(find_law(LawKind::bed_friction, law).sentence);
        if (law == CoulombFriction::word && m.of<CoulombFriction>().surface_pressure > 0)
            terms.emplace_back(worded("surface pressure"));
    }
    for (const ZoneRaster& zone : k_zone_rasters)
        if (zones.*zone.raster && zone.of_bed_friction) terms.push_back(zone.what + std::string(k_by_zones));
    add_pores(m.of<CoulombFriction>().pore_pressure(m.density), terms);
}

void add_exchange(const Entrainment& entrainment, Terms& terms) {
    if (entrainment.erodes()) terms.push_back(find_law(LawKind::erosion, entrainment.erosion).sentence);
    if (entrainment.deposition) terms.push_back(find_law(LawKind::deposition, ShearStressDeposition::word).sentence);
}

void add_finite_volumes(Terms& terms) {
    terms.push_back(std::string(worded("finite volumes")) + ", " + worded("MUSCL with hydrostatic reconstruction") +
                    ", HLL");
}

void add_numerics(const Numerics& numerics, Terms& terms) {
    if (numerics.scheme == Scheme::finite_volume) return add_finite_volumes(terms);
    const char* transfer = std::find_if(std::begin(k_transfers), std::end(k_transfers), [&](const TransferRow& row) {
                               return row.transfer == transfer_of(numerics);
                           })->term;
    if (numerics.scheme == Scheme::paper) {
        terms.push_back(std::string(worded("bilinear shape functions")) + ", " + transfer);
        return;
    }
    terms.push_back(std::string(worded("quadratic B-splines")) + ", " + transfer);
    if (well_balanced(numerics)) terms.emplace_back(worded("reference level per node"));
    terms.emplace_back(worded("area relaxation"));
    terms.emplace_back(worded("compressive artificial viscosity"));
    if (transfer_of(numerics) == Transfer::apic) terms.emplace_back(worded("splitting and merging"));
}

void add_solids(const StructuredMaterial& m, bool fluid, Terms& terms) {
    terms.emplace_back(worded("elasticity and Drucker-Prager plasticity of solids"));
    terms.push_back(find_law(LawKind::bed_friction, CoulombFriction::word).sentence);
    terms.push_back(std::string(worded("lateral earth pressure")) + ", " + worded("hydrostatic beyond the strength"));
    if (m.cohesion > 0) terms.emplace_back(worded("cohesion lost with strain"));
    add_pores(m.pores.pore_pressure(m.fluid_density), terms);
    if (!fluid) return;
    if (m.cohesion > 0 && m.confined_fraction > 0) terms.emplace_back(worded("release of confined fluid"));
    terms.emplace_back(worded("buoyancy"));
    terms.emplace_back(worded("drag"));
    terms.emplace_back(worded("virtual mass"));
}

Terms structured_terms(const Scene& scene) {
    const StructuredMaterial& m = *scene.structured;
    const bool fluid = !m.solids || m.solid_fraction < 1;
    Terms terms{worded("hydrostatic pressure"), worded("bed slope")};
    if (slope_correction(scene.numerics) != SlopeCorrection::none)
        terms.emplace_back(worded("slope correction: normal"));
    if (m.solids) add_solids(m, fluid, terms);
    if (!fluid) return terms;
    if (m.manning > 0) terms.push_back(find_law(LawKind::bed_friction, ManningFriction::word).sentence);
    if (m.fluid_viscosity > 0) {
        terms.push_back(find_law(LawKind::in_plane_stress, BinghamStress::word).sentence);
        terms.emplace_back(worded("viscous shear at the bed"));
    }
    add_finite_volumes(terms);
    return terms;
}

/// A term is parts between commas, some of which several terms have: "quadratic B-splines, APIC".
std::string part_in(const std::string& part, const Words& words) {
    if (!part.ends_with(k_by_zones)) return words(part);
    const std::string what = part.substr(0, part.size() - std::string_view(k_by_zones).size());
    return words("{1} by zones", {what == "friction" ? words("friction coefficient") : words(what)});
}

}  // namespace

std::string term_in(const std::string& term, const Words& words) {
    const std::string comma = ", ";
    const std::size_t end = term.find(comma);
    if (end == std::string::npos) return part_in(term, words);
    return part_in(term.substr(0, end), words) + comma + term_in(term.substr(end + comma.size()), words);
}

std::vector<std::string> list_terms(const Scene& scene) {
    if (scene.structured) return structured_terms(scene);
    const Material& material = scene.material;
    const Numerics& numerics = scene.numerics;
    Terms terms{worded("hydrostatic pressure"), worded("bed slope")};
    if (slope_correction(numerics) == SlopeCorrection::normal) terms.emplace_back(worded("slope correction: normal"));
    if (slope_correction(numerics) == SlopeCorrection::surface) terms.emplace_back(worded("slope correction: surface"));
    if (curvature(numerics)) terms.emplace_back(worded("curvature of the bed"));
    if (flight(numerics)) terms.emplace_back(worded("flight over edges"));
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
