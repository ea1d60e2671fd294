// SPDX-License-Identifier: Apache-2.0
#include "app/study/plan/read_calibration.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <set>

#include "app/study/plan/entry_reader.h"
#include "core/text.h"
#include "params/grammar/ini_file.h"
#include "params/grammar/value_text.h"
#include "params/keys/declare.h"
#include "params/keys/scene_spec.h"

namespace frana::app::study {

std::size_t CalibrationSpec::key_count() const {
    return first_own_key(events.size());
}

std::size_t CalibrationSpec::first_own_key(std::size_t event) const {
    std::size_t keys = study.vary.size();
    for (std::size_t e = 0; e < event; ++e) keys += events[e].vary.size();
    return keys;
}

namespace {

namespace fs = std::filesystem;

/// Numbers of [study] and [objective] that only calibrations have; parser, messages and echo follow from them.
const std::vector<ParameterOf<CalibrationSpec>>& calibration_keys() {
    using namespace declare;
    static const std::vector<ParameterOf<CalibrationSpec>> k_keys{
        number<CalibrationSpec>("objective.exponent", FRANA_MEMBER(exponent), "", Range{0.1, 1000},
                                "N of the likelihood (misfit)^-N of an event whose survey has no stated error: the "
                                "number of independent pieces of information in it.")};
    return k_keys;
}

/// The weights of [objective], a measure each.
const std::vector<ParameterOf<Weight>>& weight_keys() {
    static const std::vector<ParameterOf<Weight>> k_keys = [] {
        std::vector<ParameterOf<Weight>> keys;
        for (const MeasureRow& row : k_measures)
            keys.push_back(declare::number<Weight>(std::string("objective.") + row.name, FRANA_MEMBER(weight), "",
                                                   NumberRange{0, 1e6}, row.formula));
        return keys;
    }();
    return k_keys;
}

constexpr const char* k_sections =
    "A calibration has the sections [study], [objective], [set], [vary], [correlate], and for single events [event "
    "NAME], [set NAME], [vary NAME]";

constexpr std::size_t k_longest_name = 60;  // files are named after events

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

/// Reads the entries of one calibration: sorts them by event, and lets the reader of studies read what an event's study
/// would contain.
class CalibrationReader : private EntryReader {
  public:
    CalibrationReader(CalibrationReading& reading, std::string folder)
        : EntryReader(reading.label, std::move(folder), reading.problems), reading_(reading) {}

    void read_all(const std::vector<IniEntry>& entries);

  private:
    void add_entry(const IniEntry& entry);
    void add_scenes(const IniEntry& entry);
    void add_event(const std::string& name, const std::string& scene, const IniEntry& entry);
    void add_weight(const std::string& name, const IniEntry& entry);
    void add_observation(const std::string& event, const std::string& key, const IniEntry& entry);
    void read_members();
    void read_event(EventSpec& event);
    void check();
    [[nodiscard]] EventSpec* event_of(const std::string& name);
    void refuse_event(const std::string& name, const IniEntry& entry) {
        refuse("there is no event " + name, entry, "", "Give it a scene: [event " + name + "] scene = FILE");
    }

