// SPDX-License-Identifier: Apache-2.0
#include "app/study/plan/study_input.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
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
#include "core/text.h"
#include "gis/access/table_in.h"
#include "params/grammar/value_text.h"
#include "params/keys/output_parameters.h"

namespace frana::app::study {
namespace {

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

/// Keeps the rows of a posterior that the study asks for, and the columns that these fill.
void choose_rows(StudyReading& reading, gis::Table& table) {
    const std::string asked = reading.study.rows.value_or(k_new_slope), use = asked.substr(0, asked.find(' ')),
                      event = trimmed(asked.substr(use.size()));
    const auto refuse = [&](const std::string& what, const std::string& limit) {
        reading.problems.add({what, reading.where("study.for"), asked, limit,
                              "Write new-slope, this-event, or this-event NAME of several events"});
    };
    if (table.columns.size() < 2 || table.columns[0] != k_for_column || table.columns[1] != k_event_column) {
        if (reading.study.rows) refuse("has no effect: the table does not begin with the columns for and event", "");
        return;
    }
    std::set<std::string> events;
    for (const auto& row : table.rows)
        if (row[0] == k_this_event) events.insert(row[1]);
    const std::string names = joined({events.begin(), events.end()}, ", ");
    if (use == k_this_event && event.empty() && events.size() > 1) return refuse("is of several events", names);
    const std::string scene = std::filesystem::path(reading.study.scene).stem().string();
    if (!reading.study.rows && events.count(scene) > 0)
        reading.doubts.push_back("draws of a new slope for the scene of event " + scene +
                                 "; for the event itself write study.for = this-event" +
                                 (events.size() > 1 ? " " + scene : ""));
    std::erase_if(table.rows, [&](const auto& row) { return row[0] != use || (!event.empty() && row[1] != event); });
    if (table.rows.empty()) return refuse("is not in the table", names);
    for (std::size_t i = table.columns.size(); i-- > 0;) {
        const auto is_empty = [&](const auto& row) { return trimmed(row[i]).empty(); };
        if (i > 1 && !std::all_of(table.rows.begin(), table.rows.end(), is_empty)) continue;
        const auto at = static_cast<std::ptrdiff_t>(i);
        table.columns.erase(table.columns.begin() + at);
        for (auto& row : table.rows) row.erase(row.begin() + at);
    }
}

SampleTable read_samples(StudyReading& reading) {
    if (reading.study.sampling == Sampling::table) {
        const Place where = reading.where("study.sampling");
        const auto read = [&] {
            gis::Table file = gis::read_table(reading.study.table, where);
            reading.doubts = file.remarks;
            choose_rows(reading, file);
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
    const Findings found{log, texts.warnings};
    found.warn_all(changed_inputs(files, std::filesystem::path(texts.reading.study.file).parent_path().string(),
                                  [&](const std::string& key) { return texts.reading.where(key); }));
    if (kind == StudyKind::calibration) {
        read_events(texts, log);
        return texts;
    }
    if (texts.reading.study.scene.empty()) texts.reading.problems.throw_if_any();
    std::vector<std::string> central;
    try {
        if (texts.reading.study.region) {
            add_slopes(texts);
            if (texts.table.size() > 0)
                central = texts.table.overrides(texts.first_member(by_size(texts.slopes).front()));
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
        found.warn(worded("{1}: {2}", {std::filesystem::path(texts.reading.study.table).filename().string(), doubt}));
    found.warn_all(changed_inputs(texts.reading.study.file, texts.central));
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
    input.base = prepare(input.central, place, {log, input.warnings});
    input.base.scene.warnings += log.tell(doubt_ground(input.central, input.base));
    input.base.scene.time.frame_interval = 0;
    check_rare_event(input, problems);
    double all = 0;
    for (const ReleaseArea& one : input.base.scene.release) all += area(one.outline);
    if (const auto thin = thin_volumes(input.spec().frequency, all, input.reading.where("frequency.volumes")))
        problems.add(*thin);
    problems.throw_if_any();
    input.identity = "study = " + name_of(input.reading.study.sampling) + "\n" + rounds_text(input) +
                     frequency_text(input.spec()) + values_text(input.table) + scene_identity(input.base);
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
    if (!scene.output.momentum_flux_thresholds.empty())
        add(Quantity::momentum, "momentum_flux", scene.output.momentum_flux_thresholds);
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

}  // namespace frana::app::study
