// SPDX-License-Identifier: Apache-2.0
#include "study/sampling.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "core/shortest_text.h"
#include "params/grammar/nearest_name.h"
#include "params/grammar/value_text.h"
#include "params/keys/former_names.h"
#include "params/keys/scene_parameters.h"
#include "study/openturns/functions.h"
#include "study/read_study.h"
#include "study/varied_key.h"

namespace frana::study {
namespace {

constexpr double k_seeds = 9007199254740992.0;  // 2^53: every place in [0, 1) is a seed of its own

/// A value as text, and as a number for statistics.
using Value = std::pair<std::string, double>;

Value nominal_value(const Distribution& distribution, double place) {
    if (distribution.law == Law::gaussian_field) {
        const auto seed = static_cast<std::int64_t>(place * k_seeds);
        return {shortest_text(distribution.numbers[0]) + ", " + shortest_text(distribution.numbers[1]) + ", " +
                    std::to_string(seed),
                place};
    }
    double sum = 0;
    std::size_t index = 0;
    for (; index + 1 < distribution.values.size(); ++index)
        if (place < (sum += distribution.weights[index])) break;
    return {distribution.values[index], static_cast<double>(index)};
}

/// Returns the values of one key at places in (0, 1).
std::vector<Value> values_at(const Distribution& distribution, const std::vector<double>& places) {
    std::vector<Value> values;
    if (distribution.is_nominal()) {
        for (const double place : places) values.push_back(nominal_value(distribution, place));
    } else {
        for (const double value : openturns().quantiles(distribution, places))
            values.emplace_back(shortest_text(value), value);
    }
    return values;
}

SampleTable empty_table(const StudySpec& study) {
    SampleTable table;
    for (const Variation& one : study.vary) {
        table.keys.push_back(one.key);
        table.nominal.push_back(one.distribution.is_nominal());
    }
    return table;
}

void add_member(const std::vector<Value>& values, double weight, SampleTable& table) {
    auto& texts = table.values.emplace_back();
    auto& numbers = table.numbers.emplace_back();
    for (const auto& [text, number] : values) {
        texts.push_back(text);
        numbers.push_back(number);
    }
    table.weights.push_back(weight);
}

/// All combinations of as many levels of each key as the samples allow, in the middle of equal parts of its
/// distribution; of a choice all values, with their weights.
SampleTable full_factorial(const StudySpec& study) {
    SampleTable table = empty_table(study);
    double choices = 1;
    std::size_t numbers = 0;
    for (const Variation& one : study.vary) {
        const bool is_choice = one.distribution.law == Law::choice;
        choices *= is_choice ? static_cast<double>(one.distribution.values.size()) : 1;
        numbers += is_choice ? 0 : 1;
    }
    const double most = static_cast<double>(study.samples) / choices;
    const auto levels = static_cast<std::size_t>(
        numbers == 0 ? 1 : std::max(1.0, std::floor(std::pow(most, 1.0 / static_cast<double>(numbers)) + 1e-9)));
    std::vector<std::size_t> at(study.vary.size());
    for (bool more = true; more;) {
        std::vector<Value> values;
        double weight = 1;
        for (std::size_t k = 0; k < at.size(); ++k) {
            const Distribution& d = study.vary[k].distribution;
            if (d.law == Law::choice) {
                values.emplace_back(d.values[at[k]], static_cast<double>(at[k]));
                weight *= d.weights[at[k]];
            } else {
                const double place = (static_cast<double>(at[k]) + 0.5) / static_cast<double>(levels);
                values.push_back(values_at(d, {place}).front());
            }
        }
        add_member(values, weight, table);
        more = false;
        for (std::size_t k = at.size(); k-- > 0 && !more;) {
            const Distribution& d = study.vary[k].distribution;
            more = ++at[k] < (d.law == Law::choice ? d.values.size() : levels);
            if (!more) at[k] = 0;
        }
    }
    return table;
}

/// Of an unbounded distribution a value may lie outside the key's range.
void check_values(const StudySpec& study, const SampleTable& table, const std::string& label, Problems& problems) {
    const std::vector<Parameter> parameters = scene_parameters();
    for (std::size_t k = 0; k < table.keys.size(); ++k) {
        const Parameter* const key = find_parameter(parameters, table.keys[k]);
        SceneSpec scene;
        for (std::size_t member = 0; member < table.size(); ++member) {
            if (!key->read(scene, table.values[member][k])) continue;
            const std::string& law = study.vary[k].distribution.text;
            problems.add(
                {"has no end, and member " + std::to_string(member) + " would have a value of " +
                     table.values[member][k],
                 label + ": vary." + table.keys[k], law, key->limits,
                 "Cut the distribution off with two more numbers: " + law.substr(0, law.size() - 1) + ", low, high)"});
            break;
        }
    }
}

}  // namespace

std::string values_text(const SampleTable& table) {
    std::string text;
    std::vector<std::map<std::string, std::size_t>> files(table.keys.size());  // by key: value and its number
    for (std::size_t member = 0; member < table.size(); ++member)
        for (std::size_t k = 0; k < table.keys.size(); ++k) {
            const std::string& value = table.values[member][k];
            std::string shown = value;
            if (table.nominal[k])
                shown = with_files(table.keys[k], value, [](const std::string&, const std::string& path) {
                    return std::filesystem::path(path).filename().string();
                });
            if (shown != value)
                shown += ", file " + std::to_string(files[k].try_emplace(value, files[k].size()).first->second);
            text += "member " + std::to_string(member) + " " + table.keys[k] + " = " + shown + "\n";
        }
    return text;
}

std::vector<std::string> SampleTable::overrides(std::size_t member) const {
    std::vector<std::string> list;
    for (std::size_t k = 0; k < keys.size(); ++k) list.push_back(keys[k] + "=" + values[member][k]);
    if (!level_runs.empty() && level_runs[member].cell_size > 0)
        list.push_back(std::string(k_cell_size_key) + "=" + shortest_text(level_runs[member].cell_size));
    return list;
}

SampleTable draw_samples(const StudySpec& study, const std::string& label, Problems& problems) {
    if (study.sampling == Sampling::grid) return full_factorial(study);
    SampleTable table = samples_at(study, draw_places(study), label, problems);
    if (study.sampling == Sampling::saltelli) table.groups = table.size() / (study.vary.size() + 2);
    return table;
}

Places draw_places(const StudySpec& study) {
    return openturns().independent_places(study);
}

SampleTable samples_at(const StudySpec& study, const Places& independent, const std::string& label,
                       Problems& problems) {
    SampleTable table = empty_table(study);
    table.places = independent;
    if (!study.correlate.empty() && !openturns().correlate(study, table.places)) {
        problems.add({"no distribution has all these correlations at once", label + ": correlate", "", "",
                      "Bring them nearer to 0"});
        return empty_table(study);
    }
    std::vector<std::vector<Value>> of_keys;
    for (std::size_t k = 0; k < study.vary.size(); ++k) {
        std::vector<double> column;
        for (const std::vector<double>& place : table.places) column.push_back(place[k]);
        of_keys.push_back(values_at(study.vary[k].distribution, column));
    }
    for (std::size_t i = 0; i < table.places.size(); ++i) {
        std::vector<Value> values;
        for (const std::vector<Value>& of_key : of_keys) values.push_back(of_key[i]);
        add_member(values, 1, table);
    }
    check_values(study, table, label, problems);
    return table;
}

namespace {

/// A column whose name has the section of a key was meant as one; other columns are notes.
void refuse_mistyped(const std::string& name, const std::string& column, const std::string& where,
                     const std::vector<Parameter>& parameters, Problems& problems) {
    const auto dot = name.find('.');
    const bool meant = dot != std::string::npos && name.find(' ') == std::string::npos &&
                       std::any_of(parameters.begin(), parameters.end(),
                                   [&](const Parameter& key) { return key.section == name.substr(0, dot); });
    if (!meant) return;
    const std::string nearest = nearest_name(name, names_of(parameters));
    problems.add({"unknown key of the scene", where + ": " + column, "", "",
                  nearest.empty() ? "`frana params` lists all keys" : "Did you mean " + nearest + "?"});
}

}  // namespace

SampleTable samples_of_table(const std::vector<std::string>& columns, const std::vector<std::vector<std::string>>& rows,
                             const std::string& where, Problems& problems) {
    SampleTable table;
    const std::vector<Parameter> parameters = scene_parameters();
    std::vector<std::size_t> of_key;
    std::optional<std::size_t> weights;
    const std::size_t known = problems.list().size();
    for (std::size_t i = 0; i < columns.size(); ++i) {
        if (columns[i] == "weight") weights = i;
        const std::string name = present_name(columns[i]);
        const Parameter* const parameter = find_parameter(parameters, name);
        if (parameter == nullptr) {
            refuse_mistyped(name, columns[i], where, parameters, problems);
            continue;
        }
        if (const auto refusal = refusal_to_vary(*parameter)) {
            problems.add({refusal->what, where + ": " + columns[i], "", "", refusal->remedy});
            continue;
        }
        if (std::find(table.keys.begin(), table.keys.end(), name) != table.keys.end()) {
            problems.add({"is a column twice", where + ": " + columns[i], "", "", "Keep one of the two"});
            continue;
        }
        table.keys.push_back(name);
        of_key.push_back(i);
    }
    if (problems.list().size() > known) return table;
    if (of_key.empty() || rows.empty()) {
        problems.add({of_key.empty() ? "has no column with the name of a key" : "has no rows", where, "", "",
                      "Write a column for each key that varies, and a row for each member"});
        return table;
    }
    // Numbers where all of a column are; else the index of the first row with the same text.
    for (const std::size_t column : of_key)
        table.nominal.push_back(!std::all_of(
            rows.begin(), rows.end(), [&](const auto& row) { return number_from_text(row[column]).has_value(); }));
    for (std::size_t row = 0; row < rows.size(); ++row) {
        std::vector<Value> values;
        for (std::size_t k = 0; k < of_key.size(); ++k) {
            const std::string& text = rows[row][of_key[k]];
            std::size_t first = 0;
            if (table.nominal[k])
                while (rows[first][of_key[k]] != text) ++first;
            values.emplace_back(text, table.nominal[k] ? static_cast<double>(first) : *number_from_text(text));
        }
        const auto weight = weights ? number_from_text(rows[row][*weights]) : 1;
        if (!weight || !(*weight >= 0))
            problems.add({"is not a weight", where + ": weight", rows[row][*weights], "0 or more",
                          "Correct row " + std::to_string(row + 1)});
        else if (*weight > 0)
            add_member(values, *weight, table);
    }
    if (table.size() == 0 && problems.empty())
        problems.add({"has no weight greater than 0", where + ": weight", "", "", "Give a member a weight"});
    return table;
}

std::vector<std::string> central_values(const StudySpec& study) {
    std::vector<std::string> list;
    for (const Variation& one : study.vary) {
        const Distribution& d = one.distribution;
        if (d.law == Law::gaussian_field) continue;
        if (d.law == Law::choice) {
            const auto likeliest = std::max_element(d.weights.begin(), d.weights.end()) - d.weights.begin();
            list.push_back(one.key + "=" + d.values[static_cast<std::size_t>(likeliest)]);
        } else {
            list.push_back(one.key + "=" + values_at(d, {0.5}).front().first);
        }
    }
    return list;
}

}  // namespace frana::study
