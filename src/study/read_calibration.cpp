// SPDX-License-Identifier: Apache-2.0
#include "study/read_calibration.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <set>

#include "core/text.h"
#include "params/grammar/ini_file.h"
#include "params/grammar/value_text.h"
#include "params/keys/scene_spec.h"

namespace frana::study {
namespace {

namespace fs = std::filesystem;

/// A number of [study] or [objective] that only calibrations have; parser, messages and echo follow from it.
struct NumberKey {
    const char *name, *limits, *meaning;
    double lowest, highest;
    bool whole;
    std::function<double&(CalibrationSpec&)> member;
    std::function<std::string(const CalibrationSpec&)> write;
};

const std::vector<NumberKey>& number_keys() {
    static const std::vector<NumberKey> k_keys{
        {"study.refine",
         "0 to 100000",
         "Members on the scenes' own cells, drawn where the coarse ones explain the surveys; 0 with coarse = 1: the "
         "first members themselves are the posterior.",
         0,
         1e5,
         true,
         {},
         [](const CalibrationSpec& c) { return std::to_string(c.refine); }},
        {"study.coarse", "1 to 16", "Cell size of the first members, in units of the scene's.", 1, 16, false,
         [](CalibrationSpec& c) -> double& { return c.coarse; },
         [](const CalibrationSpec& c) { return shortest_text(c.coarse); }},
        {"objective.exponent", "greater than 0.1, up to 1000",
         "N of the likelihood (misfit)^-N of an event: the number of independent pieces of information in its survey.",
         0.1, 1000, false, [](CalibrationSpec& c) -> double& { return c.exponent; },
         [](const CalibrationSpec& c) { return shortest_text(c.exponent); }}};
    return k_keys;
}

/// Values observed at gauges: "arrival bridge = 35".
struct GaugeKind {
    const char *word, *unit;
    std::vector<GaugeValue> EventSpec::*values;
};
constexpr GaugeKind k_gauge_kinds[] = {
    {"arrival", "s", &EventSpec::arrival}, {"speed", "m/s", &EventSpec::speed}, {"depth", "m", &EventSpec::depth}};

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
class CalibrationReader {
  public:
    explicit CalibrationReader(CalibrationReading& reading, std::string folder)
        : reading_(reading), folder_(std::move(folder)) {}

    void read(const std::vector<IniEntry>& entries);

  private:
    void add(const IniEntry& entry);
    void add_scenes(const IniEntry& entry);
    void add_event(const std::string& name, const std::string& scene, const IniEntry& entry);
    void add_weight(const std::string& name, const IniEntry& entry);
    void add_observation(const std::string& event, const std::string& key, const IniEntry& entry);
    bool add_number(const IniEntry& entry);
    void read_members();
    void read_event(EventSpec& event);
    void check();
    [[nodiscard]] EventSpec* event_of(const std::string& name);
    void refuse(const std::string& what, const IniEntry& entry, const std::string& limit, const std::string& remedy) {
        reading_.problems.add({what, reading_.where(entry.name), entry.value, limit, remedy});
    }

