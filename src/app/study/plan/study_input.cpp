// SPDX-License-Identifier: Apache-2.0
#include "app/study/plan/study_input.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>
#include <utility>

#include "app/input/doubt_ground.h"
#include "app/input/layer_values.h"
#include "app/input/share_directory.h"
#include "app/process/terminal.h"
#include "app/publish/publish_hazard.h"
#include "app/store/recorded_inputs.h"
#include "app/store/scene_identity.h"
#include "app/study/plan/calibration_input.h"
#include "app/study/plan/read_study.h"
#include "app/study/plan/region_input.h"
#include "app/text/number_text.h"
#include "core/text.h"
#include "gis/access/table_in.h"
#include "params/grammar/value_text.h"
#include "params/keys/output_parameters.h"
#include "params/keys/scene_parameters.h"
#include "simulation/simulation.h"

namespace frana::app::study {
namespace {

std::optional<std::string> text_in(const PolygonFeature& feature, const std::string& column) {
    if (const auto text = feature.texts.find(column); text != feature.texts.end()) {
        const std::string value = trimmed(text->second);
        if (value.empty()) return std::nullopt;
        return value;
    }
    if (const auto number = feature.numbers.find(column); number != feature.numbers.end())
        return shortest_text(number->second);
    return std::nullopt;
}

/// A column that no polygon has is mistyped.
void require_columns(const RegionSpec& region, const gis::PolygonLayer& layer, const std::string& label,
                     Problems& problems) {
    std::set<std::string> known;
    for (const PolygonFeature& feature : layer.features) {
        for (const auto& [name, value] : feature.numbers) known.insert(name);
        for (const auto& [name, value] : feature.texts) known.insert(name);
    }
    const std::vector<std::string> names(known.begin(), known.end());
    const auto require = [&](const std::string& key, const std::string& column) {
        if (known.count(column) > 0) return;
        const std::string nearest = nearest_name(column, names);
        problems.add({"is no column in which a polygon of the release perimeter has a value", Place(label, key), column,
                      "",
                      !nearest.empty() ? "Did you mean " + nearest + "?"
                      : names.empty()  ? "The layer has no attributes"
                                       : "Its columns are " + joined(names, ", ")});
    };
    for (const auto& [key, column] :
         {std::pair{"region.name", region.name}, std::pair{"region.group", region.group},
          std::pair{"region.scenario", region.scenario}, std::pair{"region.return-period", region.return_period}})
        if (column) require(key, *column);
    for (const RegionSpec::Column& one : region.columns) require("columns." + one.key, one.column);
}

Slope slope_of(const RegionSpec& region, const PolygonFeature& feature) {
    Slope slope;
    const auto word = [&](const std::optional<std::string>& column) {
        return column ? text_in(feature, *column).value_or("") : "";
    };
    slope.name = word(region.name);
    slope.group = word(region.group);
    slope.scenario = word(region.scenario);
    if (region.scenario && slope.scenario.empty()) slope.problem = "column " + *region.scenario + " has no value";
    if (!region.return_period) return slope;
    const std::string years = word(region.return_period);
    slope.return_period = number_from_text(years);
    if (years.empty())
        slope.problem = "column " + *region.return_period + " has no value";
    else if (!slope.return_period || !(*slope.return_period > 0))
        slope.problem = "column " + *region.return_period + " has no return period: " + years;
    return slope;
}

void require_one_period(const std::vector<Slope>& slopes, const std::string& label, Problems& problems) {
    std::map<std::string, std::set<double>> periods;
    for (const Slope& slope : slopes)
        if (slope.return_period && !slope.scenario.empty()) periods[slope.scenario].insert(*slope.return_period);
    for (const auto& [scenario, all] : periods) {
        if (all.size() < 2) continue;
        problems.add({"gives scenario " + scenario + " several return periods", Place(label, "region.return-period"),
                      shortest_text(*all.begin()) + " and " + shortest_text(*all.rbegin()) + " years",
                      "one for each scenario", "Correct the column, or give the events different scenarios"});
    }
}

constexpr const char* k_friction_period = "material.return-period";

/// The return period of an event is also that of its friction: without one of its own a friction table takes it.
void take_friction_period(RegionSpec& region, const FrictionTableSpec& table) {
    const bool has_own =
        table.return_period || std::any_of(region.columns.begin(), region.columns.end(),
                                           [](const RegionSpec::Column& one) { return one.key == k_friction_period; });
    if (region.return_period && table.name && !has_own)
        region.columns.push_back({k_friction_period, *region.return_period});
}

/// Refuses releases of one return period on the friction of another.
void require_friction_period(const FrictionTableSpec& table, StudyInput& members) {
    const auto& keys = members.table.keys;
    const auto place = std::find(keys.begin(), keys.end(), k_friction_period) - keys.begin();
    for (std::size_t i = 0; i < members.slopes.size(); ++i) {
        const auto& values = members.table.values[i];
        const bool is_column = place < static_cast<std::ptrdiff_t>(values.size());
        const auto friction =
            is_column ? number_from_text(values[static_cast<std::size_t>(place)]) : table.return_period;
        const auto& event = members.slopes[i].return_period;
        if (!event || !friction || *event == *friction) continue;
        members.reading.problems.add(
            {"differs from " + std::string(k_friction_period) + ", of member " + std::to_string(i) + " first",
             members.reading.where("region.return-period"), shortest_text(*event) + " years",
             shortest_text(*friction) + " years",
             "Leave out " + std::string(k_friction_period) + ": the event's own is taken"});
        return;
    }
}

/// Adds the columns of a region to the values of its members.
void add_columns(const gis::PolygonLayer& layer, StudyInput& members) {
    const StudySpec& study = members.reading.study;
    const RegionSpec& region = *study.region;
    const std::vector<Parameter>& parameters = scene_parameters();
    const std::string folder = std::filesystem::path(study.file).parent_path().string();
    for (const RegionSpec::Column& one : region.columns) {
        members.table.keys.push_back(one.key);
        members.table.nominal.push_back(true);
    }
    for (std::size_t i = 0; i < layer.features.size(); ++i) {
        Slope slope = slope_of(region, layer.features[i]);
        slope.area = area(layer.features[i].parts);
        if (!layer.unusable[i].empty()) slope.problem = layer.unusable[i];
        for (const RegionSpec::Column& one : region.columns) {
            const auto text = text_in(layer.features[i], one.column);
            if (!text) slope.problem = "column " + one.column + " for " + one.key + " has no value";
            members.table.values[i].push_back(
                text ? with_absolute_paths(*find_parameter(parameters, one.key), *text, folder) : "");
            members.table.numbers[i].push_back(text ? number_from_text(*text).value_or(0) : 0);
        }
        members.slopes.push_back(std::move(slope));
    }
}

/// Adds a member for each polygon of a scene's release perimeter, in the order of the file: release.perimeter-filter
/// selects it. Adds a problem if the scene names none, or it cannot be read, or no polygon has a column that the region
/// names, or one scenario has several return periods. What is wrong with a single slope is only kept with it.
void add_polygons(const SceneReading& scene, StudyInput& members) {
    Problems& problems = members.reading.problems;
    const std::string& label = members.reading.label;
    const ReleaseSpec& release = scene.scene.release;
    const Place where = scene.where("release.perimeter");
    if (!release.perimeter)
        return problems.add({"is missing, and a region takes its polygons", where, "", "a vector file",
                             "Name the file of the release perimeters"});
    const std::string own = release.perimeter_layer.filter.value_or("");
    attempt(problems, [&] {
        gis::LayerChoice choice = layer_choice(scene, release.perimeter_layer, "release.perimeter");
        choice.keep_unusable = true;
        const gis::PolygonLayer layer = gis::read_polygons(*release.perimeter, "", where, choice);
        members.table.keys = {"release.perimeter-filter"};
        members.table.nominal = {true};
        for (std::size_t i = 0; i < layer.conditions.size(); ++i) {
            const std::string& condition = layer.conditions[i];
            members.table.values.push_back({own.empty() ? condition : "(" + own + ") AND " + condition});
            members.table.numbers.push_back({static_cast<double>(i)});
            members.table.weights.push_back(1);
        }
        require_columns(*members.reading.study.region, layer, label, problems);
        add_columns(layer, members);
        require_one_period(members.slopes, label, problems);
        require_friction_period(scene.scene.friction_table, members);
    });
}

SceneReading read_member(const StudyReading& reading, const std::vector<std::string>& overrides) {
    std::vector<std::string> all = reading.study.set;
    if (reading.study.scheme) all.push_back("numerics.scheme=" + word_of(*reading.study.scheme, k_schemes));
    SceneReading scene =
        read_scene(reading.study.scene, overridden(std::move(all), overrides), share_directory(), reading.label + ": ");
    scene.session = reading.session;
    resolve_language(scene.scene);
    return scene;
}

/// Problems that only some members have: each once, with the first member that has it.
void add_members_problems(const StudyReading& reading, const SampleTable& table, bool quiet, SceneReading& central) {
    StatusLine status(quiet);
    std::set<std::string> known;
    for (const Problem& problem : central.problems.list()) known.insert(problem.where + problem.what);
    for (std::size_t member = 0; member < table.size(); ++member) {
        if (status.is_due())
            status.show("checked " + std::to_string(member) + " of " + std::to_string(table.size()) + " members");
        const SceneReading scene = read_member(reading, table.overrides(member));
        for (Problem problem : scene.problems.list()) {
            if (!known.insert(problem.where + problem.what).second) continue;
            problem.what = "in member " + std::to_string(member) + ": " + problem.what;
            central.problems.add(problem);
        }
    }
    status.finish();
}

void refuse_accuracy(SceneReading& central) {
    if (central.scene.numerics.accuracy)
        central.problems.add({"has no effect in a study: members are computed on the scene's own cells",
                              central.where("numerics.accuracy"), "", "",
                              "Remove the key, and choose terrain.cell-size"});
}

SampleTable read_samples(StudyReading& reading) {
    if (reading.study.sampling == Sampling::table) {
        const Place where = reading.where("study.sampling");
        const auto read = [&] {
            const gis::Table file = gis::read_table(reading.study.table, where);
            reading.doubts = file.remarks;
            return samples_of_table(file.columns, file.rows, where + ": " + reading.study.table, reading.problems);
        };
        return attempt(reading.problems, read);
    }
    if (!reading.problems.empty()) return {};  // values of a broken study would be reported for nothing
    return draw_samples(reading.study, reading.label, reading.problems);
}

/// Members that together have every value of the keys without order; fields of error need no trial.
std::vector<std::size_t> members_with_every_value(const SampleTable& table) {
    std::vector<std::size_t> members;
    for (std::size_t k = 0; k < table.keys.size(); ++k) {
        if (!table.nominal[k] || table.keys[k] == "terrain.error") continue;
        std::set<std::string> seen;
        for (std::size_t member = 0; member < table.size(); ++member)
            if (seen.insert(table.values[member][k]).second) members.push_back(member);
    }
    return members;
}

bool is_whole(double cells) {
    return std::abs(cells - std::round(cells)) < 1e-3;
}

void require_same_lattice(const GridSpec& grid, const GridSpec& other, const Place& where, Problems& problems) {
    const bool same = std::abs(grid.cell_size / other.cell_size - 1) < 1e-9 && grid.crs_wkt == other.crs_wkt &&
                      is_whole((grid.west - other.west) / grid.cell_size) &&
                      is_whole((grid.north - other.north) / grid.cell_size);
    if (!same)
        problems.add({"gives other cells than the central member, so that their maps cannot be combined", where, "", "",
                      "Set terrain.crs and terrain.cell-size in the scene, or bring the files to the same cells"});
}

/// What decides the members of later rounds besides the values and runs of the first.
std::string rounds_text(const StudyInput& input) {
    const StudySpec& study = input.reading.study;
    if (!study.rare_place) return "";
    const RareEvent event = rare_event(input);
    return "rare place = " + shortest_text(event.place.x) + ", " + shortest_text(event.place.y) + ", deeper than " +
           shortest_text(event.threshold) + "\nsamples = " + std::to_string(study.samples) +
           "\nseed = " + std::to_string(study.seed) + "\n";
}

/// What decides the maps of rates besides the members.
std::string frequency_text(const StudySpec& study) {
    std::string text;
    for (const auto& key : study_keys(study.kind))
        if (const auto value = key.section == "frequency" ? key.write(study) : std::nullopt)
            text += key.name() + " = " + *value + "\n";
    return text;
}

/// Refuses volumes that hardly cover the release: they are in thousands of m3.
void check_volumes(const StudyInput& input, Problems& problems) {
    constexpr double k_least_thickness = 0.02;  // [m]
    const auto& volumes = input.spec().frequency.volumes;
    double all = 0;
    for (const ReleaseArea& one : input.base.scene.release) all += area(one.outline);
    if (!volumes || !(all > 0) || volumes->back().volume / all >= k_least_thickness) return;
    problems.add({"has a greatest volume that is " + number_text(volumes->back().volume / all, 2) +
                      " m thick on the release of " + number_text(all, 4) + " m2",
                  input.reading.where("frequency.volumes"), shortest_text(volumes->back().volume) + " m3",
                  "at least " + shortest_text(k_least_thickness) + " m", "Write volumes in m3, not in thousands"});
}

/// Why importance sampling has no event to look for.
void check_rare_event(const StudyInput& input, Problems& problems) {
    const auto& gauge = input.reading.study.rare_place;
    if (!gauge) return;
    std::vector<std::string> names;
    for (const Gauge& one : input.base.scene.recording.gauges) names.push_back(one.name);
    if (std::find(names.begin(), names.end(), *gauge) == names.end())
        problems.add({"is no gauge of the scene", input.reading.where("study.rare-place"), *gauge,
                      names.empty() ? "" : joined(names, ", "),
                      names.empty() ? "Give the scene a layer with the point: output.gauges" : "Name one of these"});
    if (input.base.spec.output.depth_thresholds.empty())
        problems.add({"needs a depth that counts as reached", input.reading.where("study.rare-place"), *gauge, "",
                      "Give the scene output.depth-thresholds"});
}

std::vector<std::string> central_overrides(const StudySpec& study, const SampleTable& table) {
    const bool has_table = study.sampling == Sampling::table && table.size() > 0;
    return has_table ? table.overrides(table.size() / 2) : central_values(study);
}

/// Reads the scenes of the central member and of all members, and adds all problems to those of the former.
void read_scenes(const std::vector<std::string>& central, bool quiet, StudyInput& texts) {
    Problems& problems = texts.reading.problems;
    // The scene may be no INI.
    if (!attempt(problems, [&] { texts.central = read_member(texts.reading, central); })) problems.throw_if_any();
    refuse_accuracy(texts.central);
    if (!texts.reading.study.region) add_members_problems(texts.reading, texts.table, quiet, texts.central);
    for (const Problem& problem : texts.reading.problems.list()) texts.central.problems.add(problem);
}

}  // namespace

std::vector<const StudyInput*> StudyInput::studies() const {
    std::vector<const StudyInput*> all;
    for (const StudyInput& event : own) all.push_back(&event);
    if (all.empty()) all.push_back(this);
    return all;
}

std::size_t StudyInput::members() const {
    return table.parts.empty() ? table.size() : static_cast<std::size_t>(reading.study.samples);
}

RareEvent rare_event(const StudyInput& input) {
    const std::string& name = *input.reading.study.rare_place;
    const std::vector<Gauge>& gauges = input.base.scene.recording.gauges;
    const auto found = std::find_if(gauges.begin(), gauges.end(), [&](const Gauge& one) { return one.name == name; });
    return {name, found->place, input.base.spec.output.depth_thresholds.front()};
}

SceneReading StudyInput::member(std::size_t index) const {
    return scene_with(table.overrides(index));
}

SceneReading StudyInput::scene_with(const std::vector<std::string>& overrides) const {
    return read_member(reading, overrides);
}

StudyInput read_study_texts(const std::string& path, StudyKind kind, const Session& session, RunLog& log,
                            const std::optional<std::int64_t>& samples) {
    StudyInput texts;
    texts.reading = read_study(path, kind);
    if (samples) texts.reading.study.samples = *samples;
    texts.reading.session = session;
    std::vector<NamedFile> files;
    (void)with_files(texts.reading.study, [&](const std::string& key, const std::string& file) {
        files.push_back({key, file});
        return file;
    });
    warn_of_changed_inputs(
        files, std::filesystem::path(texts.reading.study.file).parent_path().string(),
        [&](const std::string& key) { return texts.reading.where(key); }, log);
    if (kind == StudyKind::calibration) {
        read_events(texts, log);
        return texts;
    }
    if (texts.reading.study.scene.empty()) texts.reading.problems.throw_if_any();
    std::vector<std::string> central;
    try {
        if (texts.reading.study.region) {
            const SceneReading scene = read_member(texts.reading, {});
            take_friction_period(*texts.reading.study.region, scene.scene.friction_table);
            add_polygons(scene, texts);
            find_problems([&](std::size_t i) { return read_member(texts.reading, texts.table.overrides(i)); },
                          texts.slopes, texts.reading.problems);
            if (texts.table.size() > 0) central = texts.table.overrides(by_size(texts.slopes).front());
        } else {
            texts.table = read_samples(texts.reading);
            central = central_overrides(texts.reading.study, texts.table);
        }
    } catch (const Error& error) {  // the scene is no INI
        texts.reading.problems.add(error);
        texts.reading.problems.throw_if_any();
    }
    read_scenes(central, log.is_quiet(), texts);
    for (const std::string& doubt : texts.reading.doubts)
        log.warn(worded("{1}: {2}", {std::filesystem::path(texts.reading.study.table).filename().string(), doubt}));
    warn_of_changed_inputs(texts.reading.study.file, texts.central, log);
    return texts;
}

StudyInput read_study_scenes(StudyReading reading, SampleTable table) {
    StudyInput texts;
    texts.reading = std::move(reading);
    texts.table = std::move(table);
    read_scenes(central_overrides(texts.reading.study, texts.table), true, texts);
    return texts;
}

StudyInput prepare_study(StudyInput input, const std::optional<Problem>& place, RunLog& log) {
    if (input.spec().is_calibration()) {
        prepare_events(input, place, log);
        return input;
    }
    // Whatever several members need is read once.
    input.reading.session.reads = input.central.session.reads = std::make_shared<RememberedReads>();
    Problems problems;
    if (input.reading.study.region) {
        prepare_region(input, place, log);
        return input;
    }
    input.base = prepare(input.central, place, log);
    doubt_ground(input.central, input.base, log);
    input.base.scene.time.frame_interval = 0;
    check_rare_event(input, problems);
    check_volumes(input, problems);
    problems.throw_if_any();
    input.identity = "study = " + name_of(input.reading.study.sampling) + "\n" + rounds_text(input) +
                     frequency_text(input.reading.study) + values_text(input.table) + scene_identity(input.base);
    RunLog silent(true);
    for (const std::size_t member : members_with_every_value(input.table)) {
        attempt(problems, [&] {
            const Prepared prepared = prepare(read_member(input.reading, input.table.overrides(member)), silent);
            require_same_lattice(input.base.scene.grid, prepared.scene.grid, "member " + std::to_string(member),
                                 problems);
            input.identity += "member " + std::to_string(member) + ":\n" + scene_identity(prepared);
            for (const ReleaseArea& area : prepared.scene.release) input.other_releases.push_back(area);
        });
    }
    problems.throw_if_any();
    return input;
}

std::vector<MappedEvents> mapped_events(const SceneSpec& scene) {
    std::vector<MappedEvents> all;
    const auto add = [&](Quantity quantity, const std::string& name, const std::vector<double>& thresholds) {
        MappedEvents events{quantity, thresholds, {}};
        for (const double threshold : thresholds)
            events.rasters.push_back("probability_" + name + "_" + shortest_text(threshold));
        all.push_back(std::move(events));
    };
    add(Quantity::depth, "depth", scene.output.depth_thresholds);
    add(Quantity::velocity, "velocity", scene.output.velocity_thresholds);
    if (!scene.output.pressure_thresholds.empty())
        add(Quantity::pressure, "pressure", scene.output.pressure_thresholds);
    if (const auto scheme = hazard_scheme_of(scene)) {
        MappedEvents events{Quantity::intensity, {}, {}};
        for (const HazardClass& kind : scheme->classes) {
            events.thresholds.push_back(kind.value - 0.5);  // classes are whole numbers
            events.rasters.push_back("probability_intensity_" + std::to_string(kind.value));
        }
        all.push_back(std::move(events));
    }
    return all;
}

RecordExtras record_extras(const SceneSpec& scene) {
    return {!scene.output.pressure_thresholds.empty(), hazard_scheme_of(scene)};
}

}  // namespace frana::app::study
