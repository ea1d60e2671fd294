// SPDX-License-Identifier: Apache-2.0
#include "app/study/plan/read_study.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <limits>
#include <set>

#include "app/study/plan/sampling.h"
#include "app/text/number_text.h"
#include "core/text.h"
#include "params/grammar/ini_file.h"
#include "params/grammar/value_text.h"
#include "params/keys/parameter.h"
#include "params/keys/scene_parameters.h"
#include "params/scene/read_scene.h"

namespace frana::app::study {

namespace {

namespace fs = std::filesystem;

constexpr const char* k_until_settled =
    "Remove it: after the design, runs are chosen one batch after the other until the posterior has settled; "
    "study.samples is the most there may be";

/// Keys of earlier versions, and what to use.
constexpr std::pair<const char*, const char*> k_gone_keys[] = {
    {"region.window", "Remove it: terrain is read where the flow of a slope comes"},
    {"study.levels", "Remove it: sampling = sobol is as certain at the same cost"},
    {"study.per-polygon", "Write a region, whose polygons each fail alone, and run it with `frana batch`"},
    {"study.refine", k_until_settled},
    {"study.coarse", k_until_settled}};

/// Sections of each kind of study, for messages.
constexpr const char* k_sections[] = {
    "An ensemble has the sections [study], [set], [vary], [correlate] and [frequency]; a calibration, for "
    "`frana calibrate`, also [objective] and [event NAME]",
    "A region has the sections [region], [set], [columns], [scenario NAME], or [vary], [correlate] and [frequency]",
    "A calibration has the sections [study], [objective], [set], [vary], [correlate], and for single events [event "
    "NAME], [set NAME], [vary NAME]"};

constexpr std::int64_t k_draws_of_slope = 64;
constexpr std::size_t k_longest_name = 60;  // of files named after events

/// The name of an event that has no section: that of its scene, in letters that names of files may have.
std::string event_name(const std::string& scene) {
    SceneSpec spec;
    spec.file = scene;
    std::string name = scene_name(spec).substr(0, k_longest_name);
    for (char& c : name)
        if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '-') c = '_';
    return name;
}

bool is_event_name(const std::string& name) {
    return !name.empty() && name.size() <= k_longest_name && std::all_of(name.begin(), name.end(), [](unsigned char c) {
        return std::isalnum(c) != 0 || c == '-' || c == '_';
    });
}

/// An entry by its parts: "set north.release.volume" is the key release.volume of [set], for the event north.
struct EntryName {
    std::string section, event, key;

    explicit EntryName(const std::string& name) {
        const auto dot = name.find('.');
        const std::string head = name.substr(0, dot);
        const auto space = head.find(' ');
        section = head.substr(0, space);
        if (space != std::string::npos) event = trimmed(head.substr(space));
        if (dot != std::string::npos) key = name.substr(dot + 1);
    }
};

/// Reads the entries of one study.
class StudyReader {
  public:
    explicit StudyReader(StudyReading& reading)
        : reading_(reading), study_(reading.study), folder_(fs::path(reading.study.file).parent_path().string()) {}

    void read(std::vector<IniEntry> entries);

  private:
    [[nodiscard]] bool is(StudyKind kind) const { return study_.kind == kind; }
    void add(const IniEntry& entry);
    bool read_key(const IniEntry& entry);
    void refuse_unknown(const IniEntry& entry, const EntryName& name);
    void add_setting(const std::string& key, const IniEntry& entry, std::vector<std::string>& set);
    void add_variation(const std::string& key, const IniEntry& entry, std::vector<Variation>& vary);
    void add_correlation(const std::string& keys, const IniEntry& entry);
    void add_column(const std::string& key, const IniEntry& entry, std::vector<RegionSpec::Column>& columns);
    void add_scenario(const EntryName& name, const IniEntry& entry);
    void check_scenarios();
    void add_scenes(const IniEntry& entry);
    void add_event(const std::string& name, const std::string& scene, const IniEntry& entry);
    void add_observation(EventSpec& event, const std::string& key, const IniEntry& entry);

    void check_scheme(const std::string& event);
    void check_columns();
    void check_keys(const StudySpec& study, const std::string& event);
    void check_correlations(const StudySpec& study, const std::string& event);
    void check_events();
    void check_frequency();
    void check_sampling();
    void check_option(const Variation& vary, std::size_t option, double first_round);

