// SPDX-License-Identifier: Apache-2.0
#include "study/read_region.h"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <set>

#include "core/text.h"
#include "params/grammar/value_text.h"
#include "params/keys/parameter.h"
#include "params/keys/scene_parameters.h"
#include "study/sampling.h"

namespace frana::study {
namespace {

/// A key of [region] or [degree] that studies do not have; the parser, the messages and the echo follow from it.
struct RegionKey {
    std::string name, limits, meaning;
    std::function<std::optional<ValueProblem>(RegionSpec&, const std::string& text)> read;
    std::function<std::optional<std::string>(const RegionSpec&)> write;
};

/// Keys that are those of a study, under another section.
constexpr std::pair<const char*, const char*> k_study_keys[] = {{"region.scene", "study.scene"},
                                                                {"region.keep", "study.keep"}};

constexpr double k_widest_window = 1e6;

RegionKey column_key(const char* name, const char* meaning, std::optional<std::string> RegionSpec::*member) {
    return {std::string("region.") + name, "a column of release.perimeter", meaning,
            [member](RegionSpec& region, const std::string& text) -> std::optional<ValueProblem> {
                region.*member = text;
                return std::nullopt;
            },
            [member](const RegionSpec& region) { return region.*member; }};
}

RegionKey window_key() {
    return {"region.window", "auto, or metres from 1 to 1000000",
            "Terrain of a slope: that under its energy line (auto), or so many metres round its polygon.",
            [](RegionSpec& region, const std::string& text) -> std::optional<ValueProblem> {
                region.window.reset();
                if (text == "auto") return std::nullopt;
                const auto metres = number_from_text(text);
                if (!metres) return ValueProblem{"is neither auto nor a number", ""};
                if (!(*metres >= 1 && *metres <= k_widest_window)) return ValueProblem{"is out of range", ""};
                region.window = metres;
                return std::nullopt;
            },
            [](const RegionSpec& region) -> std::optional<std::string> {
                return region.window ? shortest_text(*region.window) : "auto";
            }};
}

RegionKey periods_key() {
    return {"degree.return-periods", "three rising numbers greater than 0",
            "Longest return periods of high, medium and low probability in years; rarer is a residual hazard.",
            [](RegionSpec& region, const std::string& text) -> std::optional<ValueProblem> {
                const std::vector<std::string> words = words_of(text);
                if (words.size() != k_probabilities)
                    return ValueProblem{"has " + std::to_string(words.size()) + " values", "Write 30, 100, 300"};
                double before = 0;
                for (std::size_t i = 0; i < words.size(); ++i) {
                    const auto years = number_from_text(words[i]);
                    if (!years || !(*years > before)) return ValueProblem{"does not rise from above 0", ""};
                    before = region.degrees.periods[i] = *years;
                }
                return std::nullopt;
            },
            [](const RegionSpec& region) -> std::optional<std::string> {
                std::vector<std::string> words;
                for (const double years : region.degrees.periods) words.push_back(shortest_text(years));
                return joined(words, ", ");
            }};
}

RegionKey degrees_key(int intensity) {
    const auto row = static_cast<std::size_t>(intensity - 1);
    return {"degree." + intensity_name(intensity), "three of red, blue, yellow, yellow-white",
            "Degrees of hazard for " + intensity_name(intensity) + " intensity with high, medium and low probability.",
            [row](RegionSpec& region, const std::string& text) -> std::optional<ValueProblem> {
                const std::vector<std::string> words = words_of(text);
                if (words.size() != k_probabilities)
                    return ValueProblem{"has " + std::to_string(words.size()) + " values", ""};
                for (std::size_t i = 0; i < words.size(); ++i) {
                    const auto degree = degree_from(words[i]);
                    if (!degree) return ValueProblem{"'" + words[i] + "' is no degree", ""};
                    region.degrees.degrees[row][i] = *degree;
                }
                return std::nullopt;
            },
            [row](const RegionSpec& region) -> std::optional<std::string> {
                std::vector<std::string> words;
                for (const HazardDegree degree : region.degrees.degrees[row]) words.push_back(name_of(degree));
                return joined(words, ", ");
            }};
}

const std::vector<RegionKey>& region_keys() {
    static const std::vector<RegionKey> k_keys{
        column_key("name", "What each slope is called.", &RegionSpec::name),
        column_key("group", "What each slope belongs to: a catchment, a commune.", &RegionSpec::group),
        column_key("scenario", "Which of several events each polygon is; each has maps of its own.",
                   &RegionSpec::scenario),
        column_key("return-period", "Return period in years, for the degree of hazard.", &RegionSpec::return_period),
        window_key(),
        periods_key(),
        degrees_key(3),
        degrees_key(2),
        degrees_key(1)};
    return k_keys;
}

/// Reads what only regions have; the other entries are left for the reader of studies.
class RegionReader {
  public:
    RegionReader(const std::string& label, RegionSpec& region, Problems& problems)
        : label_(label), region_(region), problems_(problems), parameters_(scene_parameters()) {}