    CalibrationReading& reading_;
    std::string folder_;
    std::set<std::string> seen_;
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
        scenes_[name] = absolute_path(scene, folder_);
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
        add_event(event_name(absolute_path(scene, folder_)), scene, entry);
    }
}

bool CalibrationReader::add_number(const IniEntry& entry) {
    for (const NumberKey& key : number_keys()) {
        if (entry.name != key.name) continue;
        const auto value = number_from_text(entry.value);
        if (!value || (key.whole && *value != std::floor(*value)))
            refuse(key.whole ? "is not a whole number" : "is not a number", entry, key.limits, "");
        else if (!(*value >= key.lowest && *value <= key.highest))
            refuse("is out of range", entry, key.limits, "");
        else if (key.member)
            key.member(reading_.calibration) = *value;
        else
            reading_.calibration.refine = static_cast<std::int64_t>(*value);
        return true;
    }
    return false;
}

void CalibrationReader::add_weight(const std::string& name, const IniEntry& entry) {
    std::vector<std::string> names{"exponent"};
    for (const MeasureRow& row : k_measures) {
        names.emplace_back(row.name);
        if (name != row.name) continue;
        const auto weight = number_from_text(entry.value);
        if (!weight || !(*weight >= 0 && *weight <= 1e6))
            refuse("is not a weight", entry, "0 to 1000000", "");
        else if (*weight > 0)
            reading_.calibration.objective.push_back({row.measure, *weight});
        return;
    }
    const std::string nearest = nearest_name(name, names);
    refuse("unknown measure", entry, joined(names, ", "), nearest.empty() ? "" : "Did you mean " + nearest + "?");
}

void CalibrationReader::add_observation(const std::string& event, const std::string& key, const IniEntry& entry) {
    EventSpec* const spec = event_of(event);
    if (spec == nullptr) {
        refuse("there is no event " + event, entry, "", "Give it a scene: [event " + event + "] scene = FILE");
        return;
    }
    const auto value = number_from_text(entry.value);
    const std::size_t space = key.find(' ');
    const std::string word = key.substr(0, space), gauge = space == std::string::npos ? "" : trimmed(key.substr(space));
    const auto kind = std::find_if(std::begin(k_gauge_kinds), std::end(k_gauge_kinds),
                                   [&](const GaugeKind& one) { return one.word == word; });
    const bool at_gauge = kind != std::end(k_gauge_kinds) && !gauge.empty();
    if (key != "runout" && !at_gauge)
        refuse("unknown key", entry, "",
               "An event has scene, runout, and at gauges of its scene arrival GAUGE, speed GAUGE, depth GAUGE");
    else if (!value || !(*value > 0 && *value < 1e9))
        refuse("is not a number greater than 0", entry, at_gauge ? std::string("in ") + kind->unit : "in m", "");
    else if (at_gauge)
        (spec->*(kind->values)).push_back({gauge, *value});
    else
        spec->runout = *value;
}

void CalibrationReader::add(const IniEntry& entry) {
    if (!seen_.insert(entry.name).second) {
        refuse("is given more than once", entry, "", "Keep one of the lines");
        return;
    }
    if (entry.value.empty()) {
        refuse("has no value", entry, "", "Give one or remove the key");
        return;
    }
    const auto dot = entry.name.find('.');
    const std::string head = entry.name.substr(0, dot),
                      rest = dot == std::string::npos ? "" : entry.name.substr(dot + 1);
    const auto space = head.find(' ');
    const std::string section = head.substr(0, space),
                      event = space == std::string::npos ? "" : trimmed(head.substr(space));
    static const std::set<std::string> k_of_ensembles{"study.until", "study.keep", "study.levels"};
    if (rest.empty()) return refuse("unknown key", entry, "", k_sections);
    if (event.empty() && k_of_ensembles.count(entry.name) > 0)
        return refuse("has no effect in a calibration", entry, "", "Remove it");
    if (entry.name == "study.scene") return add_scenes(entry);
    if (add_number(entry)) return;
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
                refuse("there is no event " + event, entry, "", "Give it a scene: [event " + event + "] scene = FILE");
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
    Problems& problems = reading_.problems;
    const bool names_scene = std::any_of(seen_.begin(), seen_.end(), [](const std::string& name) {
        return name == "study.scene" || (name.starts_with("event ") && name.ends_with(".scene"));
    });
    if (!names_scene)
        problems.add({"is missing", reading_.where("study.scene"), "", "scene files",
                      "Name the scene of each event, with its [observed]"});
    if (calibration.objective.empty() && std::none_of(seen_.begin(), seen_.end(), [](const std::string& name) {
            return name.starts_with("objective.") && name != "objective.exponent";
        }))
        problems.add({"has no measure", reading_.where("objective"), "", "",
                      "Say what is compared with the surveys: [objective] jaccard = 1"});
    else if (calibration.objective.empty())
        problems.add({"has no weight greater than 0", reading_.where("objective"), "", "", "Give a measure a weight"});
    const Sampling sampling = calibration.study.sampling;
    if (!calibration.events.empty() &&
        (sampling == Sampling::grid || sampling == Sampling::saltelli || sampling == Sampling::table))
        problems.add({"is not for calibrations", reading_.where("study.sampling"), name_of(sampling),
                      "sobol, latin-hypercube, random", "Choose one of these"});
    if (calibration.refine == 0 && calibration.coarse != 1)
        problems.add({"leaves no member on the scenes' own cells", reading_.where("study.refine"), "0", "",
                      "Write coarse = 1, or refine = 100"});
}

void CalibrationReader::read(const std::vector<IniEntry>& entries) {
    for (const IniEntry& entry : entries) add(entry);
    for (const auto& [event, entry] : observed_)
        add_observation(event, entry.name.substr(entry.name.find('.') + 1), entry);
    read_members();
    check();
}

std::string events_text(const EventSpec& event) {
    std::string text = "\n[event " + event.name + "]\nscene = " + event.members.study.scene + "\n";
    if (event.runout) text += "runout = " + shortest_text(*event.runout) + "\n";
    for (const GaugeKind& kind : k_gauge_kinds)
        for (const GaugeValue& one : event.*(kind.values))
            text += std::string(kind.word) + " " + one.gauge + " = " + shortest_text(one.value) + "\n";
    return text + settings_text("set " + event.name, event.set) + variations_text("vary " + event.name, event.vary);
}

}  // namespace

