// SPDX-License-Identifier: Apache-2.0
#include "app/study/plan/read_study.h"

#include "app/study/plan/entry_reader.h"
#include "app/study/plan/sampling.h"
#include "core/text.h"
#include "params/grammar/value_text.h"
#include "params/keys/declare.h"
#include "params/keys/parameter.h"

namespace frana::app::study {
namespace {

using RegionKey = ParameterOf<StudySpec>;

constexpr std::int64_t k_widest_window = 1'000'000;

RegionSpec& region_of(StudySpec& study) {
    if (!study.region) study.region.emplace();
    return *study.region;
}
const RegionSpec& region_of(const StudySpec& study) {
    static const RegionSpec k_none;
    return study.region ? *study.region : k_none;
}
/// A member of the study's region.
template <class Member>
auto of_region(Member member) {
    return [member](auto& study) -> auto& {
        return member(region_of(study));
    };
}

template <class Member>
RegionKey column_key(const char* name, Member member, const char* meaning) {
    auto key = declare::text<StudySpec>(name, of_region(member), "text", meaning);
    key.limits = "a column of release.perimeter";
    return key;
}

RegionKey window_key() {
    auto key = declare::number<StudySpec>(
        "region.window", of_region(FRANA_MEMBER(window)), "m", NumberRange{1, static_cast<double>(k_widest_window)},
        "Terrain of a slope: that under its energy line (auto), or so many metres round its polygon.");
    key.limits = "auto, or metres from 1 to " + std::to_string(k_widest_window);
    key.read = [of_number = key.read](StudySpec& study, const std::string& text) {
        if (text != "auto") return of_number(study, text);
        study.region->window.reset();
        return std::optional<ValueProblem>();
    };
    key.write = [of_number = key.write](const StudySpec& study) { return of_number(study).value_or("auto"); };
    return key;
}

/// One value for each probability of an event; `from_word` stores one or returns why not.
template <class Member, class FromWord, class ToWord>
RegionKey by_probability(const std::string& name, Member member, const std::string& limits, const std::string& example,
                         const std::string& meaning, FromWord from_word, ToWord to_word) {
    auto key = declare::parameter<StudySpec>(
        name, "list", of_region(member),
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

}  // namespace

const std::vector<RegionKey>& region_keys() {
    static const std::vector<RegionKey> k_keys{
        study_key("scene", "region", "The scene of every slope."),
        study_key("scheme", "region"),
        study_key("keep", "region"),
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

std::string region_text(const StudySpec& study) {
    std::string text = "# A region as used; `frana batch` on this file repeats it.\n\n[region]\n" +
                       keys_text(region_keys(), study, "region") + "\n[degree]\n" +
                       keys_text(region_keys(), study, "degree") + settings_text("set", study.set);
    if (!study.region->columns.empty()) text += "\n[columns]\n";
    for (const RegionSpec::Column& one : study.region->columns) text += one.key + " = " + one.column + "\n";
    return text;
}

}  // namespace frana::app::study
