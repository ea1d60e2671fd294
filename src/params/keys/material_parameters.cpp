// SPDX-License-Identifier: Apache-2.0
#include "params/keys/material_parameters.h"

#include <algorithm>

#include "params/keys/declare.h"
#include "params/keys/laws.h"
#include "params/keys/used_keys.h"
#include "physics/laws.h"

namespace frana {

const std::vector<SolidKey>& solid_keys() {
    using declare::Range;
    using Spec = StructuredSpec;
    using Values = SolidValues;
    static const std::vector<SolidKey> keys{
        {"structured.solid-fraction", &Spec::solid_fraction, &Values::solid_fraction, "", Range{0, 1, true},
         "Volume fraction of solids in the release; the rest is fluid.", ""},
        {"structured.confined-fraction", &Spec::confined_fraction, &Values::confined_fraction, "", Range{0, 1},
         "Fraction of that fluid that is confined by the structure; the rest is free from the start.", ""},
        {"structured.grain-density", &Spec::grain_density, &Values::grain_density, "kg/m3", Range{1000, 5000},
         "Density of the grains.", ""},
        {"structured.grain-diameter", &Spec::grain_diameter, &Values::grain_diameter, "m", Range{1e-6, 1},
         "Diameter of the grains, for the drag.", ""},
        {"structured.cohesion", &Spec::cohesion, &Values::cohesion, "Pa", Range{0, 1e12},
         "Cohesion of the intact material; 0: loose from the start.", "required with solids"},
        {"structured.internal-friction-angle", &Spec::internal_friction_angle, &Values::friction, "degrees",
         Range{0, 60, true}, "Internal friction angle.", "required with solids"},
        {"structured.bed-friction-angle", &Spec::bed_friction_angle, &Values::bed_friction, "degrees", Range{0, 60},
         "Friction angle at the bed.", "the internal friction angle", "structured.internal-friction-angle"}};
    return keys;
}

const SolidKey& SolidKey::in_use(const StructuredSpec& spec) const {
    if (instead.empty() || spec.*source) return *this;
    return *std::find_if(solid_keys().begin(), solid_keys().end(),
                         [this](const SolidKey& other) { return other.name == instead; });
}

namespace {

using declare::choice;
using declare::holds;
using declare::number;
using declare::option;
using declare::Range;
using declare::source;
using declare::text;
using Flag = declare::Words<bool>;

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
    list.push_back(number("structured.manning", FRANA_MEMBER(structured.manning), "s/m^(1/3)", Range{0, 1},
                          "Manning's n of the ground under free fluid; 0: smooth."));
    list.push_back(option(
        "structured.manning-depth", FRANA_MEMBER(structured.manning_on_total), Flag{{"free", false}, {"total", true}},
        "Depth in Manning's law where there are solids: of the free fluid, or of solids and fluid as far as they "
        "move together."));
    list.push_back(by_place(
        "structured.initial-fluid-depth", FRANA_MEMBER(structured.initial_fluid_depth), "m", Range{0, 1000},
        "Depth of free fluid on the ground or on the solids at the start, in addition to the release.", "none"));
    list.push_back(source("structured.rain", FRANA_MEMBER(structured.rain), "mm/h", Range{0, 2500},
                          {SourceSpec::Kind::number, SourceSpec::Kind::table},
                          "Rain: its intensity, or a CSV with the columns time and rain, depth or raster.", "none"));
    list.push_back(by_place(
        "structured.soil-conductivity", FRANA_MEMBER(structured.soil_conductivity), "mm/h", Range{0, 1e5},
        "Saturated conductivity of the soil, into which free fluid infiltrates (Green-Ampt).", "tight ground"));
    list.push_back(by_place("structured.soil-suction", FRANA_MEMBER(structured.soil_suction), "m", Range{0, 2},
                            "Suction at the wetting front.", "required with structured.soil-conductivity"));
    list.push_back(by_place("structured.soil-moisture-deficit", FRANA_MEMBER(structured.soil_moisture_deficit), "",
                            Range{0, 0.9}, "Porosity minus initial water content.",
                            "required with structured.soil-conductivity"));
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
    list.push_back(number("structured.damage-length", FRANA_MEMBER(structured.damage_length), "m", Range{0, 1000, true},
                          "Length over which damage is averaged, the standard deviation of a Gaussian: a band breaks "
                          "as wide on any cells. From half a cell to two cells.",
                          "a fourth of the greatest thickness at the start, within half a cell and two thirds"));
    list.push_back(number("structured.basal-pore-pressure-fraction", FRANA_MEMBER(structured.pore_pressure_fraction),
                          "", Range{0, 1}, "Fraction B of the confined fluid's pressure that reaches the bed."));
}

}  // namespace