    [[nodiscard]] EventSpec* event_of(const std::string& name);
    /// Returns a key of the scene; null: there is none, which was refused.
    const Parameter* scene_key(const std::string& name, const IniEntry& entry);
    void refuse(const std::string& what, const IniEntry& entry, const std::string& limit, const std::string& remedy) {
        add_problem({what, where(entry.name), entry.value, limit, remedy});
    }
    void add_problem(const Problem& problem) { reading_.problems.add(problem); }
    [[nodiscard]] Place where(const std::string& name) const { return reading_.where(name); }
    /// The name of a key in a section: an event's own if that has one.
    [[nodiscard]] std::string name_in(const std::string& section, const std::string& key,
                                      const std::string& event) const;
    [[nodiscard]] bool has_seen(const std::string& name) const { return seen_.count(name) > 0; }
    [[nodiscard]] bool has_seen_any(const std::string& beginning) const;
    [[nodiscard]] bool has_volumes() const {
        return has_seen("frequency.volumes") || has_seen("columns.frequency.volumes");
    }

    StudyReading& reading_;
    StudySpec& study_;
    std::string folder_;          ///< of relative paths
    std::set<std::string> seen_;  ///< names of the entries so far, right or wrong
};

std::string StudyReader::name_in(const std::string& section, const std::string& key, const std::string& event) const {
    const std::string own = section + " " + event + "." + key;
    return has_seen(own) ? own : section + "." + key;
}

bool StudyReader::has_seen_any(const std::string& beginning) const {
    return std::any_of(seen_.begin(), seen_.end(),
                       [&](const std::string& name) { return name.starts_with(beginning); });
}

EventSpec* StudyReader::event_of(const std::string& name) {
    const auto found = std::find_if(study_.events.begin(), study_.events.end(),
                                    [&](const EventSpec& one) { return one.name == name; });
    return found == study_.events.end() ? nullptr : &*found;
}

const Parameter* StudyReader::scene_key(const std::string& name, const IniEntry& entry) {
    const std::vector<Parameter>& keys = scene_parameters();
    const Parameter* const key = find_parameter(keys, name);
    if (key == nullptr) {
        Problem problem = unknown_key(keys, name, where(entry.name));
        problem.value = entry.value;
        add_problem(problem);
    }
    return key;
}

bool names_scene(const std::string& entry) {
    return entry == "study.scene" || (entry.starts_with("event ") && entry.ends_with(".scene"));
}

void StudyReader::read(std::vector<IniEntry> entries) {
    // What is said of an event may stand before its scene.
    std::stable_partition(entries.begin(), entries.end(), [](const IniEntry& one) { return names_scene(one.name); });
    for (const IniEntry& entry : entries) add(entry);
    if (is(StudyKind::calibration)) {
        check_events();
        for (std::size_t e = 0; e < study_.events.size(); ++e) check_keys(study_.of_event(e), study_.events[e].name);
        return;
    }
    if (study_.scene.empty())
        add_problem({"is missing", where(study_.region ? "region.scene" : "study.scene"), "", "a scene file",
                     "Name the scene whose keys vary"});
    check_frequency();
    if (study_.region) return check_columns();
    check_keys(study_, "");
    check_sampling();
}

bool StudyReader::read_key(const IniEntry& entry) {
    const auto* const key = find_parameter(study_keys(study_.kind), entry.name);
    if (key == nullptr) return false;
    if (const auto refusal = key->read(study_, entry.value))
        refuse(refusal->what, entry, key->limits, refusal->remedy);
    else if (key->map_files)
        key->map_files(study_, [&](const std::string& path) { return absolute_path(path, folder_); });
    return true;
}

void StudyReader::add(const IniEntry& entry) {
    if (!seen_.insert(entry.name).second) return refuse("is given more than once", entry, "", "Keep one of the lines");
    if (entry.value.empty()) return refuse("has no value", entry, "", "Give one or remove the key");
    const EntryName name(entry.name);
    const bool is_calibration = is(StudyKind::calibration);
    if (is_calibration && entry.name == "study.scene") return add_scenes(entry);
    if (read_key(entry)) return;
    if (study_.region && name.section == "scenario" && !name.key.empty()) return add_scenario(name, entry);
    if (name.key.empty() || (!name.event.empty() && !is_calibration)) return refuse_unknown(entry, name);
    if (is_calibration && name.section == "event" && name.key == "scene")
        return add_event(name.event, entry.value, entry);
    EventSpec* const event = event_of(name.event);
    const bool is_value = name.section == "set" || name.section == "vary";
    if (!name.event.empty() && event == nullptr && (is_value || name.section == "event"))
        return refuse("there is no event " + name.event, entry, "",
                      "Give it a scene: [event " + name.event + "] scene = FILE");
    if (event != nullptr && name.section == "event") return add_observation(*event, name.key, entry);
    if (is_value && name.section == "set")
        return add_setting(name.key, entry, event != nullptr ? event->set : study_.set);
    if (is_value) return add_variation(name.key, entry, event != nullptr ? event->vary : study_.vary);
    if (name.event.empty() && name.section == "columns" && study_.region)
        return add_column(name.key, entry, study_.region->columns);
    if (name.event.empty() && name.section == "correlate") return add_correlation(name.key, entry);
    refuse_unknown(entry, name);
}

void StudyReader::refuse_unknown(const IniEntry& entry, const EntryName& name) {
    for (const auto& [gone, instead] : k_gone_keys)
        if (entry.name == gone) return refuse("is no longer a key", entry, "", instead);
    if (name.section == "degree" && study_.region)
        return refuse("is no longer a key of a region", entry, "",
                      "Write [degree] into a hazard scheme of your own (share/doc/hazard.md), and name that file in "
                      "hazard.scheme");
    if (is(StudyKind::calibration) && find_parameter(study_keys(StudyKind::ensemble), entry.name) != nullptr)
        return refuse("has no effect in a calibration", entry, "", "Remove it");
    const auto& keys = study_keys(study_.kind);
    const bool has_section =
        std::any_of(keys.begin(), keys.end(), [&](const auto& key) { return key.section == name.section; });
    const std::string sections = k_sections[static_cast<std::size_t>(study_.kind)];
    const std::string nearest = has_section || study_.region ? nearest_name(entry.name, names_of(keys)) : "";
    refuse("unknown key", entry, "",
           !nearest.empty() ? "Did you mean " + nearest + "?"
           : has_section    ? "Known are " + joined(names_of(keys), ", ")
                            : sections);
}

void StudyReader::add_column(const std::string& key, const IniEntry& entry, std::vector<RegionSpec::Column>& columns) {
    if (key == "frequency.rate" || key == "frequency.volumes") {
        study_.frequency.by_columns = true;
        return columns.push_back({key, entry.value});
    }
    const std::string name = present_name(key);
    const Parameter* const parameter = scene_key(name, entry);
    if (parameter == nullptr) return;
    if (name.starts_with("release.perimeter"))
        refuse("cannot differ from slope to slope", entry, "", "Each slope has one polygon of the perimeter");
    else if (const auto refusal = refusal_to_vary(*parameter))
        refuse(refusal->what, entry, "", refusal->remedy);
    else
        columns.push_back({name, entry.value});
}

void StudyReader::add_scenario(const EntryName& name, const IniEntry& entry) {
    if (!is_event_name(name.event))
        return refuse("'" + name.event + "' is not a name of a scenario", entry,
                      "letters, digits, - and _, " + std::to_string(k_longest_name) + " at most",
                      "Write [scenario 30]: files of the result contain it");
    std::vector<RegionSpec::Event>& events = study_.region->events;
    auto found = std::find_if(events.begin(), events.end(), [&](const auto& one) { return one.name == name.event; });
    if (found == events.end()) found = events.insert(found, {name.event, number_from_text(name.event).value_or(0), {}});
    if (name.key != "return-period") return add_column(name.key, entry, found->columns);
    const auto years = number_from_text(entry.value), of_name = number_from_text(name.event);
    if (!years || !(*years > 0) || (of_name && *of_name != *years))
        refuse("is not a number of years, or not that of the name", entry, of_name ? shortest_text(*of_name) : "",
               "Leave it out where the name says it: [scenario 30]");
    else
        found->return_period = *years;
}

/// Each polygon is one event in each scenario, by the same keys in columns of its own.
void StudyReader::check_scenarios() {
    RegionSpec& region = *study_.region;
    std::sort(region.events.begin(), region.events.end(), [](const auto& a, const auto& b) {
        return std::pair(a.return_period, a.name) < std::pair(b.return_period, b.name);
    });
    const auto keys_of = [](const RegionSpec::Event& event) {
        std::vector<std::string> keys;
        for (const RegionSpec::Column& one : event.columns) keys.push_back(one.key);
        std::sort(keys.begin(), keys.end());
        return keys;
    };
    for (const RegionSpec::Event& event : region.events) {
        const std::string section = "scenario " + event.name;
        if (!(event.return_period > 0) && !has_seen(section + ".return-period"))
            add_problem({"is missing", where(section + ".return-period"), "", "years",
                         "Give the scenario's return period, or name it by that: [scenario 30]"});
        if (event.columns.empty())
            add_problem({"has no column", where(section), "", "",
                         "Say what differs from scenario to scenario: release.thickness = COLUMN"});
        else if (keys_of(event) != keys_of(region.events.front()))
            add_problem({"has other keys than [scenario " + region.events.front().name + "]", where(section),
                         joined(keys_of(event), ", "), joined(keys_of(region.events.front()), ", "),
                         "Give every scenario a column for each of them"});
        for (const std::string& key : keys_of(event))
            if (has_seen("set." + key) || has_seen("columns." + key))
                add_problem({"is also in [set] or [columns]", where(section + "." + key), "", "", "Keep one of them"});
    }
}

void StudyReader::add_setting(const std::string& key, const IniEntry& entry, std::vector<std::string>& set) {
    const std::string name = present_name(key);
    const Parameter* const parameter = scene_key(name, entry);
    if (parameter == nullptr) return;
    SceneSpec scene;
    if (const auto refusal = parameter->read(scene, entry.value))
        refuse(refusal->what, entry, parameter->limits, refusal->remedy);
    else
        set.push_back(name + "=" + with_absolute_paths(*parameter, entry.value, folder_));
}

void StudyReader::add_variation(const std::string& key, const IniEntry& entry, std::vector<Variation>& vary) {
    const std::string name = present_name(key);
    const Parameter* const parameter = scene_key(name, entry);
    if (parameter == nullptr) return;
    if (const auto refusal = refusal_to_vary(*parameter)) return refuse(refusal->what, entry, "", refusal->remedy);
    auto read = distribution_from_text(entry.value);
    if (const auto* refusal = std::get_if<ValueProblem>(&read))
        return refuse(refusal->what, entry, k_distributions, refusal->remedy);
    auto& distribution = std::get<Distribution>(read);
    if (const auto refusal = refusal_of(*parameter, distribution))
        return refuse(refusal->what, entry, parameter->limits, refusal->remedy);
    for (std::string& value : distribution.values) value = with_absolute_paths(*parameter, value, folder_);
    vary.push_back({name, std::move(distribution)});
}

void StudyReader::add_correlation(const std::string& keys, const IniEntry& entry) {
    const std::vector<std::string> words = words_of(keys);
    const auto rho = number_from_text(entry.value);
    if (words.size() != 2 || words[0] == words[1])
        return refuse("is not a pair of varied keys", entry, "", "Write material.turbulence release.volume = 0.3");
    if (!rho || !(*rho > -1 && *rho < 1))
        return refuse("is not a rank correlation", entry, "greater than -1, less than 1", "");
    const Correlation one{present_name(words[0]), present_name(words[1]), *rho};
    auto& all = study_.correlate;
    const auto is_same = [&](const Correlation& other) {
        return std::minmax(one.first, one.second) == std::minmax(other.first, other.second);
    };
    if (std::any_of(all.begin(), all.end(), is_same))
        return refuse("is given more than once, in either order", entry, "", "Keep one of the lines");
    all.push_back(one);
}

void StudyReader::add_event(const std::string& name, const std::string& scene, const IniEntry& entry) {
    if (!is_event_name(name)) {
        refuse("'" + name + "' is not a name of an event", entry,
               "letters, digits, - and _, " + std::to_string(k_longest_name) + " at most",
               "Files of the result contain it");
    } else if (event_of(name) != nullptr) {
        refuse("there are two events with the name " + name, entry, "",
               "Give each a section [event NAME] with its scene");
    } else {
        study_.events.push_back({name, absolute_path(scene, folder_), {}, {}, {}});
    }
}

void StudyReader::add_scenes(const IniEntry& entry) {
    std::string rest = entry.value;
    while (!rest.empty()) {
        const auto comma = rest.find(',');
        const std::string scene = trimmed(rest.substr(0, comma));
        rest = comma == std::string::npos ? "" : rest.substr(comma + 1);
        if (scene.empty()) {
            refuse("has an empty name of a scene", entry, "", "Write scene = one.ini, other.ini");
            continue;
        }
        add_event(event_name(absolute_path(scene, folder_)), scene, entry);
    }
}

void StudyReader::add_observation(EventSpec& event, const std::string& key, const IniEntry& entry) {
    const auto [value, error] = number_and_deviation(entry.value);
    const std::size_t space = key.find(' ');
    const std::string word = key.substr(0, space), gauge = space == std::string::npos ? "" : trimmed(key.substr(space));
    const auto kind = std::find_if(std::begin(k_observed_kinds), std::end(k_observed_kinds),
                                   [&](const ObservedKind& one) { return one.word == word; });
    if (kind == std::end(k_observed_kinds) || gauge.empty() != (kind->evidence == Evidence::runout))
        refuse("unknown key", entry, "",
               "An event has scene, runout, and at gauges of its scene arrival GAUGE, speed GAUGE, depth GAUGE");
    else if (!(value > 0 && value < 1e9))
        refuse("is not a number greater than 0", entry, std::string("in ") + kind->unit,
               "Write for example 35, or 35 +- 5 with its standard deviation");
    else if (!(error < 1e9))
        refuse("has an error that is not a number greater than 0", entry, "", "Write for example 35 +- 5");
    else
        event.observed.push_back({kind->evidence, gauge, value, error});
}

void StudyReader::check_scheme(const std::string& event) {
    for (const char* section : {"set", "vary", "columns"})
        if (const std::string scheme = name_in(section, "numerics.scheme", event); study_.scheme && has_seen(scheme))
            add_problem({"is also given by scheme", where(scheme), "", "", "Keep one of them"});
}

void StudyReader::check_columns() {
    const RegionSpec& region = *study_.region;
    check_scenarios();
    if (const bool twice = region.scenario || region.return_period;
        !region.events.empty() && (twice || study_.frequency.is_given()))
        add_problem({"contradicts [scenario " + region.events.front().name + "]: give each event once",
                     where(twice ? "region.scenario" : "frequency"), region.scenario.value_or(""), "",
                     "Keep one of the two, or make two regions"});
    if (study_.frequency.is_given()) {
        study_.sampling = Sampling::sobol;
        check_keys(study_, "");
        for (const auto& [key, column] :
             {std::pair{"region.scenario", region.scenario}, std::pair{"region.return-period", region.return_period}})
            if (column)
                add_problem({"contradicts the frequency: an event has one of the two", where(key), *column, "",
                             "Remove it, or run scenarios and frequency as two regions"});
    } else {
        check_scheme("");
        for (const char* key : {"region.samples", "region.seed"})
            if (has_seen(key)) add_problem({"has no effect without a frequency", where(key), "", "", "Remove it"});
        if (!study_.vary.empty())
            add_problem({"needs a frequency: slopes that fail alone have no probability together", where("vary"), "",
                         "", "Say how often each fails: [frequency] rate, or frequency.rate in [columns]"});
    }
    for (const RegionSpec::Column& one : region.columns)
        for (const std::string& set : study_.set)
            if (set.starts_with(one.key + "="))
                add_problem({"is also set for all slopes", where("columns." + one.key), "", "",
                             "Keep it in one of [set] and [columns]"});
    for (const Variation& one : study_.vary)
        if (has_seen("columns." + one.key))
            add_problem({"also has a column", where("vary." + one.key), one.distribution.text, "",
                         "Keep it in one of [vary] and [columns]"});
}

/// @param event whose study it is; empty: not of a calibration
void StudyReader::check_keys(const StudySpec& study, const std::string& event) {
    check_scheme(event);
    for (const Variation& one : study.vary) {
        const std::string name = name_in("vary", one.key, event);
        if (has_seen(name_in("set", one.key, event)))
            add_problem({"is also set for all members", where(name), "", "", "Keep it in one of [set] and [vary]"});
        if (name != "vary." + one.key && has_seen("vary." + one.key))
            add_problem({"is given more than once", where(name), one.distribution.text, "", "Keep one of the lines"});
    }
    const bool by_table = study.sampling == Sampling::table,
               has_vary = has_seen_any("vary.") || (!event.empty() && has_seen_any("vary " + event + "."));
    if (by_table && (has_vary || !study.correlate.empty()))
        add_problem({"gives all values: [vary] and [correlate] have no effect", where("study.sampling"), "", "",
                     "Remove the sections, or choose another sampling"});
    if (!by_table && !has_vary && !has_volumes())
        add_problem({"has no key", where("vary"), "", "", "Give at least one key a distribution"});
    const auto varies = [&](const char* key) {
        return std::any_of(study.vary.begin(), study.vary.end(), [&](const Variation& one) { return one.key == key; });
    };
    if (varies("material.friction-angle") && varies("material.friction-coefficient"))
        add_problem({"contradicts vary.material.friction-coefficient: both give the bed friction",
                     where(name_in("vary", "material.friction-angle", event)), "", "", "Keep one of the two"});
    check_correlations(study, event);
}

void StudyReader::check_correlations(const StudySpec& study, const std::string& event) {
    for (const Correlation& one : study.correlate) {
        for (const std::string& key : {one.first, one.second}) {
            const auto varied = std::find_if(study.vary.begin(), study.vary.end(),
                                             [&](const Variation& vary) { return vary.key == key; });
            const std::string place = where("correlate." + one.first + " " + one.second);
            const bool tried = has_seen(name_in("vary", key, event)) ||
                               (key == k_volume_key && has_volumes());  // its problem is told already
            if (varied == study.vary.end() && !tried)
                add_problem({key + " does not vary", place, "", "", "Add it to [vary]"});
            if (varied != study.vary.end() && varied->distribution.is_nominal())
                add_problem({key + " has values without an order, which cannot be correlated", place, "", "",
                             "Remove the line"});
        }
    }
}

void StudyReader::check_events() {
    if (std::none_of(seen_.begin(), seen_.end(), names_scene))
        add_problem({"is missing", where("study.scene"), "", "scene files",
                     "Name the scene of each event, with its [observed]"});
    std::erase_if(study_.objective, [](const Weight& one) { return !(one.weight > 0); });
    if (study_.objective.empty())
        add_problem({"has no measure with a weight greater than 0", where("objective"), "", "",
                     "Say what is compared with the surveys: [objective] jaccard = 1"});
}

/// Completes the frequency: volumes give the rate, and release.volume its distribution.
void StudyReader::check_frequency() {
    const FrequencySpec& given = study_.frequency;
    if (!given.is_given() && given.return_periods && !has_seen_any("frequency.rate") &&
        !has_seen_any("frequency.volumes"))
        add_problem({"has no effect without a frequency", where("frequency.return-periods"), "", "", "Remove it"});
    if (given.is_given() && given.exponent_error && !has_volumes() && !has_seen("vary.release.volume"))
        add_problem({"needs a law of volumes", where("frequency.exponent-error"), "", "", "Vary release.volume"});
    if (!given.is_given() || !has_volumes()) return;
    const std::string name = given.volumes ? "frequency.volumes" : "columns.frequency.volumes";
    const std::string text = find_parameter(study_keys(study_.kind), "frequency.volumes")->write(study_).value_or("");
    StudySpec varied = study_;
    if (auto contradiction = vary_volumes(varied)) {
        contradiction->where = where("frequency.rate");
        add_problem(*contradiction);
    }
    if (const SamplingMethod& method = method_of(study_.sampling);
        !study_.region && method.kind != SamplingMethod::Kind::sample)
        add_problem({"decides how members are drawn, which sampling = " + std::string(method.name) + " does too",
                     where(name), text, "", "Write sampling = sobol, or keep frequency.rate alone"});
    for (const std::string section : {"set", "vary", "columns"})
        if (has_seen(section + "." + k_volume_key))
            return add_problem({"decides release.volume, which [" + section + "] has too", where(name), text, "",
                                "Keep it in one of the two sections"});
    if (!study_.region) study_ = std::move(varied);
}

void StudyReader::check_option(const Variation& vary, std::size_t option, double first_round) {
    const double share = vary.distribution.weights[option];
    if (share * first_round >= k_least_tries_of_option) return;
    const double needed = std::ceil(k_least_tries_of_option / share / k_round_ends[0]);
    add_problem(
        {"has an option that the first round of sampling = importance may not try, so that it is not known "
         "whether it leads to the rare place",
         where("vary." + vary.key), vary.distribution.values[option] + ": " + number_text(share, 2),
         "at least " + number_text(k_least_tries_of_option / first_round, 2),
         needed > static_cast<double>(k_most_samples) ? "Make it likelier, or run each option as a study of its own"
                                                      : "Write study.samples = " + shortest_text(needed) +
                                                            " or more, or run each option as a study of its own"});
}

void StudyReader::check_sampling() {
    using Kind = SamplingMethod::Kind;
    const StudySpec& study = study_;
    const SamplingMethod& method = method_of(study.sampling);
    const auto refuse_for = [&](const std::string& what, const std::string& remedy) {
        add_problem({what, where("study.sampling"), method.name, "", remedy});
    };
    if (method.kind == Kind::design && !study.correlate.empty())
        refuse_for("needs independent keys", "Remove [correlate], or choose another sampling");
    if (study.until && method.kind != Kind::sample)
        refuse_for("cannot be stopped before its last member by study.until",
                   "Remove study.until, or choose sobol or random");
    if (method.more_in_group > 0 && !study.vary.empty()) {
        const auto group = static_cast<std::int64_t>(study.group_size());
        if (study.samples % group != 0 || study.samples / group < 2)
            add_problem({"is not a multiple of the keys plus " + std::to_string(method.more_in_group) +
                             ", which sampling = " + method.name + " needs",
                         where("study.samples"), std::to_string(study.samples), "",
                         "Write " + std::to_string(std::max<std::int64_t>(2, study.samples / group) * group)});
    }
    if (study.rows && study.sampling != Sampling::table)
        add_problem({"has no effect without a table", where("study.for"), *study.rows, "",
                     "Remove it, or write sampling = table:posterior.csv"});
    const bool in_rounds = study.sampling == Sampling::importance;
    if (in_rounds && !study.rare_place)
        refuse_for("needs a place that is seldom reached",
                   "Add study.rare-place = the name of a gauge of output.gauges, or choose another sampling");
    if (!in_rounds && study.rare_place)
        add_problem({"has no effect with sampling = " + std::string(method.name), where("study.rare-place"),
                     *study.rare_place, "", "Remove it, or write sampling = importance"});
    if (in_rounds && study.samples < k_least_in_rounds)
        add_problem({"are too few for the rounds of sampling = importance", where("study.samples"),
                     std::to_string(study.samples), "at least " + std::to_string(k_least_in_rounds),
                     "Write " + std::to_string(k_least_in_rounds) + " or more"});
    for (const Variation& one : study.vary)
        for (std::size_t i = 0; in_rounds && i < one.distribution.weights.size(); ++i)
            check_option(one, i, static_cast<double>(round_end(study, 0)));
}

}  // namespace

