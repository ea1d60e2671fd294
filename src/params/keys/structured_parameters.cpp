// SPDX-License-Identifier: Apache-2.0
#include "params/keys/structured_parameters.h"

#include "params/keys/declare.h"
#include "params/keys/solid_keys.h"

namespace frana {
namespace {

using declare::choice;
using declare::holds;
using declare::number;
using declare::option;
using declare::Range;
using declare::source;
using declare::text;
using EarthPressure = StructuredValues::EarthPressure;
using Flag = declare::Words<bool>;
using VirtualMass = StructuredValues::VirtualMass;

/// A property that may vary from place to place.
template <class Member>
Parameter by_place(const std::string& name, Member member, const std::string& unit, Range range,
                   const std::string& meaning, const std::string& absent = {}) {
    using Kind = SourceSpec::Kind;
    return source(name, member, unit, range, {Kind::number, Kind::attribute, Kind::raster}, meaning, absent);
}

void add_fluid(std::vector<Parameter>& list) {
    list.push_back(number("structured.fluid-density", FRANA_MEMBER(structured.fluid_density), "kg/m3", Range{500, 2500},
                          "Density of the fluid."));
    list.push_back(number("structured.fluid-viscosity", FRANA_MEMBER(structured.fluid_viscosity), "Pa s", Range{0, 1e4},
                          "Dynamic viscosity of the fluid: shear in the plane and at the bed; 0: none."));
    list.push_back(number("structured.velocity-profile-factor", FRANA_MEMBER(structured.velocity_shape), "",
                          Range{0, 10}, "Shape of the velocity over depth, chi, in the viscous shear at the bed."));
    list.push_back(number("structured.manning", FRANA_MEMBER(structured.manning), "s/m^(1/3)", Range{0, 1},
                          "Manning's n of the ground under free fluid; 0: smooth."));
    list.push_back(option(
        "structured.manning-depth", FRANA_MEMBER(structured.manning_on_total), Flag{{"free", false}, {"total", true}},
        "Depth in Manning's law where there are solids: of the free fluid, or of solids and fluid as far as they "
        "move together."));
    list.push_back(by_place(
        "structured.initial-fluid-depth", FRANA_MEMBER(structured.initial_fluid_depth), "m", Range{0, 1000},
        "Depth of free fluid on the ground or on the solids at the start, in addition to the release.", "none"));
    list.push_back(number("structured.dry-depth", FRANA_MEMBER(structured.dry_depth), "m", Range{1e-8, 0.1},
                          "Depth below which free fluid does not move."));
}

void add_solids(std::vector<Parameter>& list) {
    for (const SolidKey& key : solid_keys())
        list.push_back(by_place(
            key.name, [member = key.source](auto& scene) -> auto& { return scene.structured.*member; }, key.unit,
            key.range, key.meaning, key.absent));
    list.push_back(holds("polygons", text("structured.zones", FRANA_MEMBER(structured.zones), "file",
                                          "Polygons, in their own CRS, for attribute:NAME in this section.",
                                          "the release's perimeter")));
    list.push_back(option("structured.placement", FRANA_MEMBER(structured.spread_evenly),
                          Flag{{"lattice", false}, {"r2", true}},
                          "Particle positions at the start: on a square lattice, or along the R2 sequence with as many "
                          "per cell as its depth requires."));
    list.push_back(number("structured.dilatancy-angle", FRANA_MEMBER(structured.dilatancy_angle), "degrees",
                          Range{0, 5},
                          "Dilatancy angle of plastic flow; with a larger one, a column pressed from its sides would "
                          "widen without end."));
    list.push_back(number("structured.young-modulus", FRANA_MEMBER(structured.young_modulus), "Pa", Range{1e3, 1e13},
                          "Young's modulus E; under 9 times the bulk modulus."));
    list.push_back(number("structured.bulk-modulus", FRANA_MEMBER(structured.bulk_modulus), "Pa", Range{1e3, 1e13},
                          "Bulk modulus K. Stiffer material takes more substeps."));
    list.push_back(number("structured.critical-strain", FRANA_MEMBER(structured.critical_strain), "", Range{1e-6, 10},
                          "Strain of yielding material at which half of the cohesion is lost."));
    list.push_back(option("structured.damage", FRANA_MEMBER(structured.damage_by_distortion),
                          Flag{{"equivalent-plastic", true}, {"volumetric", false}},
                          "Strain measure for critical-strain: distortion, or volumetric opening alone."));
    list.push_back(number("structured.initial-structured-fraction", FRANA_MEMBER(structured.initial_structured), "",
                          Range{0, 1}, "Structured fraction of the solids in intact material."));
    list.push_back(option("structured.yield-check", FRANA_MEMBER(structured.yield_on_own_stress),
                          Flag{{"total", false}, {"particle", true}},
                          "Stress in the yield check: total, with the overburden and the vertical stress of the "
                          "weight, or the particle's elastic stress alone."));
    list.push_back(option(
        "structured.broken-material", FRANA_MEMBER(structured.broken_is_elastic),
        Flag{{"earth-pressure", false}, {"elastic", true}},
        "Stress of material without cohesion: earth pressure, or elastic and frictional as in intact material."));
    list.push_back(option("structured.earth-pressure", FRANA_MEMBER(structured.earth_pressure),
                          declare::Words<EarthPressure>{{"hydrostatic", EarthPressure::hydrostatic},
                                                        {"active", EarthPressure::active},
                                                        {"active-passive", EarthPressure::passive}},
                          "Lateral thrust of the load beyond the strength: hydrostatic, Bell's active one, or also "
                          "passive in compression."));
    list.push_back(number("structured.basal-pore-pressure-fraction", FRANA_MEMBER(structured.pore_pressure_fraction),
                          "", Range{0, 1}, "Fraction B of the confined fluid's pressure that reaches the bed."));
    list.push_back(number("structured.artificial-viscosity-linear", FRANA_MEMBER(structured.linear_viscosity), "",
                          Range{0, 10}, "Linear artificial viscosity between particles."));
    list.push_back(number("structured.artificial-viscosity-quadratic", FRANA_MEMBER(structured.quadratic_viscosity), "",
                          Range{0, 10}, "Quadratic artificial viscosity between particles."));
    list.push_back(number("structured.artificial-sound-speed", FRANA_MEMBER(structured.sound_speed), "m/s",
                          Range{0, 1e5, true}, "Speed of sound in the artificial viscosity.",
                          "that of the elastic waves"));
    list.push_back(number(
        "structured.modulus-reduction", FRANA_MEMBER(structured.modulus_reduction), "", Range{1, 100},
        "Divides both moduli; elastic waves are slower by its square root, and substeps longer by the same factor. At "
        "most so that the elastic strain at the strength is a twentieth of critical-strain."));
    list.push_back(number("structured.pic-fraction", FRANA_MEMBER(structured.pic_fraction), "", Range{0, 1},
                          "PIC fraction of the grid velocity that solids take over in a step."));
    list.push_back(number("structured.artificial-stress", FRANA_MEMBER(structured.artificial_stress), "", Range{0, 1},
                          "Strength of the artificial stress against clumping in tension."));
}

void add_coupling(std::vector<Parameter>& list) {
    list.push_back(option("structured.drag-exponent", FRANA_MEMBER(structured.drag_exponent),
                          declare::Words<int>{{"1", 1}, {"2", 2}},
                          "Drag is linear (1) or quadratic (2) in the relative velocity."));
    list.push_back(number("structured.richardson-zaki", FRANA_MEMBER(structured.richardson_zaki), "", Range{1, 5},
                          "Richardson and Zaki's exponent M of hindered settling."));
    list.push_back(option("structured.richardson-zaki-law", FRANA_MEMBER(structured.exponent_by_grains),
                          Flag{{"constant", false}, {"by-grains", true}},
                          "Exponent M: constant, or from the grains' Reynolds number."));
    list.push_back(number("structured.smoothing-velocity", FRANA_MEMBER(structured.smoothing_velocity), "m/s",
                          Range{0, 1000}, "K of the drag's smoothing term; 0: the mixture's flux."));
    list.push_back(option("structured.drag-mixing", FRANA_MEMBER(structured.mixing_by_solids),
                          Flag{{"quotient", false}, {"solids-fraction", true}},
                          "Fluid-like fraction P of the drag: from the loose fractions of solids and fluid, or from "
                          "the solid fraction."));
    list.push_back(number("structured.drag-mixing-exponent", FRANA_MEMBER(structured.drag_mixing_exponent), "",
                          Range{0, 10}, "Exponent of the fluid-like fraction."));
    list.push_back(number("structured.block-size", FRANA_MEMBER(structured.block_size), "m", Range{0, 1000, true},
                          "Size of structured blocks, for the drag.", "the local depth"));
    list.push_back(option("structured.virtual-mass", FRANA_MEMBER(structured.virtual_mass),
                          declare::Words<VirtualMass>{{"pudasaini-2012", VirtualMass::pudasaini_2012},
                                                      {"pudasaini-2019", VirtualMass::pudasaini_2019},
                                                      {"none", VirtualMass::none}},
                          "Law of the virtual mass of fluid that accelerates with the solids."));
    list.push_back(number("structured.viscosity-growth", FRANA_MEMBER(structured.viscosity_growth), "", Range{0, 50},
                          "Growth of the viscosity with the solid fraction, b in a exp(b alpha)."));
    list.push_back(number("structured.mobility", FRANA_MEMBER(structured.mobility), "", Range{0, 100},
                          "Mobility of the interface in the enhanced stress; 0: no such stress."));
    list.push_back(number("structured.solids-profile-factor", FRANA_MEMBER(structured.solids_shape), "", Range{0, 10},
                          "Shape of the solid fraction over depth, zeta."));
}

}  // namespace

void add_structured(std::vector<Parameter>& list) {
    Parameter phases = choice("structured.phases", FRANA_MEMBER(structured.phases), {"fluid", "solids-and-fluid"},
                              "Content of the release: fluid alone, or blocks of solids with confined fluid.");
    phases.absent = "required with material.model = structured";
    list.push_back(phases);
    add_fluid(list);
    add_solids(list);
    add_coupling(list);
}

}  // namespace frana