void add_structured(std::vector<Parameter>& list) {
    Parameter phases = choice("structured.phases", FRANA_MEMBER(structured.phases), {"fluid", "solids-and-fluid"},
                              "Content of the release: fluid alone, or blocks of solids with confined fluid.");
    phases.absent = "required with material.model = structured";
    list.push_back(phases);
    const std::size_t first = list.size();
    add_fluid(list);
    add_solids(list);
    for (std::size_t i = first; i < list.size(); ++i) list[i].decides_map = true;
}

namespace {

using declare::on_off;
using declare::word_list;

/// Adds "off" to a number: not given.
template <class Member>
Parameter or_off(Parameter key, Member member) {
    key.limits += ", or off";
    key.choices = {"off"};
    key.read = [member, read_number = key.read](SceneSpec& scene,
                                                const std::string& value) -> std::optional<ValueProblem> {
        if (value != "off") return read_number(scene, value);
        member(scene) = {};
        return std::nullopt;
    };
    key.write = [write_number = key.write](const SceneSpec& scene) -> std::optional<std::string> {
        return write_number(scene).value_or("off");
    };
    return key;
}

/// Adds the keys that the laws of a list bring with them.
template <class List, class Section>
void add_keys_of(std::vector<Parameter>& list, Section section) {
    List::for_each([&]<class L>() {
        for_each_key<L>([&](const auto& key) {
            const auto member = [ section, at = key.member ](auto& scene) -> auto& {
                return section(scene).template of<L>().*at;
            };
            if constexpr (requires { key.words; }) {
                list.push_back(declare::option(key.name, member, key.words, key.meaning));
            } else {
                Parameter plain = number(key.name, member, key.unit, key.range, key.meaning, key.absent);
                plain.called = key.called;
                list.push_back(key.may_be_off ? or_off(plain, member) : plain);
            }
            list.back().decides_map = !list.back().default_text().empty();
        });
    });
}

/// Adds to each key the laws that use it, and those that need it, as the table of laws has them.
void name_laws(std::vector<Parameter>& list, std::size_t first) {
    for (std::size_t i = first; i < list.size(); ++i) {
        Parameter& key = list[i];
        std::vector<const Law*> needing;
        for (const Law* law : readers_of(key.name()))
            if (law->needs_key(key.name())) needing.push_back(law);
        key.meaning += used_by(key.name());
        if (!needing.empty() && key.absent.empty() && key.default_text().empty())
            key.absent = "required with " + selected_by(needing);
    }
}

/// Bed friction by place after a published table.
void add_friction_table(std::vector<Parameter>& list) {
    list.push_back(declare::data_file(
        "material.friction-table", FRANA_MEMBER(friction_table.name), "a file of share/friction, or FILE.ini",
        "Published table from which every cell gets mu and xi, by return period, volume, terrain and altitude.",
        "none"));
    list.push_back(number("material.return-period", FRANA_MEMBER(friction_table.return_period), "years",
                          Range{0, 1e5, true}, "Return period by which the friction table is read.",
                          "required with material.friction-table"));
    list.push_back(number("material.table-volume", FRANA_MEMBER(friction_table.volume), "m3", Range{0, 1e12, true},
                          "Volume by which the friction table is read.", "that of release and inflow"));
    list.push_back(declare::rising_numbers("material.altitude-limits", FRANA_MEMBER(friction_table.altitude_limits),
                                           "m", "Elevations that separate the friction table's bands of altitude."));
    list.back().absent = "the table's";
    list.push_back(holds("polygons", text("material.forest", FRANA_MEMBER(friction_table.forest), "file",
                                          "Polygons of forest, in their own CRS, where the friction table's values "
                                          "for forest apply.",
                                          "none")));
    const Range factors{0.1, 10};
    list.push_back(number("material.table-friction-factor", FRANA_MEMBER(friction_table.friction_factor), "", factors,
                          "Factor of the friction table's values, for studies."));
    list.push_back(number("material.table-turbulence-factor", FRANA_MEMBER(friction_table.turbulence_factor), "",
                          factors, "Factor of the friction table's values, for studies."));
}

}  // namespace

