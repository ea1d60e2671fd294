// SPDX-License-Identifier: Apache-2.0
#include "app/study/plan/sampling.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <set>

#include "app/study/member_record.h"
#include "app/study/openturns/functions.h"
#include "app/study/plan/read_study.h"
#include "core/text.h"
#include "params/grammar/value_text.h"
#include "params/keys/parameter.h"
#include "params/keys/scene_parameters.h"
#include "simulation/run_summary.h"

namespace frana::app::study {
namespace {

constexpr const char* k_error_key = "terrain.error";

/// Whether a distribution of numbers makes sense for it.
bool is_number(const Parameter& key) {
    return key.type == "number" || key.fits || key.name() == "release.thickness";
}

std::string bound_text(double bound) {
    return std::isfinite(bound) ? shortest_text(bound) : bound < 0 ? "minus infinity" : "infinity";
}

/// A cut off or bounded distribution must lie in the range; of an unbounded one the values drawn are checked.
std::optional<ValueProblem> support_refusal(const Parameter& key, const Distribution& distribution) {
    const Support support = support_of(distribution);
    SceneSpec scene;
    for (const double bound : {support.low, support.high}) {
        if (!std::isfinite(bound) || (distribution.law == Law::log_normal && bound == 0)) continue;
        const auto refusal = key.read(scene, shortest_text(bound));
        if (!refusal) continue;
        return ValueProblem{"reaches from " + bound_text(support.low) + " to " + bound_text(support.high) +
                                ", beyond the key's range (" + key.limits + ")",
                            refusal->remedy.empty() ? "Choose a distribution inside the range" : refusal->remedy};
    }
    return std::nullopt;
}

}  // namespace

std::optional<ValueProblem> refusal_to_vary(const Parameter& key) {
    static const std::set<std::string> k_grid{"terrain.cell-size", "terrain.crs", "terrain.bounds"};
    const std::string name = key.name();
    if (k_grid.count(name) > 0)
        return ValueProblem{"cannot vary: all members need the same cells, or their maps could not be combined",
                            "Set it in the scene"};
    static const std::set<std::string> k_after{"output", "observed", "hazard", "exposure", "scene"};
    if (k_after.count(key.section) > 0)
        return ValueProblem{"cannot vary: it does not change the flow, only what is written of it",
                            "Set it in the scene"};
    if (name == "numerics.accuracy" || name == "time.frame-interval")
        return ValueProblem{"cannot vary: members are computed on the scene's own cells and write no frames",
                            "Remove it"};
    return std::nullopt;
}

std::optional<ValueProblem> refusal_of(const Parameter& key, const Distribution& distribution) {
    SceneSpec scene;
    const bool is_field = distribution.law == Law::gaussian_field;
    if (is_field != (key.name() == k_error_key))
        return ValueProblem{is_field ? "is a field of error, which only terrain.error has"
                                     : "is not a field: terrain.error = gaussian-field(sd, range)",
                            ""};
    if (is_field) {
        const std::string field =
            shortest_text(distribution.numbers[0]) + ", " + shortest_text(distribution.numbers[1]) + ", 0";
        return key.read(scene, field);
    }
    if (distribution.law != Law::choice) {
        if (!is_number(key))
            return ValueProblem{"is a distribution of numbers, and the key is " +
                                    std::string(key.type == "integer" ? "a whole number" : "no number"),
                                "Write choice(value: weight, ...)"};
        return support_refusal(key, distribution);
    }
    for (const std::string& value : distribution.values) {
        const auto refusal = key.read(scene, value);
        if (refusal) return ValueProblem{"has the value " + value + ", which " + refusal->what, refusal->remedy};
    }
    return std::nullopt;
}

double option_at(const Distribution& choice, double place) {
    double sum = 0;
    std::size_t index = 0;
    for (; index + 1 < choice.weights.size(); ++index)
        if (place < (sum += choice.weights[index])) break;
    return static_cast<double>(index);
}

std::vector<double> numbers_at(const Distribution& distribution, std::vector<double> places) {
    if (!distribution.is_nominal()) return openturns().quantiles(distribution, places);
    for (double& place : places)
        if (distribution.law == Law::choice) place = option_at(distribution, place);
    return places;
}

namespace {

/// The value of a key, as after `--set`, that has a number.
std::string text_of(const Distribution& distribution, double number) {
    if (distribution.law == Law::choice) return distribution.values[static_cast<std::size_t>(number)];
    if (distribution.law != Law::gaussian_field) return shortest_text(number);
    constexpr double k_seeds = 9007199254740992.0;  // 2^53: every place in [0, 1) is a seed of its own
    return shortest_text(distribution.numbers[0]) + ", " + shortest_text(distribution.numbers[1]) + ", " +
           std::to_string(static_cast<std::int64_t>(number * k_seeds));
}

SampleTable empty_table(const StudySpec& study) {
    SampleTable table;
    for (const Variation& one : study.vary) {
        table.keys.push_back(one.key);
        table.nominal.push_back(one.distribution.is_nominal());
    }
    return table;
}

/// Of an unbounded distribution a value may lie outside the key's range.
void check_values(const StudySpec& study, const SampleTable& table, const std::string& label, Problems& problems) {
    const std::vector<Parameter>& parameters = scene_parameters();
    for (std::size_t k = 0; k < table.keys.size(); ++k) {
        const Parameter* const key = find_parameter(parameters, table.keys[k]);
        SceneSpec scene;
        for (std::size_t member = 0; member < table.size(); ++member) {
            if (!key->read(scene, table.values[member][k])) continue;
            const std::string& law = study.vary[k].distribution.text;
            problems.add(
                {"has no end, and member " + std::to_string(member) + " would have a value of " +
                     table.values[member][k],
                 Place(label, "vary.") + table.keys[k], law, key->limits,
                 "Cut the distribution off with two more numbers: " + law.substr(0, law.size() - 1) + ", low, high)"});
            break;
        }
    }
}

/// Moves the places of the volume, the first key, so that members are even in the logarithm of its exceedance G: from 1
/// to that of the greatest volume, and over one more unit, where all have that. Of L + 1 units, L = -log of the least
/// G, a member then weighs (L + 1) G: the true density over that of the members. Being first, the volume stays what it
/// is when keys are correlated, and they follow it. Returns the weights.
std::vector<double> spread_volumes(const StudySpec& study, Places& places) {
    std::vector<double> weights(places.size(), 1);
    if (!study.frequency.volumes) return weights;
    const double units = std::log(study.frequency.volumes->back().years / study.frequency.volumes->front().years);
    for (std::size_t i = 0; i < places.size(); ++i) {
        double& place = places[i].front();
        const double all = (units + 1) * place, within = std::min(all, units), exceedance = std::exp(-within);
        place = std::clamp(1 - exceedance * (1 - (all - within)), 0x1p-53, 1 - 0x1p-53);
        weights[i] = (units + 1) * exceedance;
    }
    return weights;
}

}  // namespace

std::string values_text(const SampleTable& table) {
    std::string text;
    std::vector<std::map<std::string, std::size_t>> files(table.keys.size());  // by key: value and its number
    for (std::size_t member = 0; member < table.size(); ++member)
        for (std::size_t k = 0; k < table.keys.size(); ++k) {
            const std::string& value = table.values[member][k];
            std::string shown = value;
            if (table.nominal[k]) shown = with_files(table.keys[k], value, without_folder);
            if (shown != value)
                shown += ", file " + std::to_string(files[k].try_emplace(value, files[k].size()).first->second);
            text += "member " + std::to_string(member) + " " + table.keys[k] + " = " + shown + "\n";
        }
    return text;
}

std::string values_text(const std::vector<std::string>& overrides) {
    std::string text;
    for (const std::string& one : overrides) {
        const std::size_t equals = one.find('=');
        const std::string key = one.substr(0, equals);
        text += key + "=" + with_files(key, one.substr(equals + 1), without_folder) + "\n";
    }
    return text;
}

std::vector<std::string> SampleTable::overrides(std::size_t member) const {
    std::vector<std::string> list;
    for (std::size_t k = 0; k < keys.size(); ++k) list.push_back(keys[k] + "=" + values[member][k]);
    return list;
}

SampleTable draw_samples(const StudySpec& study, const std::string& label, Problems& problems) {
    StudySpec drawn = study;
    const bool in_rounds = study.sampling == Sampling::importance;
    if (in_rounds) {
        drawn.sampling = Sampling::sobol;
        drawn.samples = round_end(study, 0);
    }
    SampleTable table = samples_at(study, draw_places(drawn, true), label, problems);
    if (const std::size_t size = study.group_size(); size > 0) table.groups = table.size() / size;
    table.is_replicated = method_of(study.sampling).replicated;
    for (std::size_t i = 0; i < table.size() && in_rounds; ++i) table.parts.push_back(i % k_replicates);
    return table;
}

Places draw_places(const StudySpec& study, bool is_replicated) {
    return openturns().independent_places(study, is_replicated);
}

SampleTable samples_at(const StudySpec& study, const Places& independent, const std::string& label,
                       Problems& problems) {
    SampleTable table = empty_table(study);
    table.places = independent;
    std::vector<double> weights = spread_volumes(study, table.places);
    if (!study.correlate.empty() && !openturns().correlate(study, table.places)) {
        problems.add({"no distribution has all these correlations at once", Place(label, "correlate"), "", "",
                      "Bring them nearer to 0"});
        return empty_table(study);
    }
    table.weights = std::move(weights);
    table.values.resize(table.places.size());
    table.numbers.resize(table.places.size());
    for (std::size_t k = 0; k < study.vary.size(); ++k) {
        const Distribution& distribution = study.vary[k].distribution;
        const std::vector<double> numbers = numbers_at(distribution, column_of(table.places, k));
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            table.numbers[i].push_back(numbers[i]);
            table.values[i].push_back(text_of(distribution, numbers[i]));
        }
    }
    check_values(study, table, label, problems);
    return table;
}

