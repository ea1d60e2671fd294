// SPDX-License-Identifier: Apache-2.0
#include "app/study/plan/sampling.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <optional>

#include "params/grammar/value_text.h"

namespace frana::app::study {
namespace {

struct Form {
    const char* word;
    Law law;
    std::vector<std::size_t> counts;  ///< of numbers it may have
};

const std::vector<Form>& forms() {
    static const std::vector<Form> k_forms{
        {"uniform", Law::uniform, {2}},       {"log-uniform", Law::log_uniform, {2}},
        {"normal", Law::normal, {2, 4}},      {"log-normal", Law::log_normal, {2, 4}},
        {"triangular", Law::triangular, {3}}, {"pert", Law::pert, {3}},
        {"pareto", Law::pareto, {3}},         {"table", Law::table, {}},
        {"choice", Law::choice, {}},          {"gaussian-field", Law::gaussian_field, {2}}};
    return k_forms;
}

/// Splits at commas outside quotes; a quote that is not closed gives none.
std::optional<std::vector<std::string>> parts_of(const std::string& text) {
    std::vector<std::string> parts(1);
    bool quoted = false;
    for (const char c : text) {
        if (c == '"') quoted = !quoted;
        if (c == ',' && !quoted) {
            parts.emplace_back();
        } else {
            parts.back() += c;
        }
    }
    if (quoted) return std::nullopt;
    for (std::string& part : parts) part = trimmed(part);
    return parts;
}

std::string without_quotes(const std::string& text) {
    const bool quoted = text.size() >= 2 && text.front() == '"' && text.back() == '"';
    return quoted ? text.substr(1, text.size() - 2) : text;
}

/// The weight follows the last colon outside quotes: values themselves may contain one ("raster:depth.tif").
std::optional<ValueProblem> add_choice(const std::string& part, Distribution& choice) {
    const auto colon = part.rfind(':'), quote = part.rfind('"');
    const bool outside = colon != std::string::npos && (quote == std::string::npos || colon > quote);
    const auto given = number_from_text(outside ? trimmed(part.substr(colon + 1)) : "");
    const bool weighted = given.has_value();
    const double weight = given.value_or(1);
    const std::string value = without_quotes(weighted ? trimmed(part.substr(0, colon)) : part);
    if (value.empty()) return ValueProblem{"has an empty value", "Write for example choice(a: 0.7, b: 0.3)"};
    if (!(weight > 0)) return ValueProblem{"has a weight that is not greater than 0", ""};
    if (std::find(choice.values.begin(), choice.values.end(), value) != choice.values.end())
        return ValueProblem{"has the value " + value + " twice", ""};
    choice.values.push_back(value);
    if (weighted) choice.weights.push_back(weight);
    return std::nullopt;
}

std::variant<Distribution, ValueProblem> choice_of(const std::vector<std::string>& parts, Distribution choice) {
    for (const std::string& part : parts)
        if (const auto refusal = add_choice(part, choice)) return *refusal;
    if (choice.weights.empty()) choice.weights.assign(choice.values.size(), 1);
    if (choice.weights.size() != choice.values.size())
        return ValueProblem{"has weights for some of its values only", "Give each value a weight, or none"};
    const double sum = std::accumulate(choice.weights.begin(), choice.weights.end(), 0.0);
    for (double& weight : choice.weights) weight /= sum;
    return choice;
}

/// A choice of numbers, in their order.
std::variant<Distribution, ValueProblem> in_order(const Distribution& choice) {
    Distribution table{Law::table, {}, {}, {}, choice.text};
    std::map<double, std::size_t> places;
    for (std::size_t i = 0; i < choice.values.size(); ++i) {
        const auto number = number_from_text(choice.values[i]);
        if (!number)
            return ValueProblem{"'" + choice.values[i] + "' is not a number", "Write choice(value: weight, ...)"};
        if (!places.emplace(*number, i).second) return ValueProblem{"has the value " + choice.values[i] + " twice", ""};
    }
    for (const auto& [number, place] : places) {
        table.numbers.push_back(number);
        table.values.push_back(choice.values[place]);
        table.weights.push_back(choice.weights[place]);
    }
    return table;
}

/// What is wrong with the numbers; none: nothing.
std::optional<ValueProblem> contradiction(Law law, const std::vector<double>& n) {
    const bool positive = law == Law::log_uniform || law == Law::log_normal || law == Law::pareto;
    if (positive && !(n[0] > 0)) return ValueProblem{"needs a first number greater than 0", ""};
    switch (law) {
        case Law::uniform:
        case Law::log_uniform:
            if (!(n[0] < n[1])) return ValueProblem{"needs a rising pair of limits", ""};
            break;
        case Law::normal:
        case Law::log_normal:
            if (!(n[1] > 0)) return ValueProblem{"needs a standard deviation greater than 0", ""};
            if (n.size() == 4 && !(n[2] < n[3])) return ValueProblem{"needs rising limits after the deviation", ""};
            if (n.size() == 4 && !(n[2] < n[0] && n[0] < n[3]))
                return ValueProblem{"needs limits on both sides of the mean", ""};
            break;
        case Law::pareto:
            if (!(n[1] > 0 && n[0] < n[2]))
                return ValueProblem{"needs a least value, an exponent and a greatest value", ""};
            break;
        case Law::triangular:
        case Law::pert:
            if (!(n[0] <= n[1] && n[1] <= n[2] && n[0] < n[2]))
                return ValueProblem{"needs a least, a likeliest and a greatest value in this order", ""};
            break;
        case Law::gaussian_field:
            if (!(n[0] > 0 && n[1] > 0))
                return ValueProblem{"needs a standard deviation and a range greater than 0", ""};
            break;
        case Law::table:
        case Law::choice:
        case Law::gamma:
        case Law::return_periods:
            break;
    }
    return std::nullopt;
}

std::string counts_text(const Form& form) {
    std::string text;
    for (const std::size_t count : form.counts) text += (text.empty() ? "" : " or ") + std::to_string(count);
    return text;
}

}  // namespace

std::variant<Distribution, ValueProblem> distribution_from_text(const std::string& text) {
    const auto open = text.find('(');
    if (open == std::string::npos || text.back() != ')')
        return ValueProblem{"is not a distribution", "To keep one value, set the key in the scene"};
    const std::string word = trimmed(text.substr(0, open));
    const auto form = std::find_if(forms().begin(), forms().end(), [&](const Form& one) { return one.word == word; });
    if (form == forms().end()) return ValueProblem{"'" + word + "' is not a distribution", ""};
    const auto parts = parts_of(text.substr(open + 1, text.size() - open - 2));
    if (!parts) return ValueProblem{"has a quote that is not closed", ""};
    Distribution distribution{form->law, {}, {}, {}, text};
    if (form->law == Law::choice) return choice_of(*parts, distribution);
    if (form->law == Law::table) {
        auto choice = choice_of(*parts, distribution);
        return std::holds_alternative<ValueProblem>(choice) ? choice : in_order(std::get<Distribution>(choice));
    }
    for (const std::string& part : *parts) {
        const auto number = number_from_text(part);
        if (!number) return ValueProblem{"'" + part + "' is not a number", ""};
        distribution.numbers.push_back(*number);
    }
    if (std::find(form->counts.begin(), form->counts.end(), parts->size()) == form->counts.end())
        return ValueProblem{
            "has " + std::to_string(parts->size()) + " numbers, and " + word + " needs " + counts_text(*form), ""};
    if (const auto refusal = contradiction(form->law, distribution.numbers)) return *refusal;
    return distribution;
}

Support support_of(const Distribution& distribution) {
    constexpr double k_infinite = std::numeric_limits<double>::infinity();
    const std::vector<double>& n = distribution.numbers;
    switch (distribution.law) {
        case Law::normal:
            return n.size() == 4 ? Support{n[2], n[3]} : Support{-k_infinite, k_infinite};
        case Law::log_normal:
            return n.size() == 4 ? Support{std::max(0.0, n[2]), n[3]} : Support{0, k_infinite};
        case Law::triangular:
        case Law::pert:
        case Law::pareto:
            return {n[0], n[2]};
        case Law::table:
            return {n.front(), n.back()};
        case Law::return_periods:
            return {n.front(), n[n.size() - 2]};
        case Law::uniform:
        case Law::log_uniform:
        case Law::gaussian_field:
        case Law::choice:
        case Law::gamma:
            break;
    }
    return n.size() >= 2 ? Support{n[0], n[1]} : Support{};
}

}  // namespace frana::app::study