void add_material(std::vector<Parameter>& list) {
    const std::size_t first = list.size();
    list.push_back(text("material.preset", FRANA_MEMBER(material.preset), "text",
                        "A material of `frana materials` to start from; keys given in the scene override it.", "none"));
    list.push_back(declare::decides_map(
        choice("material.model", FRANA_MEMBER(material.model), {"voellmy-bingham", "structured"},
               "Model: one phase with friction laws, or fluid and structured solids ([structured]).")));
    list.push_back(declare::decides_map(number("material.density", FRANA_MEMBER(material.density), "kg/m3",
                                               Range{10, 10000}, "Bulk density of the flow.")));
    list.push_back(declare::decides_map(word_list(
        "material.bed-friction", FRANA_MEMBER(material.bed_friction), {}, law_words("voellmy", LawKind::bed_friction),
        "Friction laws whose sum resists at the bed; voellmy is coulomb and turbulence.")));
    add_keys_of<BedLaws>(list, FRANA_MEMBER(material));
    list.push_back(choice("material.in-plane-stress", FRANA_MEMBER(material.in_plane_stress),
                          law_words("auto", LawKind::in_plane_stress, {"none"}),
                          "Stress in the plane of the flow; auto: bingham if viscosity or yield stress are given and "
                          "no law of bed-friction uses them, otherwise none."));
    add_keys_of<StressLaws>(list, FRANA_MEMBER(material));
    name_laws(list, first);
    add_friction_table(list);
}

void add_entrainment(std::vector<Parameter>& list) {
    const std::size_t first = list.size();
    list.push_back(declare::decides_map(
        choice("entrainment.erosion", FRANA_MEMBER(entrainment.erosion), law_words("off", LawKind::erosion),
               "Law of bed erosion: excess shear stress (RAMMS), volume growth with distance (McDougall and "
               "Hungr), or mechanical (stress jump over momentum).")));
    list.push_back(number("entrainment.erodible-depth", FRANA_MEMBER(entrainment.erodible_depth), "m", Range{0, 1000},
                          "Erodible depth, vertical."));
    add_keys_of<ErosionLaws>(list, FRANA_MEMBER(entrainment));
    list.push_back(on_off("entrainment.deposition", FRANA_MEMBER(entrainment.deposition),
                          "Deposit material where the bed shear stress is below deposition-shear-stress."));
    add_keys_of<DepositionLaws>(list, FRANA_MEMBER(entrainment));
    list.push_back(on_off("entrainment.detrainment", FRANA_MEMBER(entrainment.detrainment),
                          "Forest holds back flowing snow (Feistl et al. 2014)."));
    add_keys_of<DetrainmentLaws>(list, FRANA_MEMBER(entrainment));
    name_laws(list, first);
}

}  // namespace frana