namespace {

constexpr const char* k_weight_column = "weight";
/// Columns of members.csv that are no keys and no values of a run.
constexpr const char* k_result_columns[] = {"member",        "status",    "score",          "annual_rate",
                                            "level",         "name",      "group",          "scenario",
                                            "return_period", "volume_m3", "engine_seconds", "reason"};

std::vector<std::string> result_columns() {
    std::vector<std::string> all(std::begin(k_result_columns), std::end(k_result_columns));
    all.insert(all.end(), std::begin(k_end_columns), std::end(k_end_columns));
    return all;
}

bool is_result_column(const std::string& name) {
    if (is_value_key(name)) return true;
    const std::vector<std::string> all = result_columns();
    return std::find(all.begin(), all.end(), name) != all.end();
}

std::string lower_case(std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

Problem unknown_column(const std::string& name, const std::string& place, const std::vector<Parameter>& parameters) {
    std::vector<std::string> known = names_of(parameters);
    known.emplace_back(k_weight_column);
    for (const std::string& column : result_columns()) known.push_back(column);
    const std::string nearest = nearest_name(lower_case(name), known);
    return {"is neither a key of the scene, nor weight, nor a column that members.csv has", place, "", "",
            nearest.empty() ? "Rename or remove it; `frana params` lists all keys" : "Did you mean " + nearest + "?"};
}

/// Returns the weight in a cell; nothing if it is none.
std::optional<double> weight_from(const std::string& text) {
    const auto weight = number_from_text(text);
    const bool good = weight && (*weight == 0 || (*weight >= k_least_table_weight && *weight <= k_most_table_weight));
    return good ? weight : std::nullopt;
}

bool is_blank(const std::vector<std::string>& row) {
    return std::all_of(row.begin(), row.end(),
                       [](const std::string& cell) { return cell.find_first_not_of(" \t\r") == std::string::npos; });
}

}  // namespace

SampleTable samples_of_table(const std::vector<std::string>& columns, const std::vector<std::vector<std::string>>& rows,
                             const Place& where, Problems& problems) {
    SampleTable table;
    const std::vector<Parameter>& parameters = scene_parameters();
    std::vector<std::size_t> of_key;
    std::optional<std::size_t> weights;
    const std::size_t known = problems.list().size();
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const std::string name = present_name(columns[i]), place = where + ": " + columns[i];
        const bool twice =
            std::count(columns.begin(), columns.begin() + static_cast<std::ptrdiff_t>(i), columns[i]) > 0 ||
            std::find(table.keys.begin(), table.keys.end(), name) != table.keys.end();
        if (twice) {
            problems.add({"is a column twice", place, "", "", "Keep one of the two"});
        } else if (columns[i] == k_weight_column) {
            weights = i;
            table.columns.push_back({columns[i], TableColumn::Use::weight});
        } else if (const Parameter* const parameter = find_parameter(parameters, name); parameter == nullptr) {
            if (is_result_column(columns[i]))
                table.columns.push_back({columns[i], TableColumn::Use::result});
            else
                problems.add(unknown_column(columns[i], place, parameters));
        } else if (const auto refusal = refusal_to_vary(*parameter)) {
            problems.add({refusal->what, place, "", "", refusal->remedy});
        } else {
            table.columns.push_back({columns[i], TableColumn::Use::key});
            table.keys.push_back(name);
            of_key.push_back(i);
        }
    }
    if (problems.list().size() > known) return table;
    if (of_key.empty() || rows.empty()) {
        problems.add({of_key.empty() ? "has no column with the name of a key" : "has no rows", where, "", "",
                      "Write a column for each key that varies, and a row for each member"});
        return table;
    }
    // Numbers where all of a column are; else the order in which the texts appear.
    for (const std::size_t column : of_key)
        table.nominal.push_back(!std::all_of(rows.begin(), rows.end(), [&](const auto& row) {
            return is_blank(row) || number_from_text(row[column]).has_value();
        }));
    std::vector<std::map<std::string, double>> first(of_key.size());  // row of each text
    for (std::size_t row = 0; row < rows.size(); ++row) {
        if (is_blank(rows[row])) continue;
        std::vector<std::string> texts;
        std::vector<double> numbers;
        for (std::size_t k = 0; k < of_key.size(); ++k) {
            const std::string& text = texts.emplace_back(rows[row][of_key[k]]);
            numbers.push_back(table.nominal[k] ? first[k].emplace(text, static_cast<double>(row)).first->second
                                               : *number_from_text(text));
        }
        const auto weight = weights ? weight_from(rows[row][*weights]) : 1;
        if (!weight)
            problems.add(
                {"is not a weight", where + ": " + k_weight_column, rows[row][*weights],
                 "0, or from " + shortest_text(k_least_table_weight) + " to " + shortest_text(k_most_table_weight),
                 "Correct row " + std::to_string(row + 1)});
        if (!weight || *weight == 0) continue;
        table.values.push_back(std::move(texts));
        table.numbers.push_back(std::move(numbers));
        table.weights.push_back(*weight);
    }
    if (table.size() == 0 && problems.empty())
        problems.add(
            {"has no weight greater than 0", where + ": " + k_weight_column, "", "", "Give a member a weight"});
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
            list.push_back(one.key + "=" + text_of(d, numbers_at(d, {0.5}).front()));
        }
    }
    return list;
}

}  // namespace frana::app::study