bool is_calibration(const std::string& path) {
    const std::vector<IniEntry> entries = read_ini(path);
    return std::any_of(entries.begin(), entries.end(), [](const IniEntry& entry) {
        return entry.name.starts_with("objective.") || entry.name.starts_with("event ");
    });
}

CalibrationReading read_calibration(const std::string& path) {
    CalibrationReading reading;
    reading.label = path;
    const fs::path absolute = fs::absolute(path).lexically_normal();
    CalibrationReader(reading, absolute.parent_path().string()).read(read_ini(path));
    return reading;
}

std::string calibration_text(const CalibrationSpec& calibration) {
    const StudySpec& study = calibration.study;
    std::string text = "# A calibration as used; `frana calibrate` on this file repeats it.\n\n[study]\n";
    text += "samples = " + std::to_string(study.samples) + "\nsampling = " + name_of(study.sampling) +
            "\nseed = " + std::to_string(study.seed) + "\n";
    std::string objective = "\n[objective]\n";
    for (const NumberKey& key : number_keys()) {
        const std::string name = key.name, of_section = name.substr(name.find('.') + 1);
        (name.starts_with("study.") ? text : objective) += std::string("# ") + key.meaning + " Values: " + key.limits +
                                                           ".\n" + of_section + " = " + key.write(calibration) + "\n";
    }
    for (const MeasureRow& row : k_measures) {
        const auto found = std::find_if(calibration.objective.begin(), calibration.objective.end(),
                                        [&](const Weight& one) { return one.measure == row.measure; });
        objective += std::string("# ") + row.formula + "\n";
        objective += found == calibration.objective.end() ? std::string("# ") + row.name + " =\n"
                                                          : row.name + (" = " + shortest_text(found->weight)) + "\n";
    }
    text += objective + settings_text("set", study.set) + variations_text("vary", study.vary);
    if (!study.correlate.empty()) text += "\n[correlate]\n";
    for (const Correlation& one : study.correlate)
        text += one.first + " " + one.second + " = " + shortest_text(one.rho) + "\n";
    for (const EventSpec& event : calibration.events) text += events_text(event);
    return text;
}

}  // namespace frana::study
