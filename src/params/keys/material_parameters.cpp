// SPDX-License-Identifier: Apache-2.0
#include "params/keys/material_parameters.h"

#include "params/keys/declare.h"
#include "params/keys/key_words.h"
#include "params/keys/laws.h"

namespace frana {
namespace {

using declare::choice;
using declare::number;
using declare::on_off;
using declare::Range;
using declare::text;
using declare::word_list;

Parameter turbulence_parameter() {
    Parameter result = number("material.turbulence", FRANA_MEMBER(material.turbulence), "m/s2", Range{0, 1e9, true},
                              "Voellmy turbulence coefficient xi; off: friction alone.", "off");
    result.limits += ", or off";
    result.choices = {"off"};
    const auto read_number = result.read;
    result.read = [read_number](SceneSpec& scene, const std::string& value) -> std::optional<ValueProblem> {
        if (value != "off") return read_number(scene, value);
        scene.material.turbulence.reset();
        return std::nullopt;
    };
    result.write = [](const SceneSpec& scene) -> std::optional<std::string> {
        return scene.material.turbulence ? shortest_text(*scene.material.turbulence) : "off";
    };
    return result;
}

void add_friction(std::vector<Parameter>& list) {
    list.push_back(word_list("material.bed-friction", FRANA_MEMBER(material.bed_friction), {},
                             law_words("voellmy", LawKind::bed_friction),
                             "Friction laws whose sum resists at the bed; voellmy is coulomb and turbulence."));
    list.push_back(number("material.friction-angle", FRANA_MEMBER(material.friction_angle), "degrees", Range{0, 60},
                          "Bed friction angle phi; this or friction-coefficient.",
                          "required, or friction-coefficient"));
    list.push_back(number("material.friction-coefficient", FRANA_MEMBER(material.friction_coefficient), "", Range{0, 2},
                          "Bed friction coefficient mu = tan(phi); typical values are 0.05 to 0.7.",
                          "required, or friction-angle"));
    list.push_back(turbulence_parameter());
    list.push_back(number("material.surface-pressure", FRANA_MEMBER(material.surface_pressure), "Pa", Range{0, 1e6},
                          "Gauge pressure on the free surface that adds to bed friction; 0 in open air."));
    list.push_back(
        number("material.pore-pressure-ratio", FRANA_MEMBER(material.pore_pressure_ratio), "", Range{0, 1},
               "Pore pressure over total normal stress at the start, r_u; reduces friction by this fraction.", "0"));
    list.push_back(number("material.pore-dissipation-time", FRANA_MEMBER(material.pore_dissipation_time), "s",
                          Range{0, 1e9, true}, "Time in which the pore pressure decreases to 1/e.", "no dissipation"));
    list.push_back(
        number("material.cohesion", FRANA_MEMBER(material.cohesion), "Pa", Range{0, 1e6}, "Cohesion to the bed."));
    list.push_back(number("material.ramms-yield-stress", FRANA_MEMBER(material.ramms_yield_stress), "Pa",
                          Range{0, 1e5, true}, "N_0 of RAMMS's yield term."));
    list.push_back(
        number("material.manning", FRANA_MEMBER(material.manning), "s/m^(1/3)", Range{0, 1, true}, "Manning's n."));
    list.push_back(number("material.chezy", FRANA_MEMBER(material.chezy), "m^(1/2)/s", Range{0.1, 1000}, "Chezy's C."));
    list.push_back(number("material.laminar-resistance", FRANA_MEMBER(material.laminar_resistance), "",
                          Range{24, 50000}, "K of the viscous part.",
                          shortest_text(k_laminar_resistance) + ", a smooth wide bed"));
    list.push_back(number("material.consistency", FRANA_MEMBER(material.consistency), "Pa s^m", Range{0, 1e8, true},
                          "Herschel-Bulkley K."));
    list.push_back(
        number("material.flow-index", FRANA_MEMBER(material.flow_index), "", Range{0.1, 2}, "Herschel-Bulkley m."));
    list.push_back(number("material.fast-friction-angle", FRANA_MEMBER(material.fast_friction_angle), "degrees",
                          Range{0, 80}, "Friction angle of fast, thin flow."));
    list.push_back(number("material.friction-length", FRANA_MEMBER(material.friction_length), "m", Range{0, 100, true},
                          "L of the deposit's thickness."));
    list.push_back(number("material.friction-beta", FRANA_MEMBER(material.friction_beta), "", Range{0, 10, true},
                          "beta of the flow rule.", shortest_text(k_friction_beta) + ", glass beads"));
}

/// Adds to each key the laws that use it, and those that need it, as the table of laws has them.
void name_laws(std::vector<Parameter>& list, std::size_t first) {
    for (std::size_t i = first; i < list.size(); ++i) {
        Parameter& key = list[i];
        std::vector<const Law*> needing;
        for (const Law* law : readers_of(key.name()))
            if (std::find(law->needs.begin(), law->needs.end(), key.name()) != law->needs.end()) needing.push_back(law);
        key.meaning += used_by(key.name());
        if (!needing.empty() && key.absent.empty() && key.default_text().empty())
            key.absent = "required with " + selected_by(needing);
    }
}

}  // namespace

void add_material(std::vector<Parameter>& list) {
    const std::size_t first = list.size();
    list.push_back(text("material.preset", FRANA_MEMBER(material.preset), "text",
                        "A material of `frana materials` to start from; keys given in the scene override it.", "none"));
    list.push_back(choice("material.model", FRANA_MEMBER(material.model), {"voellmy-bingham", "structured"},
                          "Model: one phase with friction laws, or fluid and structured solids ([structured])."));
    list.push_back(number("material.density", FRANA_MEMBER(material.density), "kg/m3", Range{10, 10000},
                          "Bulk density of the flow."));
    add_friction(list);
    list.push_back(
        number("material.viscosity", FRANA_MEMBER(material.viscosity), "Pa s", Range{0, 1e8}, "Bingham viscosity."));
    list.push_back(
        number("material.yield-stress", FRANA_MEMBER(material.yield_stress), "Pa", Range{0, 1e7}, "Yield stress."));
    list.push_back(choice("material.in-plane-stress", FRANA_MEMBER(material.in_plane_stress),
                          law_words("auto", LawKind::in_plane_stress, {"none"}),
                          "Stress in the plane of the flow; auto: bingham if viscosity or yield stress are given and "
                          "no law of bed-friction uses them, otherwise none."));
    list.push_back(number("material.internal-friction-angle", FRANA_MEMBER(material.internal_friction_angle), "degrees",
                          Range{0, 60, true}, "Internal friction angle of earth pressure, at least that of the bed."));
    list.push_back(number("material.yield-regularisation", FRANA_MEMBER(material.yield_regularisation), "1/s",
                          Range{1e-6, 10}, "Shear rate below which the yield stress in the plane is regularised."));
    list.push_back(
        declare::option("material.yield-ratio", FRANA_MEMBER(material.exact_yield_ratio),
                        declare::Words<bool>{{"exact", true}, {"quadratic", false}},
                        "Ratio of yield stress to bed stress: root of the cubic, or the paper's quadratic."));
    name_laws(list, first);
}

void add_entrainment(std::vector<Parameter>& list) {
    const std::size_t first = list.size();
    list.push_back(choice("entrainment.erosion", FRANA_MEMBER(entrainment.erosion), law_words("off", LawKind::erosion),
                          "Law of bed erosion: excess shear stress (RAMMS), volume growth with distance (McDougall and "
                          "Hungr), or mechanical (stress jump over momentum)."));
    list.push_back(number("entrainment.erodible-depth", FRANA_MEMBER(entrainment.erodible_depth), "m", Range{0, 1000},
                          "Erodible depth, vertical."));
    list.push_back(number("entrainment.erosion-rate", FRANA_MEMBER(entrainment.erosion_rate), "m/s", Range{0, 10, true},
                          "Erosion rate.", shortest_text(k_erosion_rate)));
    list.push_back(number("entrainment.critical-shear-stress", FRANA_MEMBER(entrainment.critical_shear), "Pa",
                          Range{0, 1e6}, "Shear stress above which the bed erodes.", shortest_text(k_critical_shear)));
    list.push_back(number("entrainment.erosion-depth-per-stress", FRANA_MEMBER(entrainment.potential_depth), "m/kPa",
                          Range{0, 100, true},
                          "Maximum eroded depth per kPa of shear stress above critical-shear-stress.",
                          shortest_text(1e3 * k_potential_depth)));
    list.push_back(number("entrainment.growth-rate", FRANA_MEMBER(entrainment.growth_rate), "1/m", Range{0, 1, true},
                          "Volume growth rate per distance."));
    list.push_back(number("entrainment.bed-friction-angle", FRANA_MEMBER(entrainment.bed_friction_angle), "degrees",
                          Range{0, 60}, "Friction angle of the bed's material."));
    list.push_back(number("entrainment.bed-cohesion", FRANA_MEMBER(entrainment.bed_cohesion), "Pa", Range{0, 1e6},
                          "Cohesion of the bed's material.", "0"));
    list.push_back(number("entrainment.bed-pore-pressure-ratio", FRANA_MEMBER(entrainment.bed_pore_pressure_ratio), "",
                          Range{0, 1}, "Pore pressure over total normal stress in the bed.", "0"));
    list.push_back(number("entrainment.velocity-ratio", FRANA_MEMBER(entrainment.velocity_ratio), "",
                          Range{0, 1.5, true}, "Velocity at the base over mean velocity.",
                          shortest_text(k_velocity_ratio)));
    list.push_back(on_off("entrainment.deposition", FRANA_MEMBER(entrainment.deposition),
                          "Deposit material where the bed shear stress is below deposition-shear-stress."));
    list.push_back(number("entrainment.deposition-rate", FRANA_MEMBER(entrainment.deposition_rate), "m/s",
                          Range{0, 10, true}, "Deposition rate at zero shear stress."));
    list.push_back(number("entrainment.deposition-shear-stress", FRANA_MEMBER(entrainment.deposition_shear), "Pa",
                          Range{0, 1e6, true}, "Shear stress above which there is no deposition."));
    name_laws(list, first);
}

}  // namespace frana