std::pair<double, double> number_and_deviation(const std::string& text) {
    constexpr double k_none = std::numeric_limits<double>::quiet_NaN();
    const std::size_t sign = std::min(text.find("+-"), text.find("\u00b1"));  // each has two bytes
    const double value = number_from_text(trimmed(text.substr(0, sign))).value_or(k_none);
    if (sign == std::string::npos) return {value, 0};
    const double deviation = number_from_text(trimmed(text.substr(sign + 2))).value_or(0);
    return {value, deviation > 0 ? deviation : k_none};
}

std::optional<StudyKind> study_kind(const std::string& path) {
    std::optional<StudyKind> kind;
    for (const IniEntry& entry : read_ini(path)) {
        if (entry.name.starts_with("objective.") || entry.name.starts_with("event ")) return StudyKind::calibration;
        if (entry.name.starts_with("region.")) kind = StudyKind::region;
        if (entry.name.starts_with("study.") && !kind) kind = StudyKind::ensemble;
    }
    return kind;
}

StudyReading read_study(const std::string& path, StudyKind kind) {
    StudyReading reading;
    reading.label = path;
    reading.study.kind = kind;
    reading.study.file = fs::absolute(path).lexically_normal().string();
    if (kind == StudyKind::region) {
        reading.study.sampling = Sampling::polygons;
        reading.study.samples = k_draws_of_slope;
        reading.study.region.emplace();
    }
    StudyReader(reading).read(read_ini(path));
    return reading;
}

}  // namespace frana::app::study
