// SPDX-License-Identifier: Apache-2.0
#include "app/input/fragility_input.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/text.h"
#include "gis/access/table_in.h"
#include "params/grammar/value_text.h"

namespace frana::app {
namespace {

const HazardQuantityRow& row_of(const BreakingQuantity& one) {
    return hazard_quantities()[static_cast<std::size_t>(one.quantity)];
}

/// The text of a column of a feature; none: there is no such column.
std::optional<std::string> attribute_of(const Feature& feature, const std::string& column) {
    if (const auto number = feature.numbers.find(column); number != feature.numbers.end())
        return std::isnan(number->second) ? "" : shortest_text(number->second);
    if (const auto text = feature.texts.find(column); text != feature.texts.end()) return trimmed(text->second);
    return std::nullopt;
}

/// Calls take(feature, text), which returns what is wrong with the text, for the value of a key's column in each.
template <class Take>
void read_column(const gis::FeatureLayer& layer, const std::string& column, const Place& where,
                 const std::string& limit, const Take& take) {
    for (std::size_t i = 0; i < layer.features.size(); ++i) {
        const auto text = attribute_of(layer.features[i], column);
        if (!text) throw Error(ErrorKind::input, Problem{"is no column of output.exposure", where, column, "", ""});
        if (const char* const wrong = take(i, *text))
            throw Error(ErrorKind::input, Problem{"feature " + layer.features[i].name + " " + wrong, where, *text,
                                                  limit, "Correct the column"});
    }
}

}  // namespace

std::vector<FragilityClass> read_fragility(const std::string& path, const Place& where, Problems& problems) {
    const gis::Table table = gis::read_table(path, where);
    std::map<std::string, std::size_t> columns;
    for (std::size_t i = 0; i < table.columns.size(); ++i) columns[trimmed(table.columns[i])] = i;
    const std::vector<std::string> needed{"state", "loss_ratio", "quantity", "unit", "median", "beta"};
    const bool has_class = columns.contains("class");
    std::vector<FragilityClass> classes;
    for (const std::string& name : needed)
        if (!columns.contains(name))
            problems.add({"has no column " + name, where, path, joined(needed, ", ") + ", perhaps class",
                          "Write a row for each state of damage"});
    if (columns.size() > needed.size() + (has_class ? 1 : 0))
        problems.add({"has columns that are not known", where, joined(table.columns, ", "),
                      joined(needed, ", ") + ", perhaps class", "Remove them"});
    if (!problems.empty()) return classes;
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        const auto text = [&](const char* name) { return trimmed(table.rows[i][columns.at(name)]); };
        const auto refuse = [&](const std::string& what, const std::string& value, const std::string& limit,
                                const std::string& remedy) {
            problems.add({what, where + ": " + path + ", row " + std::to_string(i + 1), value, limit, remedy});
        };
        const BreakingQuantity* by = nullptr;
        std::vector<std::string> known;
        for (const BreakingQuantity& one : k_breaking_quantities) {
            known.push_back(std::string(row_of(one).key) + " in " + row_of(one).unit);
            if (text("quantity") + " in " + text("unit") == known.back()) by = &one;
        }
        if (by == nullptr) {
            refuse("has a quantity or unit that is not known", text("quantity") + " in " + text("unit"),
                   joined(known, ", "), "Write one of these");
            continue;
        }
        const auto number = [&](const char* name, double least, double most, const std::string& remedy) {
            const auto value = number_from_text(text(name));
            if (!value || !(*value >= least && *value <= most))
                refuse(std::string(name) + " is out of range", text(name),
                       shortest_text(least) + " to " + shortest_text(most), remedy);
            return value.value_or(least);
        };
        constexpr double k_least_median = 1e-6, k_most_beta = 3;
        const DamageState state{
            text("state"), number("loss_ratio", 0, 1, "It is a fraction: write 0.3 for 30 %"),
            number("median", k_least_median, by->most,
                   std::string("Write it in ") + row_of(*by).unit + ", not in cm for example"),
            number("beta", 0, k_most_beta, "The standard deviation of the logarithm is customary between 0.2 and 1")};
        const std::string name = has_class ? text("class") : "";
        if (state.name.empty() || (has_class && name.empty())) refuse("has no name of its state or class", "", "", "");
        auto found = std::find_if(classes.begin(), classes.end(), [&](const auto& one) { return one.name == name; });
        if (found == classes.end()) found = classes.insert(found, {name, by, {}});
        if (found->by != by)
            refuse("gives a class a second quantity", text("quantity"), row_of(*found->by).key, "Keep one of them");
        if (!found->states.empty() &&
            !(state.loss >= found->states.back().loss && state.median > found->states.back().median))
            refuse("is not worse than " + found->states.back().name + " above it", state.name,
                   "rising medians and losses", "Write the states of a class from the lightest to the worst");
        found->states.push_back(state);
    }
    return classes;
}

Fragility fragility_of(const SceneReading& reading, const gis::FeatureLayer& layer, std::vector<UsedFile>& files) {
    const ExposureSpec& spec = reading.scene.exposure;
    const Place where = reading.where("exposure.fragility");
    Problems problems;
    Fragility all{read_fragility(*spec.fragility, where, problems), std::vector<std::size_t>(layer.features.size()),
                  std::vector<double>(layer.features.size(), 1)};
    problems.throw_if_any();
    if (all.classes.front().name.empty() == spec.kind.has_value())
        throw Error(
            ErrorKind::input,
            Problem{"needs a column class if exposure.class is given, and only then", where, *spec.fragility, "",
                    "Name the column of output.exposure with the class of each feature, or leave out both"});
    std::vector<std::string> known;
    for (const FragilityClass& one : all.classes) known.push_back(one.name);
    if (spec.kind)
        read_column(layer, *spec.kind, reading.where("exposure.class"), joined(known, ", "),
                    [&](std::size_t i, const std::string& text) {
                        const auto found = std::find(known.begin(), known.end(), text);
                        all.class_of[i] = static_cast<std::size_t>(found - known.begin());
                        return found == known.end() ? "is of a class that exposure.fragility does not have" : nullptr;
                    });
    if (spec.value)
        read_column(layer, *spec.value, reading.where("exposure.value"), "numbers from 0",
                    [&](std::size_t i, const std::string& text) {
                        all.value[i] = number_from_text(text).value_or(-1);
                        return all.value[i] >= 0 ? nullptr : "has a value that is no number from 0";
                    });
    UsedFile file;
    file.role = worded("Fragility");
    file.path = *spec.fragility;
    file.content = joined(known, ", ");
    for (const FragilityClass& one : all.classes)
        for (const DamageState& state : one.states)
            file.checksum.add_all(one.name, std::string(one.by->column), state.name, state.loss, state.median,
                                  state.beta);
    files.push_back(std::move(file));
    return all;
}

}  // namespace frana::app
