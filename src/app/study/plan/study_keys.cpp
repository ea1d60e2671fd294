// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <initializer_list>
#include <map>
#include <utility>
#include <variant>

#include "app/study/plan/read_study.h"
#include "app/text/number_text.h"
#include "core/text.h"
#include "params/grammar/value_text.h"
#include "params/keys/declare.h"
#include "params/keys/parameter.h"
#include "params/keys/scene_parameters.h"

namespace frana::app::study {
namespace {

using StudyKey = ParameterOf<StudySpec>;

constexpr const char* k_table_word = "table:";

/// Samplings of earlier versions, and what to use.
constexpr std::pair<const char*, const char*> k_gone_samplings[] = {
    {"latin-hypercube", "Write sampling = sobol: it is at least as certain with as many runs"},
    {"grid", "Write sampling = sobol, or table:FILE.csv with the combinations as rows"},
    {"saltelli", "Write sampling = sobol: its sensitivities need 64 runs, not thousands"}};

/// The first members of a calibration are a sample, which others follow.
StudyKey sampling_key(StudyKind kind) {
    declare::Words<Sampling> words;
    for (const SamplingMethod& row : k_samplings)
        if (row.kind == SamplingMethod::Kind::sample ||
            (row.kind == SamplingMethod::Kind::design && kind == StudyKind::ensemble))
            words.emplace_back(row.name, row.sampling);
    auto key = declare::option<StudySpec>("study.sampling", FRANA_MEMBER(sampling), words,
                                          "How the values of the members are drawn.");
    const bool has_tables = kind == StudyKind::ensemble;
    if (has_tables) key.limits += std::string(", ") + k_table_word + "FILE.csv";
    key.read = [has_tables, of_word = key.read](StudySpec& study,
                                                const std::string& text) -> std::optional<ValueProblem> {
        for (const auto& [gone, instead] : k_gone_samplings)
            if (text == gone) return ValueProblem{"is no longer a sampling", instead};
        if (!has_tables || !text.starts_with(k_table_word)) return of_word(study, text);
        const std::string file = trimmed(text.substr(std::string(k_table_word).size()));
        if (file.empty()) return ValueProblem{"names no file", "Write table:FILE.csv"};
        study.sampling = Sampling::table;
        study.table = file;
        return std::nullopt;
    };
    key.write = [of_word = key.write](const StudySpec& study) -> std::optional<std::string> {
        return study.sampling == Sampling::table ? k_table_word + study.table : of_word(study);
    };
    key.map_files = [](StudySpec& study, const FileMap& map) {
        if (!study.table.empty()) study.table = map(study.table);
    };
    return key;
}

StudyKey samples_key(const std::string& section, StudyKind kind) {
    StudyKey samples = declare::integer<StudySpec>(
        section + "samples", FRANA_MEMBER(samples), 2, k_most_samples,
        kind == StudyKind::region ? "Members of each slope, of a region with a frequency."
                                  : "Number of members; with until, and of a calibration, the most.");
    samples.write = [write = samples.write](const StudySpec& study) {
        return study.sampling == Sampling::table ? std::nullopt : write(study);
    };
    return samples;
}

/// A member of the study's region.
template <class Member>
auto of_region(Member member) {
    return [member](auto& study) -> auto& {
        if constexpr (std::is_const_v<std::remove_reference_t<decltype(study)>>) {
            static const RegionSpec k_none;
            return member(study.region ? *study.region : k_none);
        } else {
            return member(study.region ? *study.region : study.region.emplace());
        }
    };
}

template <class Member>
StudyKey column_key(const char* name, Member member, const char* meaning) {
    auto key = declare::text<StudySpec>(name, of_region(member), "text", meaning);
    key.limits = "a column of release.perimeter";
    return key;
}

/// The weight of a measure; what is not compared has none.
StudyKey weight_key(const MeasureRow& row) {
    const auto weight = [measure = row.measure](auto& study) -> auto& {
        const auto found = std::find_if(study.objective.begin(), study.objective.end(),
                                        [&](const Weight& one) { return one.measure == measure; });
        if constexpr (std::is_const_v<std::remove_reference_t<decltype(study)>>) {
            static const double k_none = 0;
            return found == study.objective.end() ? k_none : found->weight;
        } else {
            return found == study.objective.end() ? study.objective.emplace_back(Weight{measure, 0}).weight
                                                  : found->weight;
        }
    };
    return declare::number<StudySpec>(std::string("objective.") + row.name, weight, "", NumberRange{0, 1e6},
                                      row.formula);
}

std::string text_with_deviation(double value, double deviation) {
    return shortest_text(value) + (deviation > 0 ? " +- " + shortest_text(deviation) : "");
}

constexpr double k_most_rate = 5, k_most_years = 1e6;  // a year; beyond, nobody knows
constexpr double k_most_deviation = 3;                 // of the rate: a decimal point in the wrong place

StudyKey rate_key() {
    const auto read = [](auto& target, const std::string& text) -> std::optional<ValueProblem> {
        const auto [rate, deviation] = number_and_deviation(text);
        if (!(rate > 0))
            return ValueProblem{"is not a number of events a year", "Write for example 0.05 or 0.05 +- 0.02"};
        if (!(rate <= k_most_rate))
            return ValueProblem{
                "is more than " + shortest_text(k_most_rate) + " events a year",
                "Of an event once in " + shortest_text(rate) + " years write " + shortest_text(1 / rate)};
        if (!(deviation <= k_most_deviation * rate))
            return ValueProblem{"has a standard deviation that is not a number of events a year, or more than " +
                                    shortest_text(k_most_deviation) + " times the rate",
                                "Write for example 0.05 +- 0.02"};
        target = FrequencySpec::Rate{rate, deviation};
        return std::nullopt;
    };
    auto key = declare::parameter<StudySpec>(
        "frequency.rate", "text", FRANA_MEMBER(frequency.rate), read,
        [](const FrequencySpec::Rate& rate) { return text_with_deviation(rate.value, rate.deviation); });
    key.limits = "greater than 0, at most " + shortest_text(k_most_rate) + ", perhaps +- its standard deviation";
    key.meaning = "Events a year, at or above the least volume.";
    return key;
}

/// The numbers of "a, b, c" or of "a: x, b: y", each greater than the one before it.
std::variant<std::vector<std::pair<double, double>>, ValueProblem> rising_numbers(const std::string& text,
                                                                                  bool in_pairs,
                                                                                  const std::string& example) {
    const ValueProblem unreadable{"is not of the form " + example, ""};
    std::vector<std::pair<double, double>> all;
    for (std::size_t begin = 0, end = 0; end != std::string::npos; begin = end + 1) {
        end = text.find(',', begin);
        const std::string part = text.substr(begin, end == std::string::npos ? end : end - begin);
        const std::size_t colon = part.find(':');
        if ((colon != std::string::npos) != in_pairs) return unreadable;
        const auto first = number_from_text(trimmed(part.substr(0, colon))),
                   second = in_pairs ? number_from_text(trimmed(part.substr(colon + 1))) : first;
        if (!first || !second || !(*first > 0 && *second > 0)) return unreadable;
        if (!all.empty() && !(*first > all.back().first && *second > all.back().second))
            return ValueProblem{"does not rise at " + trimmed(part),
                                in_pairs ? "A larger volume has a longer return period" : ""};
        all.emplace_back(*first, *second);
    }
    return all;
}

StudyKey volumes_key() {
    const auto read = [](auto& target, const std::string& text) -> std::optional<ValueProblem> {
        const auto numbers = rising_numbers(text, true, "8000: 20, 15000: 100");
        if (const auto* problem = std::get_if<ValueProblem>(&numbers)) return *problem;
        std::vector<FrequencySpec::Volume> volumes;
        for (const auto& [volume, years] : std::get<0>(numbers)) volumes.push_back({volume, years});
        if (!(volumes.front().years >= 1 / k_most_rate && volumes.back().years <= k_most_years &&
              volumes.back().volume <= 1e12))
            return ValueProblem{"is out of range", "Write each volume [m3] with its return period [years]"};
        target = volumes;
        return std::nullopt;
    };
    const auto write = [](const std::vector<FrequencySpec::Volume>& volumes) {
        // Maps show it: 300000, not 3e+05.
        const auto plain = [](double value) {
            return value == std::floor(value) ? std::to_string(std::llround(value)) : shortest_text(value);
        };
        std::string text;
        for (const FrequencySpec::Volume& one : volumes)
            text += (text.empty() ? "" : ", ") + plain(one.volume) + ": " + plain(one.years);
        return text;
    };
    auto key = declare::parameter<StudySpec>("frequency.volumes", "text", FRANA_MEMBER(frequency.volumes), read, write);
    key.limits = "VOLUME: YEARS, ...; both rise; volumes up to 1e12 m3, years from " + shortest_text(1 / k_most_rate) +
                 " to " + shortest_text(k_most_years);
    key.meaning = "Volumes of the release [m3] with the return periods [years] at which they are exceeded.";
    return key;
}

StudyKey return_periods_key() {
    const auto read = [](auto& target, const std::string& text) -> std::optional<ValueProblem> {
        const auto numbers = rising_numbers(text, false, "30, 100, 300");
        if (const auto* problem = std::get_if<ValueProblem>(&numbers)) return *problem;
        std::vector<double> years;
        for (const auto& [one, same] : std::get<0>(numbers)) years.push_back(one);
        if (years.back() > k_most_years) return ValueProblem{"is out of range", ""};
        target = years;
        return std::nullopt;
    };
    const auto write = [](const std::vector<double>& years) {
        std::string text;
        for (const double one : years) text += (text.empty() ? "" : ", ") + shortest_text(one);
        return text;
    };
    auto key = declare::parameter<StudySpec>("frequency.return-periods", "text", FRANA_MEMBER(frequency.return_periods),
                                             read, write);
    key.limits = "rising, up to " + shortest_text(k_most_years) + " years; without it 30, 100, 300";
    key.meaning = "Return periods of which there are maps.";
    return key;
}

std::vector<StudyKey> keys_of(StudyKind kind) {
    using enum StudyKind;
    const std::string section = kind == region ? "region." : "study.";
    std::vector<StudyKey> keys;
    const auto add = [&](std::initializer_list<StudyKind> kinds, StudyKey key) {
        if (std::find(kinds.begin(), kinds.end(), kind) != kinds.end()) keys.push_back(std::move(key));
    };
    StudyKey scene_file =
        declare::text<StudySpec>(section + "scene", FRANA_MEMBER(scene), "file",
                                 kind == region ? "The scene of every slope." : "The scene whose keys vary.");
    scene_file.limits = "a scene file";
    add({ensemble, region}, scene_file);
    add({ensemble, region, calibration},
        declare::option<StudySpec>(
            section + "scheme", FRANA_MEMBER(scheme),
            declare::Words<Scheme>{{"default", Scheme::standard}, {"finite-volume", Scheme::finite_volume}},
            "Numerical scheme of all members; without it that of the scene. Two members are computed "
            "again by the other one."));
    const auto if_drawn = [](StudyKey key) {
        key.write = [write = key.write](const StudySpec& study) {
            return study.sampling == Sampling::polygons ? std::nullopt : write(study);
        };
        return key;
    };
    add({ensemble, region, calibration}, if_drawn(samples_key(section, kind)));
    add({ensemble, calibration}, sampling_key(kind));
    add({ensemble, region, calibration},
        if_drawn(declare::integer<StudySpec>(section + "seed", FRANA_MEMBER(seed), 0, k_last_seed,
                                             "The same seed gives the same members.")));
    add({ensemble}, declare::text<StudySpec>("study.for", FRANA_MEMBER(rows), "text",
                                             "Which draws of a posterior.csv are taken: new-slope, this-event, or "
                                             "this-event NAME of several events.",
                                             "new-slope"));
    add({ensemble}, declare::text<StudySpec>("study.rare-place", FRANA_MEMBER(rare_place), "text",
                                             "A gauge of the scene (output.gauges): with sampling = importance most "
                                             "members are drawn near what makes the flow come there."));
    add({ensemble}, declare::number<StudySpec>("study.until", FRANA_MEMBER(until), "", NumberRange{0, 0.5, true, true},
                                               "Standard error of the probabilities, anywhere on the map, below which "
                                               "no more members are run."));
    add({ensemble, region}, declare::option<StudySpec>(section + "keep", FRANA_MEMBER(keep),
                                                       declare::Words<Keep>{{name_of(Keep::none), Keep::none},
                                                                            {name_of(Keep::failed), Keep::failed},
                                                                            {name_of(Keep::all), Keep::all}},
                                                       "Members whose scene and maps are written to members/."));
    for (const auto& key : {rate_key(), volumes_key(), return_periods_key()}) add({ensemble, region}, key);
    add({ensemble, region},
        declare::number<StudySpec>(
            "frequency.exponent-error", FRANA_MEMBER(frequency.exponent_error), "", NumberRange{0, 2, true, false},
            "Standard deviation of the exponent b by which the law of volumes falls: how often V "
            "is exceeded is as V^-b. None: the law is certain."));
    add({region}, column_key("region.name", FRANA_MEMBER(name), "What each slope is called."));
    add({region},
        column_key("region.group", FRANA_MEMBER(group), "What each slope belongs to: a catchment, a commune."));
    add({region}, column_key("region.scenario", FRANA_MEMBER(scenario),
                             "Which of several events each polygon is; each has maps of its own."));
    add({region}, column_key("region.return-period", FRANA_MEMBER(return_period),
                             "Return period in years, for the degree of hazard."));
    add({calibration},
        declare::number<StudySpec>("objective.exponent", FRANA_MEMBER(exponent), "", NumberRange{0.1, 1000},
                                   "N of the likelihood (misfit)^-N of an event whose survey has no stated error: the "
                                   "number of independent pieces of information in it."));
    for (const MeasureRow& row : k_measures) add({calibration}, weight_key(row));
    return keys;
}

}  // namespace

const std::vector<StudyKey>& study_keys(StudyKind kind) {
    static const std::map<StudyKind, std::vector<StudyKey>> k_keys{
        {StudyKind::ensemble, keys_of(StudyKind::ensemble)},
        {StudyKind::region, keys_of(StudyKind::region)},
        {StudyKind::calibration, keys_of(StudyKind::calibration)}};
    return k_keys.at(kind);
}

// Paths in a study file: absolute where it is used, relative where it is echoed.

namespace {

std::string with_mapped_paths(const Parameter& parameter, const std::string& value, const FileMap& map) {
    SceneSpec scene;
    if (!parameter.map_files || parameter.read(scene, value)) return value;
    parameter.map_files(scene, map);
    return parameter.write(scene).value_or(value);
}

void map_keys(std::vector<std::string>& set, std::vector<Variation>& vary, const KeyedFileMap& map) {
    for (std::string& one : set) {
        const auto equals = one.find('=');
        const std::string key = one.substr(0, equals);
        one = key + "=" + with_files(key, one.substr(equals + 1), map);
    }
    for (Variation& one : vary)
        for (std::string& value : one.distribution.values) value = with_files(one.key, value, map);
}

}  // namespace

std::string with_absolute_paths(const Parameter& parameter, const std::string& value, const std::string& folder) {
    return with_mapped_paths(parameter, value, [&](const std::string& path) { return absolute_path(path, folder); });
}

std::string with_files(const std::string& key, const std::string& value, const KeyedFileMap& map) {
    // A folder is where something is written, no input.
    static const std::vector<Parameter>& k_keys = scene_parameters();
    const Parameter* const parameter = find_parameter(k_keys, key);
    if (parameter == nullptr || !parameter->reads_files()) return value;
    return with_mapped_paths(*parameter, value, [&](const std::string& path) { return map(key, path); });
}

StudySpec with_files(StudySpec study, const KeyedFileMap& map) {
    for (const StudyKey& key : study_keys(study.kind))
        if (key.map_files) key.map_files(study, [&](const std::string& path) { return map(key.name(), path); });
    map_keys(study.set, study.vary, map);
    for (EventSpec& event : study.events) {
        event.scene = map("study.scene", event.scene);
        map_keys(event.set, event.vary, map);
    }
    return study;
}

std::string without_folder(const std::string&, const std::string& path) {
    return std::filesystem::path(path).filename().string();
}

StudySpec seen_from(StudySpec study, const std::string& folder) {
    return with_files(std::move(study),
                      [&](const std::string&, const std::string& path) { return relative_path(path, folder); });
}

std::optional<Problem> vary_volumes(StudySpec& study) {
    auto& rate = study.frequency.rate;
    const auto& volumes = study.frequency.volumes;
    if (!volumes) return std::nullopt;
    constexpr double k_rounding = 0.02;  // of a rate with two digits
    const double first = 1 / volumes->front().years;
    std::optional<Problem> contradiction;
    if (rate && std::abs(rate->value / first - 1) > k_rounding)
        contradiction = Problem{"contradicts frequency.volumes, whose first return period is " +
                                    shortest_text(volumes->front().years) + " years",
                                "frequency.rate", shortest_text(rate->value), number_text(first, 3),
                                "Remove frequency.rate, or correct one of the two"};
    rate = FrequencySpec::Rate{first, rate ? rate->deviation : 0};
    Distribution law{
        Law::return_periods, {}, {}, {}, *find_parameter(study_keys(study.kind), "frequency.volumes")->write(study)};
    for (const FrequencySpec::Volume& one : *volumes) {
        law.numbers.push_back(one.volume);
        law.numbers.push_back(one.years / volumes->front().years);
    }
    study.vary.insert(study.vary.begin(), Variation{k_volume_key, std::move(law)});
    return contradiction;
}

std::optional<Problem> thin_volumes(const FrequencySpec& frequency, double area, const Place& where) {
    constexpr double k_least_thickness = 0.02;  // [m]
    const auto& volumes = frequency.volumes;
    if (!volumes || !(area > 0) || volumes->back().volume / area >= k_least_thickness) return std::nullopt;
    return Problem{"has a greatest volume that is " + number_text(volumes->back().volume / area, 2) +
                       " m thick on the release of " + number_text(area, 4) + " m2",
                   where, shortest_text(volumes->back().volume) + " m3",
                   "at least " + shortest_text(k_least_thickness) + " m", "Write volumes in m3, not in thousands"};
}

std::string frequency_text(const StudySpec& study) {
    std::string text;
    for (const auto& key : study_keys(study.kind))
        if (const auto value = is_of_frequency(key.name()) ? key.write(study) : std::nullopt)
            text += key.name() + " = " + *value + "\n";
    return text;
}

bool is_of_frequency(const std::string& key) {
    return key.starts_with("frequency.");
}

// A study as the text of a file.

namespace {

/// The keys of one kind as lines of a file, each after its meaning and its limits; without a value commented out.
std::string keys_text(const StudySpec& study) {
    std::string text, section;
    for (const StudyKey& key : study_keys(study.kind)) {
        if (key.section != section) text += "\n[" + (section = key.section) + "]\n";
        const auto value = key.write(study);
        text += "# " + key.meaning + (key.limits.empty() ? "" : " Values: " + key.limits + ".") + "\n" +
                (value ? "" : "# ") + key.key + " =" + (value ? " " + *value : "") + "\n";
    }
    return text;
}

std::string quoted_if_needed(const std::string& value) {
    return value.find_first_of(",:\"") == std::string::npos ? value : '"' + value + '"';
}

std::string text_of(const Distribution& distribution) {
    if (distribution.law != Law::choice) return distribution.text;
    std::string text;
    for (std::size_t i = 0; i < distribution.values.size(); ++i)
        text += (i == 0 ? "choice(" : ", ") + quoted_if_needed(distribution.values[i]) + ": " +
                shortest_text(distribution.weights[i]);
    return text + ")";
}

/// The sections [set] and [vary], of all or of one event (" NAME").
std::string values_text(const std::string& of, const std::vector<std::string>& set,
                        const std::vector<Variation>& vary) {
    std::string text = set.empty() ? "" : "\n[set" + of + "]\n";
    for (const std::string& one : set)
        text += one.substr(0, one.find('=')) + " = " + one.substr(one.find('=') + 1) + "\n";
    const bool has_own = std::any_of(vary.begin(), vary.end(), [](const Variation& one) {
        return one.distribution.law != Law::return_periods;  // that is in [frequency]
    });
    if (has_own) text += "\n[vary" + of + "]\n";
    for (const Variation& one : vary)
        if (one.distribution.law != Law::return_periods) text += one.key + " = " + text_of(one.distribution) + "\n";
    return text;
}

std::string event_text(const EventSpec& event) {
    std::string text = "\n[event " + event.name + "]\nscene = " + event.scene + "\n";
    for (const ObservedKind& kind : k_observed_kinds)
        for (const Observation& one : event.observed_by(kind.evidence))
            text += kind.word + (one.gauge.empty() ? "" : " " + one.gauge) + " = " +
                    text_with_deviation(one.value, one.error) + "\n";
    return text + values_text(" " + event.name, event.set, event.vary);
}

}  // namespace

std::string study_text(const StudySpec& study) {
    constexpr const char* k_heads[] = {"# A study as used; `frana ensemble` on this file repeats it.\n",
                                       "# A region as used; `frana batch` on this file repeats it.\n",
                                       "# A calibration as used; `frana calibrate` on this file repeats it.\n"};
    std::string text =
        k_heads[static_cast<std::size_t>(study.kind)] + keys_text(study) + values_text("", study.set, study.vary);
    if (study.region && !study.region->columns.empty()) text += "\n[columns]\n";
    if (study.region)
        for (const RegionSpec::Column& one : study.region->columns) text += one.key + " = " + one.column + "\n";
    for (const RegionSpec::Event& event : study.region ? study.region->events : std::vector<RegionSpec::Event>{}) {
        text += "\n[scenario " + event.name + "]\nreturn-period = " + shortest_text(event.return_period) + "\n";
        for (const RegionSpec::Column& one : event.columns) text += one.key + " = " + one.column + "\n";
    }
    if (!study.correlate.empty()) text += "\n[correlate]\n";
    for (const Correlation& one : study.correlate)
        text += one.first + " " + one.second + " = " + shortest_text(one.rho) + "\n";
    for (const EventSpec& event : study.events) text += event_text(event);
    return text;
}

StudySpec StudySpec::of_event(std::size_t event) const {
    const EventSpec& own = events[event];
    StudySpec one = *this;
    one.kind = StudyKind::ensemble;
    one.events.clear();
    one.objective.clear();
    one.scene = own.scene;
    std::erase_if(one.set, [&](const std::string& shared) {
        return std::any_of(own.set.begin(), own.set.end(), [&](const std::string& other) {
            return other.starts_with(shared.substr(0, shared.find('=') + 1));
        });
    });
    one.set.insert(one.set.end(), own.set.begin(), own.set.end());
    one.vary.insert(one.vary.end(), own.vary.begin(), own.vary.end());
    return one;
}

}  // namespace frana::app::study
