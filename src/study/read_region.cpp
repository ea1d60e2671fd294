// SPDX-License-Identifier: Apache-2.0
#include "study/read_region.h"

#include "core/text.h"
#include "params/grammar/value_text.h"
#include "params/keys/declare.h"
#include "params/keys/parameter.h"
#include "study/entry_reader.h"
#include "study/sampling.h"

namespace frana::study {
namespace {

using RegionKey = ParameterOf<RegionSpec>;

/// Keys that are those of a study, under another section.
constexpr std::pair<const char*, const char*> k_study_keys[] = {{"region.scene", "study.scene"},
                                                                {"region.keep", "study.keep"}};

constexpr std::int64_t k_widest_window = 1'000'000;

template <class Member>
RegionKey column_key(const char* name, Member member, const char* meaning) {
    auto key = declare::text<RegionSpec>(name, member, "text", meaning);
    key.limits = "a column of release.perimeter";
    return key;
}

RegionKey window_key() {
    auto key = declare::number<RegionSpec>(
        "region.window", FRANA_MEMBER(window), "m", NumberRange{1, static_cast<double>(k_widest_window)},
        "Terrain of a slope: that under its energy line (auto), or so many metres round its polygon.");
    key.limits = "auto, or metres from 1 to " + std::to_string(k_widest_window);
    key.read = [of_number = key.read, reset = key.reset](RegionSpec& region, const std::string& text) {
        if (text != "auto") return of_number(region, text);
        reset(region);
        return std::optional<ValueProblem>();
    };
    key.write = [of_number = key.write](const RegionSpec& region) { return of_number(region).value_or("auto"); };
    return key;
}

/// One value for each probability of an event; `from_word` stores one or returns why not.
template <class Member, class FromWord, class ToWord>
RegionKey by_probability(const std::string& name, Member member, const std::string& limits, const std::string& example,
                         const std::string& meaning, FromWord from_word, ToWord to_word) {
    auto key = declare::parameter<RegionSpec>(
        name, "list", member,
        [example, from_word](auto& target, const std::string& text) -> std::optional<ValueProblem> {
            const std::vector<std::string> words = words_of(text);
            if (words.size() != k_probabilities)
                return ValueProblem{"has " + std::to_string(words.size()) + " values", example};
            auto values = target;
            for (std::size_t i = 0; i < words.size(); ++i)
                if (const auto problem = from_word(words[i], i, values)) return problem;
            target = values;
            return std::nullopt;
        },
        [to_word](const auto& values) {
            std::vector<std::string> words;
            for (const auto& value : values) words.push_back(to_word(value));
            return joined(words, ", ");
        });
    key.limits = limits;
    key.meaning = meaning;
    return key;
}

RegionKey periods_key() {
    return by_probability(
        "degree.return-periods", FRANA_MEMBER(degrees.periods), "three rising numbers greater than 0",
        "Write 30, 100, 300",
        "Longest return periods of high, medium and low probability in years; rarer is a residual hazard.",
        [](const std::string& word, std::size_t i, auto& values) -> std::optional<ValueProblem> {
            const auto years = number_from_text(word);
            if (!years || !(*years > (i == 0 ? 0 : values[i - 1])))
                return ValueProblem{"does not rise from above 0", ""};
            values[i] = *years;
            return std::nullopt;
        },
        shortest_text);
}

RegionKey degrees_key(int intensity) {
    const auto row = static_cast<std::size_t>(intensity - 1);
    return by_probability(
        "degree." + intensity_name(intensity), [row](auto& region) -> auto& { return region.degrees.degrees[row]; },
        "three of red, blue, yellow, yellow-white", "",
        "Degrees of hazard for " + intensity_name(intensity) + " intensity with high, medium and low probability.",
        [](const std::string& word, std::size_t i, auto& values) -> std::optional<ValueProblem> {
            const auto degree = degree_from(word);
            if (!degree) return ValueProblem{"'" + word + "' is no degree", ""};
            values[i] = *degree;
            return std::nullopt;
        },
        [](HazardDegree degree) { return name_of(degree); });
}

/// Keys of [region] and [degree] that studies do not have; the parser, the messages and the echo follow from them.
const std::vector<RegionKey>& region_keys() {
    static const std::vector<RegionKey> k_keys{
        column_key("region.name", FRANA_MEMBER(name), "What each slope is called."),
        column_key("region.group", FRANA_MEMBER(group), "What each slope belongs to: a catchment, a commune."),
        column_key("region.scenario", FRANA_MEMBER(scenario),
                   "Which of several events each polygon is; each has maps of its own."),
        column_key("region.return-period", FRANA_MEMBER(return_period),
                   "Return period in years, for the degree of hazard."),
        window_key(),
        periods_key(),
        degrees_key(3),
        degrees_key(2),
        degrees_key(1)};
    return k_keys;
}

/// Reads what only regions have; the other entries are left for the reader of studies.
class RegionReader : private EntryReader {
  public:
    RegionReader(const std::string& label, RegionSpec& region, Problems& problems)
        : EntryReader(label, "", problems), region_(region) {}

    /// Returns the entry of a study that it stands for; none: it was read.
    std::optional<IniEntry> add(const IniEntry& entry) {
        for (const auto& [own, of_study] : k_study_keys)
            if (entry.name == own) return IniEntry{of_study, entry.value};
        if (entry.name.starts_with("set.")) return entry;
        if (!is_good(entry)) return std::nullopt;
        if (entry.name.starts_with("columns.")) {
            add_column(entry);
        } else if (!read(region_keys(), entry, region_)) {
            std::vector<std::string> names = names_of(region_keys());
            for (const auto& [own, of_study] : k_study_keys) names.emplace_back(own);
            refuse_name(
                "unknown key", entry.name, names,
                "A region has the sections [region], [set], [columns] and [degree], with " + joined(names, ", "),
                entry);
        }
        return std::nullopt;
    }

  private:
    void add_column(const IniEntry& entry) {
        const std::string name = present_name(entry.name.substr(entry.name.find('.') + 1));
        const Parameter* const parameter = scene_key(name, entry);
        if (parameter == nullptr) return;
        if (name.starts_with("release.perimeter"))
            refuse("cannot differ from slope to slope", entry, "", "Each slope has one polygon of the perimeter");
        else if (const auto refusal = refusal_to_vary(*parameter))
            refuse(refusal->what, entry, "", refusal->remedy);
        else
            region_.columns.push_back({name, entry.value});
    }

    RegionSpec& region_;
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
    return has_section(path, "region.");
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
        study.scene + "\nkeep = " + name_of(study.keep) + "\n" + keys_text(region_keys(), *study.region, "region") +
        "\n[degree]\n" + keys_text(region_keys(), *study.region, "degree") + settings_text("set", study.set);
    if (!study.region->columns.empty()) text += "\n[columns]\n";
    for (const RegionSpec::Column& one : study.region->columns) text += one.key + " = " + one.column + "\n";
    return text;
}

}  // namespace frana::study