    /// Returns the entry of a study that it stands for; none: it was read.
    std::optional<IniEntry> add(const IniEntry& entry) {
        for (const auto& [own, of_study] : k_study_keys)
            if (entry.name == own) return IniEntry{of_study, entry.value};
        if (entry.name.starts_with("set.")) return entry;
        if (!seen_.insert(entry.name).second)
            refuse("is given more than once", entry, "", "Keep one of the lines");
        else if (entry.value.empty())
            refuse("has no value", entry, "", "Give one or remove the key");
        else if (entry.name.starts_with("columns."))
            add_column(entry);
        else
            add_own(entry);
        return std::nullopt;
    }

  private:
    void add_own(const IniEntry& entry) {
        std::vector<std::string> names;
        for (const auto& [own, of_study] : k_study_keys) names.emplace_back(own);
        for (const RegionKey& key : region_keys()) {
            names.push_back(key.name);
            if (entry.name != key.name) continue;
            if (const auto refusal = key.read(region_, entry.value))
                refuse(refusal->what, entry, key.limits, refusal->remedy);
            return;
        }
        const std::string nearest = nearest_name(entry.name, names);
        refuse("unknown key", entry, "",
               nearest.empty()
                   ? "A region has the sections [region], [set], [columns] and [degree], with " + joined(names, ", ")
                   : "Did you mean " + nearest + "?");
    }
    void add_column(const IniEntry& entry) {
        const std::string name = present_name(entry.name.substr(entry.name.find('.') + 1));
        const Parameter* const parameter = find_parameter(parameters_, name);
        if (parameter == nullptr) {
            const std::string nearest = nearest_name(name, names_of(parameters_));
            refuse("unknown key of the scene", entry, "",
                   nearest.empty() ? "`frana params` lists all keys" : "Did you mean " + nearest + "?");
        } else if (name.starts_with("release.perimeter")) {
            refuse("cannot differ from slope to slope", entry, "", "Each slope has one polygon of the perimeter");
        } else if (const auto refusal = refusal_to_vary(*parameter)) {
            refuse(refusal->what, entry, "", refusal->remedy);
        } else {
            region_.columns.push_back({name, entry.value});
        }
    }
    void refuse(const std::string& what, const IniEntry& entry, const std::string& limit, const std::string& remedy) {
        problems_.add({what, label_ + ": " + entry.name, entry.value, limit, remedy});
    }

    std::string label_;
    RegionSpec& region_;
    Problems& problems_;
    const std::vector<Parameter>& parameters_;
    std::set<std::string> seen_;
};

void check(const StudyReading& reading, Problems& problems) {
    const RegionSpec& region = *reading.study.region;
    for (const RegionSpec::Column& one : region.columns)
        for (const std::string& set : reading.study.set)
            if (set.starts_with(one.key + "="))
                problems.add({"is also set for all slopes", reading.where("columns." + one.key), "", "",
                              "Keep it in one of [set] and [columns]"});
}

}  // namespace

bool is_region(const std::string& path) {
    const std::vector<IniEntry> entries = read_ini(path);
    return std::any_of(entries.begin(), entries.end(),
                       [](const IniEntry& entry) { return entry.name.starts_with("region."); });
}

StudyReading read_region(const std::string& path) {
    RegionSpec region;
    Problems problems;
    std::vector<IniEntry> entries{{"study.per-polygon", "on"}};
    RegionReader reader(path, region, problems);
    for (const IniEntry& entry : read_ini(path))
        if (auto of_study = reader.add(entry)) entries.push_back(*of_study);
    StudyReading reading = read_study_entries(entries, path);
    for (Problem problem : reading.problems.list()) {
        const auto place = problem.where.find(": study.");
        if (place != std::string::npos) problem.where.replace(place + 2, 5, "region");
        problems.add(problem);
    }
    reading.study.region = std::move(region);
    check(reading, problems);
    reading.problems = std::move(problems);
    return reading;
}

std::string region_text(const StudySpec& study) {
    std::string text =
        "# A region as used; `frana batch` on this file repeats it.\n\n[region]\n# The scene of every slope.\nscene "
        "= " +
        study.scene + "\nkeep = " +
        (study.keep == Keep::none  ? "none"
         : study.keep == Keep::all ? "all"
                                   : "failed") +
        "\n";
    bool in_degree = false;
    for (const RegionKey& key : region_keys()) {
        const auto dot = key.name.find('.');
        if (key.name.starts_with("degree.") && !std::exchange(in_degree, true)) text += "\n[degree]\n";
        const auto value = key.write(*study.region);
        text += "# " + key.meaning + " Values: " + key.limits + ".\n";
        text += (value ? "" : "# ") + key.name.substr(dot + 1) + " =" + (value ? " " + *value : "") + "\n";
    }
    text += settings_text("set", study.set);
    if (!study.region->columns.empty()) text += "\n[columns]\n";
    for (const RegionSpec::Column& one : study.region->columns) text += one.key + " = " + one.column + "\n";
    return text;
}

}  // namespace frana::study