    CalibrationReading& reading_;
    std::map<std::string, std::string> scenes_;               ///< by event
    std::vector<IniEntry> shared_;                            ///< for the study of each event
    std::map<std::string, std::vector<IniEntry>> own_;        ///< by event
    std::vector<std::pair<std::string, IniEntry>> observed_;  ///< event, entry
};

EventSpec* CalibrationReader::event_of(const std::string& name) {
    auto& events = reading_.calibration.events;
    const auto found =
        std::find_if(events.begin(), events.end(), [&](const EventSpec& one) { return one.name == name; });
    return found == events.end() ? nullptr : &*found;
}

void CalibrationReader::add_event(const std::string& name, const std::string& scene, const IniEntry& entry) {
    if (!is_event_name(name)) {
        refuse("'" + name + "' is not a name of an event", entry,
               "letters, digits, - and _, " + std::to_string(k_longest_name) + " at most",
               "Files of the result contain it");
    } else if (event_of(name) != nullptr) {
        refuse("there are two events with the name " + name, entry, "",
               "Give each a section [event NAME] with its scene");
    } else {
        reading_.calibration.events.push_back({name, {}, {}, {}, {}, {}, {}, {}});
        scenes_[name] = absolute_path(scene, folder());
    }
}

void CalibrationReader::add_scenes(const IniEntry& entry) {
    std::string rest = entry.value;
    while (!rest.empty()) {
        const auto comma = rest.find(',');
        const std::string scene = trimmed(rest.substr(0, comma));
        rest = comma == std::string::npos ? "" : rest.substr(comma + 1);
        if (scene.empty()) {
            refuse("has an empty name of a scene", entry, "", "Write scene = one.ini, other.ini");
            continue;
        }
        add_event(event_name(absolute_path(scene, folder())), scene, entry);
    }
}

void CalibrationReader::add_weight(const std::string& name, const IniEntry& entry) {
    std::vector<std::string> names{"exponent"};
    for (const MeasureRow& row : k_measures) {
        names.emplace_back(row.name);
        Weight weight{row.measure, 0};
        if (name != row.name) continue;
        read(weight_keys(), entry, weight);
        if (weight.weight > 0) reading_.calibration.objective.push_back(weight);
        return;
    }
    refuse_name("unknown measure", name, names, "", entry, joined(names, ", "));
}

void CalibrationReader::add_observation(const std::string& event, const std::string& key, const IniEntry& entry) {
    EventSpec* const spec = event_of(event);
    if (spec == nullptr) return refuse_event(event, entry);
    // As many bytes in ASCII as in UTF-8.
    const std::size_t sign = std::min(entry.value.find("+-"), entry.value.find("\u00b1"));
    const auto value = number_from_text(trimmed(entry.value.substr(0, sign))),
               error = sign == std::string::npos ? std::optional(0.0)
                                                 : number_from_text(trimmed(entry.value.substr(sign + 2)));
    const std::size_t space = key.find(' ');
    const std::string word = key.substr(0, space), gauge = space == std::string::npos ? "" : trimmed(key.substr(space));
    const auto kind = std::find_if(std::begin(k_gauge_kinds), std::end(k_gauge_kinds),
                                   [&](const GaugeKind& one) { return one.word == word; });
    const bool at_gauge = kind != std::end(k_gauge_kinds) && !gauge.empty();
    if (key != "runout" && !at_gauge)
        refuse("unknown key", entry, "",
               "An event has scene, runout, and at gauges of its scene arrival GAUGE, speed GAUGE, depth GAUGE");
    else if (!value || !(*value > 0 && *value < 1e9))
        refuse("is not a number greater than 0", entry, at_gauge ? std::string("in ") + kind->unit : "in m",
               "Write for example 35, or 35 +- 5 with its standard deviation");
    else if (!error || !(*error < 1e9) || (sign != std::string::npos && !(*error > 0)))
        refuse("has an error that is not a number greater than 0", entry, "", "Write for example 35 +- 5");
    else if (at_gauge)
        (spec->*(kind->values)).push_back({gauge, *value, *error});
    else
        spec->runout = GaugeValue{"", *value, *error};
}

void CalibrationReader::add_entry(const IniEntry& entry) {
    if (!is_good(entry)) return;
    const auto dot = entry.name.find('.');
    const std::string head = entry.name.substr(0, dot),
                      rest = dot == std::string::npos ? "" : entry.name.substr(dot + 1);
    const auto space = head.find(' ');
    const std::string section = head.substr(0, space),
                      event = space == std::string::npos ? "" : trimmed(head.substr(space));
    static const std::set<std::string> k_without_effect{"study.until", "study.keep", "study.rare-place"},
        k_gone{"study.refine", "study.coarse"};
    if (rest.empty()) return refuse("unknown key", entry, "", k_sections);
    if (event.empty() && k_without_effect.count(entry.name) > 0)
        return refuse("has no effect in a calibration", entry, "", "Remove it");
    if (event.empty() && k_gone.count(entry.name) > 0)
        return refuse("is no longer a key", entry, "",
                      "Remove it: after the design, runs are chosen one batch after the other until the posterior has "
                      "settled; study.samples is the most there may be");
    if (entry.name == "study.scene") return add_scenes(entry);
    if (read(calibration_keys(), entry, reading_.calibration)) return;
    if (section == "objective" && event.empty()) return add_weight(rest, entry);
    if (section == "event" && !event.empty()) {
        if (rest == "scene") return add_event(event, entry.value, entry);
        observed_.emplace_back(event, entry);
        return;
    }
    if ((section == "set" || section == "vary") && !event.empty()) {
        own_[event].push_back({section + "." + rest, entry.value});
        return;
    }
    if (event.empty() && (section == "study" || section == "set" || section == "vary" || section == "correlate")) {
        shared_.push_back(entry);
        return;
    }
    refuse("unknown key", entry, "", k_sections);
}

/// What the study of one event contains; problems of its own keys are told with their own sections.
void CalibrationReader::read_event(EventSpec& event) {
    const std::vector<IniEntry>& own = own_[event.name];
    std::vector<IniEntry> entries{{"study.scene", scenes_[event.name]}};
    for (const IniEntry& entry : shared_) {
        const bool replaced =
            entry.name.starts_with("set.") &&
            std::any_of(own.begin(), own.end(), [&](const IniEntry& o) { return o.name == entry.name; });
        if (!replaced) entries.push_back(entry);
    }
    entries.insert(entries.end(), own.begin(), own.end());
    event.members = read_study_entries(entries, reading_.label);
    for (Problem problem : event.members.problems.list()) {
        for (const IniEntry& entry : own) {
            if (problem.where != reading_.where(entry.name)) continue;
            const auto dot = entry.name.find('.');
            problem.where = reading_.where(entry.name.substr(0, dot) + " " + event.name + entry.name.substr(dot));
        }
        const auto& known = reading_.problems.list();
        if (std::none_of(known.begin(), known.end(),
                         [&](const Problem& one) { return describe(one) == describe(problem); }))
            reading_.problems.add(problem);
    }
    event.members.problems = {};
    const StudySpec& study = event.members.study;
    const auto is_own = [&](const std::string& name) {
        return std::any_of(own.begin(), own.end(), [&](const IniEntry& o) { return o.name == name; });
    };
    for (const std::string& one : study.set)
        if (is_own("set." + one.substr(0, one.find('=')))) event.set.push_back(one);
    for (const Variation& one : study.vary)
        if (is_own("vary." + one.key)) event.vary.push_back(one);
}

void CalibrationReader::read_members() {
    CalibrationSpec& calibration = reading_.calibration;
    for (EventSpec& event : calibration.events) read_event(event);
    for (const auto& [event, entries] : own_)
        for (const IniEntry& entry : entries)
            if (event_of(event) == nullptr) {
                refuse_event(event, entry);
                break;
            }
    if (calibration.events.empty()) return;
    std::vector<IniEntry> shared{{"study.scene", scenes_.begin()->second}};
    shared.insert(shared.end(), shared_.begin(), shared_.end());
    calibration.study = read_study_entries(shared, reading_.label).study;  // its problems are those of every event
    calibration.study.scene.clear();
}

void CalibrationReader::check() {
    CalibrationSpec& calibration = reading_.calibration;
    const bool names_scene = std::any_of(seen().begin(), seen().end(), [](const std::string& name) {
        return name == "study.scene" || (name.starts_with("event ") && name.ends_with(".scene"));
    });
    if (!names_scene)
        add_problem({"is missing", where("study.scene"), "", "scene files",
                     "Name the scene of each event, with its [observed]"});
    if (calibration.objective.empty() && std::none_of(seen().begin(), seen().end(), [](const std::string& name) {
            return name.starts_with("objective.") && name != "objective.exponent";
        }))
        add_problem({"has no measure", where("objective"), "", "",
                     "Say what is compared with the surveys: [objective] jaccard = 1"});
    else if (calibration.objective.empty())
        add_problem({"has no weight greater than 0", where("objective"), "", "", "Give a measure a weight"});
    using Kind = SamplingMethod::Kind;
    const SamplingMethod& method = method_of(calibration.study.sampling);
    if (!calibration.events.empty() && method.kind != Kind::sample)
        add_problem({"is not for calibrations", where("study.sampling"), method.name,
                     joined(sampling_words([](const SamplingMethod& row) { return row.kind == Kind::sample; }), ", "),
                     "Choose one of these"});
}

void CalibrationReader::read_all(const std::vector<IniEntry>& entries) {
    for (const IniEntry& entry : entries) add_entry(entry);
    for (const auto& [event, entry] : observed_)
        add_observation(event, entry.name.substr(entry.name.find('.') + 1), entry);
    read_members();
    check();
}

std::string events_text(const EventSpec& event) {
    std::string text = "\n[event " + event.name + "]\nscene = " + event.members.study.scene + "\n";
    const auto value = [](const GaugeValue& one) {
        return shortest_text(one.value) + (one.error > 0 ? " +- " + shortest_text(one.error) : "") + "\n";
    };
    if (event.runout) text += "runout = " + value(*event.runout);
    for (const GaugeKind& kind : k_gauge_kinds)
        for (const GaugeValue& one : event.*(kind.values))
            text += std::string(kind.word) + " " + one.gauge + " = " + value(one);
    return text + settings_text("set " + event.name, event.set) + variations_text("vary " + event.name, event.vary);
}

}  // namespace

bool is_calibration(const std::string& path) {
    return has_section(path, "objective.") || has_section(path, "event ");
}

CalibrationReading read_calibration(const std::string& path) {
    CalibrationReading reading;
    reading.label = path;
    const fs::path absolute = fs::absolute(path).lexically_normal();
    CalibrationReader(reading, absolute.parent_path().string()).read_all(read_ini(path));
    return reading;
}

CalibrationSpec with_files(CalibrationSpec calibration, const KeyedFileMap& map) {
    calibration.study = with_files(std::move(calibration.study), map);
    for (EventSpec& event : calibration.events) {
        event.set = with_files(std::move(event.set), map);
        event.vary = with_files(std::move(event.vary), map);
        event.members.study = with_files(std::move(event.members.study), map);
    }
    return calibration;
}

CalibrationSpec seen_from(CalibrationSpec calibration, const std::string& folder) {
    return with_files(std::move(calibration),
                      [&](const std::string&, const std::string& path) { return relative_path(path, folder); });
}

std::string calibration_text(const CalibrationSpec& calibration) {
    const StudySpec& study = calibration.study;
    std::string text = "# A calibration as used; `frana calibrate` on this file repeats it.\n\n[study]\nsamples = " +
                       std::to_string(study.samples) + "\nsampling = " + name_of(study.sampling) +
                       "\nseed = " + std::to_string(study.seed) +
                       (study.scheme ? "\nscheme = " + word_of(*study.scheme, k_schemes) : "") + "\n\n[objective]\n" +
                       keys_text(calibration_keys(), calibration, "objective");
    for (const MeasureRow& row : k_measures) {
        const auto found = std::find_if(calibration.objective.begin(), calibration.objective.end(),
                                        [&](const Weight& one) { return one.measure == row.measure; });
        text += std::string("# ") + row.formula + "\n";
        text += found == calibration.objective.end() ? std::string("# ") + row.name + " =\n"
                                                     : row.name + (" = " + shortest_text(found->weight)) + "\n";
    }
    text += settings_text("set", study.set) + variations_text("vary", study.vary) + correlations_text(study);
    for (const EventSpec& event : calibration.events) text += events_text(event);
    return text;
}

}  // namespace frana::app::study
