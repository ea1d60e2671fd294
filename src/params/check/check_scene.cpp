// SPDX-License-Identifier: Apache-2.0
#include "params/check/check_scene.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <string>

#include "analysis/hazard.h"
#include "core/error.h"
#include "core/text.h"
#include "params/grammar/value_text.h"
#include "params/keys/laws.h"
#include "params/keys/output_parameters.h"
#include "params/keys/result_rasters.h"
#include "params/keys/scene_parameters.h"
#include "params/keys/scene_spec.h"
#include "params/keys/zone_keys.h"
#include "physics/friction_coulomb.h"

namespace frana {
namespace {

/// Whether [zones] has the same quantity as the key of another section: the default then applies outside the zones.
bool by_place(const std::set<std::string>& given, const std::string& name) {
    return given.count("zones." + name.substr(name.find('.') + 1)) > 0;
}

void check_keys(const SceneSpec& scene, const std::set<std::string>& given, const std::string& file,
                Problems& problems) {
    const std::vector<Parameter>& parameters = scene_parameters();
    const std::vector<const Law*> selected = laws_of(scene);
    for (const std::string& name : law_keys()) {
        const Parameter& key = *find_parameter(parameters, name);
        const std::string preset = key.default_text(), value = key.write(scene).value_or("");
        // A key given with its default value requests nothing.
        const bool is_given = given.count(name) > 0 && (preset.empty() || value != preset);
        if (is_given && readers_of(name, selected).empty()) {
            problems.add({"is given, but no law of the scene uses it", Place(file, name), "", "",
                          "Remove it, or set " + selected_by(readers_of(name))});
        }
        for (const Law* law : selected) {
            if (!law->needs_key(name) || is_given || by_place(given, name)) continue;
            const bool zones = find_parameter(parameters, "zones." + key.key) != nullptr;
            problems.add({preset.empty() ? "is missing" : "must be greater than " + preset, Place(file, name), value,
                          "", law->selected_by() + " needs it" + (zones ? ", here or in zones." + key.key : "")});
        }
    }
}

void check_friction(const SceneSpec& scene, const std::set<std::string>& given, const std::string& file,
                    Problems& problems) {
    const std::vector<const Law*> selected = laws_of(scene);
    const bool has_friction = given.count("material.friction-angle") + given.count("material.friction-coefficient") > 0;
    if (!has_friction && !scene.friction_table.name && !readers_of("material.friction-angle", selected).empty()) {
        problems.add({"no bed friction is given", Place(file, "material.friction-angle"), "", "",
                      "Set material.preset (see `frana materials`), material.friction-angle or "
                      "material.friction-coefficient; 0 is allowed, but must be given"});
    }
    std::map<std::string, std::vector<std::string>> alike;
    for (const Law* law : selected)
        for (const std::string& what : law->resists_alike) alike[what].push_back(law->word);
    for (const auto& [what, words] : alike) {
        if (words.size() < 2) continue;
        problems.add({"names two laws for the same effect, the " + what, Place(file, "material.bed-friction"),
                      joined(words, ", "), "one of them", "Keep one of them"});
    }
}

/// Checks that the table's values, with forest and factors, are within the limits of the keys that they replace: those
/// of the class of the volume, of every class if the volume is not known yet.
void check_table_values(const FrictionTableSpec& spec, std::size_t period, const std::string& file,
                        Problems& problems) {
    FrictionChoice choice{.table = *spec.resolved,
                          .period = period,
                          .friction_factor = spec.friction_factor,
                          .turbulence_factor = spec.turbulence_factor};
    const FrictionTable& table = choice.table;
    std::vector<double> volumes{0}, mu, xi;
    volumes.insert(volumes.end(), table.volumes.begin(), table.volumes.end());
    if (spec.volume) volumes = {*spec.volume};
    for (const double volume : volumes)
        for (std::size_t place = 0; place < table.terrain.size() * (table.altitudes.size() + 1); ++place)
            for (const bool forest : {false, spec.forest.has_value()}) {
                choice.volume = volume;
                const FrictionPair pair = choice.at(place % table.terrain.size(), place / table.terrain.size(), forest);
                mu.push_back(pair.coefficient);
                xi.push_back(pair.turbulence);
            }
    const auto check = [&](const std::string& key, const std::string& factor, const std::vector<double>& values) {
        const NumberRange& range = *find_parameter(scene_parameters(), key)->range;
        const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
        if (range.has(*least) && range.has(*greatest)) return;
        const auto rounded = [](double value) { return shortest_text(std::round(1e6 * value) / 1e6); };
        problems.add({"gives values beyond the limits of " + key, Place(file, "material.friction-table"),
                      rounded(*least) + " to " + rounded(*greatest), range.text(),
                      "Set " + factor + " nearer to 1, or correct the table"});
    };
    check("material.friction-coefficient", "material.table-friction-factor", mu);
    check("material.turbulence", "material.table-turbulence-factor", xi);
}

/// Checks the keys by which a friction table is read.
void check_friction_table(const SceneSpec& scene, const std::set<std::string>& given, const std::string& file,
                          Problems& problems) {
    const FrictionTableSpec& spec = scene.friction_table;
    const std::string table_key = "material.friction-table";
    const SceneSpec usual;
    for (const Parameter& key : scene_parameters()) {
        if (given.count(key.name()) == 0) continue;
        if (gives_by_table(key.name()) && spec.name)
            problems.add({"contradicts " + table_key + ", which gives it by place", Place(file, key.name()),
                          key.write(scene).value_or(""), "", "Keep one of the two"});
        // A key given with its default value requests nothing: every echo has those.
        if (key.write(scene) == key.write(usual)) continue;
        if (reads_friction_table(key.name()) && !spec.name)
            problems.add({"needs " + table_key, Place(file, key.name()), key.write(scene).value_or(""), "",
                          "Name the table, or remove the key"});
    }
    if (!spec.name) return;
    const std::vector<const Law*> selected = laws_of(scene);
    for (const char* const key : {"material.friction-coefficient", "material.turbulence"})
        if (readers_of(key, selected).empty())
            problems.add({std::string("gives ") + key + ", which the scene's laws do not use", Place(file, table_key),
                          *spec.name, "", "Set material.bed-friction = voellmy, or remove the table"});
    if (!spec.resolved) return;
    const FrictionTable& table = *spec.resolved;
    std::vector<std::string> periods;
    for (const double period : table.periods) periods.push_back(shortest_text(period));
    const auto period = std::find(table.periods.begin(), table.periods.end(), spec.return_period.value_or(0));
    if (period != table.periods.end())
        check_table_values(spec, static_cast<std::size_t>(period - table.periods.begin()), file, problems);
    else
        problems.add({spec.return_period ? "is not in the friction table" : "is missing",
                      Place(file, "material.return-period"),
                      spec.return_period ? shortest_text(*spec.return_period) : "", joined(periods, ", ") + " years",
                      "Choose one of them"});
    if (!spec.altitude_limits.empty() && spec.altitude_limits.size() != table.altitudes.size())
        problems.add({"does not fit the friction table", Place(file, "material.altitude-limits"),
                      std::to_string(spec.altitude_limits.size()) + " limits",
                      std::to_string(table.altitudes.size()) + ", between " +
                          std::to_string(table.altitudes.size() + 1) + " bands",
                      "Give as many, from the lowest"});
    if (spec.forest && !table.forest)
        problems.add({"has no effect: the friction table has no values for forest", Place(file, "material.forest"),
                      *spec.forest, "", "Copy the table and give the copy a section [forest], or remove the key"});
}

void check_angles(const SceneSpec& scene, const std::string& file, Problems& problems) {
    const std::optional<double> friction = friction_coefficient_of(scene.material);
    if (!friction) return;
    const double mu = *friction, bed_deg = std::atan(mu) * 180 / std::numbers::pi;
    const std::vector<Parameter>& parameters = scene_parameters();
    for (const Law* law : laws_of(scene)) {
        if (const Parameter* angle = find_parameter(parameters, law->angle_from_bed)) {
            const std::string degrees = angle->write(scene).value_or("");
            // The tolerance makes an angle equal the arctangent of its tangent.
            if (!degrees.empty() && *number_from_text(degrees) < bed_deg - 1e-9) {
                problems.add({"is less than the friction angle of the bed", Place(file, angle->name()),
                              degrees + " degrees", "at least " + shortest_text(bed_deg) + " degrees",
                              law->word + " is not defined below it"});
            }
        }
    }
    for (const Law* law : laws_of(scene)) {
        if (mu <= law->greatest_friction) continue;
        problems.add({"is too large for the law " + law->word, Place(file, "material.friction-coefficient"),
                      shortest_text(mu), "0 to " + shortest_text(law->greatest_friction),
                      "It is not defined above that"});
    }
}

void check_pores(const SceneSpec& scene, const std::string& file, Problems& problems) {
    const CoulombFriction::Values& m = scene.material.of<CoulombFriction>();
    const char* const time =
        m.pore_dissipation_time ? "material.pore-dissipation-time" : "material.hydraulic-diffusivity";
    if (m.pore_dissipation_time && m.hydraulic_diffusivity) {
        problems.add({"contradicts material.hydraulic-diffusivity: both give the time of dissipation",
                      Place(file, "material.pore-dissipation-time"), shortest_text(*m.pore_dissipation_time) + " s", "",
                      "Keep one of the two"});
    }
    const PorePressure pores = pore_pressure_of(scene.material);
    if (pores.dissipates() && !pores.active()) {
        problems.add({"is given without a pore pressure", Place(file, time), "", "",
                      "Set material.pore-pressure-ratio (one phase: or pore-fluid-density), or remove it"});
    }
    if (m.pore_fluid_density > 0 && !pores.dissipates()) {
        problems.add({"needs a time of dissipation", Place(file, "material.pore-fluid-density"),
                      shortest_text(m.pore_fluid_density) + " kg/m3", "",
                      "Set material.hydraulic-diffusivity or material.pore-dissipation-time, or remove it"});
    }
    if (!(pores.hydrostatic < 1)) {
        problems.add({"is not less than that of the flow", Place(file, "material.pore-fluid-density"),
                      shortest_text(m.pore_fluid_density) + " kg/m3",
                      "less than material.density, " + shortest_text(scene.material.density) + " kg/m3", "Lower it"});
    }
}

/// Checks that the laws of [material] and [entrainment] have the keys they need and that no given key is unread by
/// every law.
void check_laws(const SceneSpec& scene, const std::set<std::string>& given, const std::string& file,
                Problems& problems) {
    check_keys(scene, given, file, problems);
    check_friction(scene, given, file, problems);
    check_friction_table(scene, given, file, problems);
    check_angles(scene, file, problems);
}

void check_required(const SceneSpec& scene, const std::set<std::string>& given, const std::string& file,
                    Problems& problems) {
    const auto missing = [&](const std::string& name) { return given.count(name) == 0; };
    if (missing("terrain.dtm"))
        problems.add(
            {"is missing", Place(file, "terrain.dtm"), "", "", "Name the digital terrain model, a raster file"});
    const bool flows_in = !missing("inflow.line");
    const bool releases = !missing("release.thickness") || !missing("release.level") || !missing("release.perimeter");
    if (missing("release.thickness") && missing("release.level") && (releases || !flows_in)) {
        problems.add({"is missing", Place(file, "release.thickness"), "", "",
                      "Give " + thickness_forms() + ", or release.level, or an inflow"});
    }
    const auto& thickness = scene.release.thickness;
    if (missing("release.perimeter") && !(thickness && thickness->by_raster()) && (releases || !flows_in))
        problems.add(
            {"is missing", Place(file, "release.perimeter"), "", "", "Name the polygon layer of the release area"});
}

/// A key that has no effect without another one.
struct Pair {
    std::string key;
    bool given;
    std::string needs;
    bool has;
    std::string remedy;
};

void check_pairs(const SceneSpec& scene, const std::string& file, Problems& problems) {
    const TerrainSpec& terrain = scene.terrain;
    const ReleaseSpec& release = scene.release;
    const ZonesSpec& zones = scene.zones;
    const Material& material = scene.material;
    const CoulombFriction::Values& pores = material.of<CoulombFriction>();
    const auto by_attribute = [](const std::optional<SourceSpec>& source) {
        return source && source->kind == SourceSpec::Kind::attribute;
    };
    const bool outlined = release.perimeter.has_value();
    const StructuredSpec& soil = scene.structured;
    const bool conductivity = soil.soil_conductivity.has_value(), suction = soil.soil_suction.has_value(),
               deficit = soil.soil_moisture_deficit.has_value();
    const std::string outline_remedy = "Name the polygon layer, or give a number";
    std::vector<Pair> pairs{
        {"terrain.obstacles", terrain.obstacles.has_value(), "terrain.obstacle-height",
         terrain.obstacle_height.has_value(), "Give metres above the DTM or attribute:NAME"},
        {"terrain.obstacle-height", terrain.obstacle_height.has_value(), "terrain.obstacles",
         terrain.obstacles.has_value(), "Name the polygons, or remove the key"},
        {"inflow.line", scene.inflow.line.has_value(), "inflow.hydrograph", scene.inflow.hydrograph.has_value(),
         "Name the CSV with time, discharge or volume, and velocity"},
        {"inflow.hydrograph", scene.inflow.hydrograph.has_value(), "inflow.line", scene.inflow.line.has_value(),
         "Name the line of the inflow"},
        {"inflow.direction", scene.inflow.direction.has_value(), "inflow.line", scene.inflow.line.has_value(),
         "Name the line, or remove the key"},
        {"release.direction", release.direction.has_value(), "release.velocity", release.velocity.has_value(),
         "Give the speed as well, or remove the key"},
        {"material.compressibility", pores.compressibility.has_value(), "material.solid-fraction",
         pores.solid_fraction || material.model == "structured", "Give the solid fraction at the start"},
        {"material.compressibility", pores.compressibility.has_value(), "material.critical-solid-fraction",
         pores.critical_solid_fraction || material.model != "structured", "Give the solid fraction of steady shear"},
        {"material.solid-fraction", pores.solid_fraction.has_value(), "material.critical-solid-fraction",
         pores.critical_solid_fraction.has_value(), "Give the solid fraction of steady shear"},
        {"material.critical-solid-fraction", pores.critical_solid_fraction.has_value(), "material.compressibility",
         pores.compressibility.has_value(), "Give it, or remove the key"},
        {"structured.soil-conductivity", conductivity, "structured.soil-suction", suction, "Give metres"},
        {"structured.soil-conductivity", conductivity, "structured.soil-moisture-deficit", deficit,
         "Give porosity minus initial water content"},
        {"structured.soil-suction", suction, "structured.soil-conductivity", conductivity,
         "Give it, or remove the key"},
        {"structured.soil-moisture-deficit", deficit, "structured.soil-conductivity", conductivity,
         "Give it, or remove the key"},
        {"release.level", by_attribute(release.level), "release.perimeter", outlined, outline_remedy},
        {"release.volume", by_attribute(release.volume), "release.perimeter", outlined, outline_remedy},
        {"release.start", by_attribute(release.start), "release.perimeter", outlined, outline_remedy},
        {"release.velocity", by_attribute(release.velocity), "release.perimeter", outlined, outline_remedy},
        {"release.direction", by_attribute(release.direction), "release.perimeter", outlined, outline_remedy},
    };
    for (const ZoneKey& key : zone_keys())
        pairs.push_back({key.name, by_attribute(zones.*key.source), "terrain.friction-zones",
                         terrain.friction_zones.has_value(), "Name the polygons, or give raster:FILE"});
    for (const Pair& pair : pairs)
        if (pair.given && !pair.has) problems.add({"needs " + pair.needs, Place(file, pair.key), "", "", pair.remedy});
    if (zones.friction_angle && zones.friction_coefficient) {
        problems.add({"contradicts zones.friction-coefficient: both give the bed friction",
                      Place(file, "zones.friction-angle"), "", "", "Keep one of the two"});
    }
}

/// A level is a thickness of its own.
void check_level(const ReleaseSpec& release, const std::string& file, Problems& problems) {
    if (!release.level) return;
    const auto refuse = [&](bool given, const char* key, const char* why, const char* remedy) {
        if (given) problems.add({why, Place(file, key), "", "", remedy});
    };
    const char* const twice = "contradicts release.level: it decides how much is released";
    refuse(release.thickness.has_value(), "release.thickness", twice, "Keep one of the two");
    refuse(release.volume.has_value(), "release.volume", twice, "Remove it: frana check prints the volume");
    refuse(release.dtm_contains_release, "release.dtm-contains-release",
           "contradicts release.level, which lies on the DTM", "Set it to off, with the DTM of the lake's bed");
    refuse(release.thickness_direction == "normal", "release.thickness-direction",
           "contradicts release.level: a depth of water is vertical", "Remove the key");
}

/// Checks the keys that together define the thickness.
void check_thickness(const ReleaseSpec& release, const std::string& file, Problems& problems) {
    check_level(release, file, problems);
    if (!release.thickness) return;
    const ThicknessSpec& thickness = *release.thickness;
    const ThicknessKind* const kind = thickness.kind;
    if (kind != nullptr && kind->below_dtm && !release.dtm_contains_release) {
        problems.add({std::string("contradicts release.thickness = ") + kind->word + ", which lies under the DTM",
                      Place(file, "release.dtm-contains-release"), "off", "on", "Set it to on"});
    }
    if (kind != nullptr && kind->elevations && release.thickness_direction == "normal") {
        problems.add({"contradicts release.thickness: a difference of elevations is vertical",
                      Place(file, "release.thickness-direction"), "normal", "vertical", "Remove the key"});
    }
    if (thickness.fitted() && !release.slip_depth && !release.volume) {
        problems.add({"a slip surface fitted to the perimeter needs its depth", Place(file, "release.thickness"),
                      text_of(thickness), "", "Give release.volume or release.slip-depth"});
    }
    if (thickness.fitted() && release.slip_depth && release.volume) {
        problems.add({"contradicts release.volume: each of them determines the depth of the slip surface",
                      Place(file, "release.slip-depth"), "", "", "Keep one of the two"});
    }
    if (!thickness.fitted() && release.slip_depth) {
        problems.add({"applies only to a fitted slip surface", Place(file, "release.slip-depth"),
                      text_of(*release.slip_depth), "", "Remove the key, or set release.thickness = slip-surface"});
    }
}

void check_numerics(const Numerics& numerics, const std::string& file, Problems& problems) {
    if (numerics.curvature.value_or(false) && slope_correction(numerics) == SlopeCorrection::none) {
        problems.add({"needs a slope correction", Place(file, "numerics.curvature"), "on", "off",
                      "Set numerics.slope-correction = normal or surface, or remove the key"});
    }
    if (numerics.flight.value_or(false) && !can_fly(numerics)) {
        problems.add({"needs numerics.curvature = on, scheme = default and transfer = apic",
                      Place(file, "numerics.flight"), "on", "off", "Set those, or remove the key"});
    }
    const bool paper = numerics.scheme == Scheme::paper;
    if (paper && numerics.well_balanced.value_or(false)) {
        problems.add({"reference levels are part of scheme default, not of paper",
                      Place(file, "numerics.well-balanced"), "on", "off with scheme paper",
                      "Remove the key or choose numerics.scheme = default"});
    }
}

// What has no meaning without particles, or that the scheme does not have.
void check_finite_volume(const SceneSpec& scene, const std::set<std::string>& given, const std::string& file,
                         Problems& problems) {
    const Numerics& numerics = scene.numerics;
    if (numerics.scheme != Scheme::finite_volume) return;
    const auto refuse = [&](const std::string& key, const std::string& value, const char* why) {
        problems.add({why, Place(file, key), value, "", "Remove it, or set numerics.scheme = default"});
    };
    constexpr const char* k_of_particles = "is for particles, which numerics.scheme = finite-volume does not have";
    for (const char* key :
         {"numerics.transfer", "numerics.particles-per-cell", "numerics.well-balanced", "numerics.flight-clearance"})
        if (const Parameter& one = *find_parameter(scene_parameters(), key);
            given.contains(key) && one.write(scene) != one.write(SceneSpec{}))  // an echo has defaults
            refuse(key, one.write(scene).value_or(""), k_of_particles);
    if (numerics.flight.value_or(false)) refuse("numerics.flight", "on", k_of_particles);
    if (!numerics.curvature.value_or(true) && slope_correction(numerics) != SlopeCorrection::none)
        refuse("numerics.curvature", "off", "is not possible with numerics.scheme = finite-volume");
    if (writes_particles(scene.output)) refuse("output.formats", "particles-gpkg", k_of_particles);
}

void check_frames(const SceneSpec& scene, const std::string& file, Problems& problems) {
    constexpr double k_most_frames = 10000;
    const double interval = frame_interval(scene);
    if (interval > 0 && scene.time.end / interval > k_most_frames) {
        problems.add({"would make more than 10000 frames", Place(file, "time.frame-interval"),
                      shortest_text(interval) + " s",
                      "at least " + shortest_text(scene.time.end / k_most_frames) +
                          " s for time.end = " + shortest_text(scene.time.end),
                      "Choose a longer interval"});
    }
}

/// Classes of pressure need the density of what flows: that of debris makes snow seven times as strong.
void check_density(const SceneSpec& scene, const std::string& file, Problems& problems) {
    const std::string key = "material.density";
    const auto& scheme = scene.hazard.resolved;
    const bool classed = scheme && scheme->uses(HazardQuantity::pressure);
    if ((!classed && scene.output.pressure_thresholds.empty()) || !model_reads(scene, key) ||
        scene.origin_of(key) != Origin::default_value)
        return;
    problems.add({classed ? "is not given, but the classes of hazard.scheme = " + scheme->name + " are of pressure"
                          : "is not given, but output.pressure-thresholds need it",
                  Place(file, key), shortest_text(scene.material.density) + " kg/m3, the default",
                  find_parameter(scene_parameters(), key)->range->text() + " kg/m3",
                  "Set it, for example 300 for dense snow or 2000 for debris, or name a material.preset"});
}

void check_hazard(const HazardSpec& hazard, const std::string& file, Problems& problems) {
    const bool is_process = hazard.process && std::find(std::begin(k_processes), std::end(k_processes),
                                                        *hazard.process) != std::end(k_processes);
    if (is_process && (!hazard.scheme || (hazard.resolved && hazard.resolved->matrix_of(hazard.process) == nullptr))) {
        std::vector<std::string> known;
        if (hazard.resolved)
            for (const ProcessMatrix& one : hazard.resolved->matrices)
                if (!one.process.empty()) known.push_back(one.process);
        problems.add({hazard.scheme ? "is no process of " + *hazard.scheme : "needs hazard.scheme",
                      Place(file, "hazard.process"), *hazard.process, joined(known, ", "),
                      known.empty() ? "Remove the key" : "Name one of these"});
    }
    if (hazard.minimum_depth && !hazard.scheme)
        problems.add(
            {"needs hazard.scheme", Place(file, "hazard.minimum-depth"), "", "", "Name the scheme, or remove the key"});
}

void check_exposure(const SceneSpec& scene, const std::string& file, Problems& problems) {
    const auto needs = [&](const char* key, const std::optional<std::string>& value, const char* other,
                           bool has_other) {
        if (value && !has_other)
            problems.add({std::string("needs ") + other, Place(file, key), *value, "", "Give it, or remove the key"});
    };
    const ExposureSpec& exposure = scene.exposure;
    needs("exposure.fragility", exposure.fragility, "output.exposure", scene.output.exposure.has_value());
    needs("exposure.value", exposure.value, "exposure.fragility", exposure.fragility.has_value());
    needs("exposure.class", exposure.kind, "exposure.fragility", exposure.fragility.has_value());
}

void check_output(const SceneSpec& scene, const std::set<std::string>& given, const std::string& file,
                  Problems& problems) {
    const OutputSpec& output = scene.output;
    const auto refuse_formats = [&](const char* what, const char* remedy) {
        problems.add({what, Place(file, "output.formats"), joined(output.formats, ", "), "", remedy});
    };
    const bool particles = writes_particles(output);
    if (particles && !output.frames)
        refuse_formats("particles are written with the frames, but the scene writes none", "Set output.frames = on");
    if (particles && scene.material.model == "structured" && scene.structured.phases == "fluid")
        refuse_formats("fluid alone has no particles", "Remove particles-gpkg");
    if (asks_for_plane_stress(output) && scene.material.model == "structured")
        problems.add({"has a stress that the structured model does not compute", Place(file, "output.rasters"),
                      k_plane_stress, "", "Remove it; particles-gpkg has the stress of solids"});
    for (const char* format : k_zone_formats) {
        if (!has_format(output, format)) continue;
        if (!scene.hazard.scheme)
            refuse_formats("has a format of zones, and the scene has none", "Name a hazard.scheme");
        if (scene.terrain.crs == "local" && format == std::string("kmz"))
            refuse_formats("needs a place on the earth, and terrain.crs = local has none", "Remove kmz");
    }
    for (const std::string& map : output.maps) {
        const ResultRaster* const row = find_result_raster(raster_of_map(map));
        if (row != nullptr && row->is_produced_by != nullptr && !row->is_produced_by(scene))
            problems.add({"names a raster that this scene does not produce", Place(file, "output.maps"), map,
                          row->name + " is written " + row->when,
                          "Remove it, or set output.maps = on for all maps of the result"});
    }
    if (output.map_scale && !is_paper(size_from_text(output.map_size).value_or(Size{}))) {
        problems.add({"needs a paper size: pixels have no scale until they are printed",
                      Place(file, "output.map-scale"), shortest_text(*output.map_scale),
                      paper_names() + "; output.map-size is " + output.map_size,
                      "Set output.map-size = A4@300, or remove the key"});
    }
    const bool records = given.count("output.gauges") > 0 || given.count("output.cross-sections") > 0;
    if (output.sample_interval && !records) {
        problems.add({"has no effect: there are no gauges or cross-sections", Place(file, "output.sample-interval"),
                      shortest_text(*output.sample_interval), "",
                      "Set output.gauges or output.cross-sections, or remove the key"});
    }
}

}  // namespace

void check_scene(const SceneSpec& scene, const std::set<std::string>& given, const std::string& file,
                 Problems& problems) {
    check_required(scene, given, file, problems);
    check_pairs(scene, file, problems);
    check_thickness(scene.release, file, problems);
    check_model(scene, given, file, problems);
    if (scene.material.model == "voellmy-bingham") {
        check_laws(scene, given, file, problems);
        check_numerics(scene.numerics, file, problems);
        check_finite_volume(scene, given, file, problems);
    }
    check_pores(scene, file, problems);
    check_frames(scene, file, problems);
    check_hazard(scene.hazard, file, problems);
    check_exposure(scene, file, problems);
    check_density(scene, file, problems);
    check_output(scene, given, file, problems);
}

}  // namespace frana
