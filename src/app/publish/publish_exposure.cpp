// SPDX-License-Identifier: Apache-2.0
#include "app/publish/publish_exposure.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "app/store/result_files.h"
#include "app/store/vector_layers.h"
#include "app/text/number_text.h"
#include "app/text/text_file.h"
#include "app/text/text_table.h"
#include "core/text.h"

namespace frana::app {
namespace {

/// An attribute with the name of a figure, or of GeoPackage's columns, gets another.
std::string renamed(const std::string& name, const std::set<std::string>& taken) {
    std::string lower = name;
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return taken.count(lower) > 0 || lower == "geom" ? "input_" + name : name;
}

std::vector<ReachedFeature> deepest_of(const gis::FeatureLayer& layer, const std::vector<ExposureRow>& rows) {
    std::vector<ReachedFeature> reached;
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (rows[i].is_reached())
            reached.push_back({layer.features[i].name, rows[i].numbers, rows[i].texts, rows[i].depth});
    std::stable_sort(reached.begin(), reached.end(), [](const auto& a, const auto& b) { return a.depth > b.depth; });
    if (reached.size() > k_most_named) reached.resize(k_most_named);
    return reached;
}

std::string damage_text(const Damage& damage, const Words& words) {
    const auto number = [&](double value) {
        return words.number(std::abs(value) < 1000 ? number_text(value, 3) : grouped(value));
    };
    const bool is_known = damage.low == damage.value && damage.high == damage.value;
    return number(damage.value) + (is_known ? "" : " (" + number(damage.low) + " – " + number(damage.high) + ")");
}

}  // namespace

std::vector<std::vector<std::size_t>> exposed_cells(const gis::FeatureLayer& layer, const GridSpec& grid) {
    std::vector<std::vector<std::size_t>> all;
    all.reserve(layer.features.size());
    for (const Feature& feature : layer.features) all.push_back(touched_cells(feature.shape, grid));
    return all;
}

std::vector<ExposureRow> exposure_rows(const gis::FeatureLayer& layer, const std::vector<ExposureValues>& values,
                                       const Bounds& map) {
    std::vector<ExposureRow> rows;
    for (std::size_t i = 0; i < layer.features.size(); ++i)
        rows.push_back(exposure_row(layer.features[i].shape, values[i], map));
    return rows;
}

std::string DamageSum::title(const Words& words) const {
    const std::string what =
        words(name == k_annual_damage ? worded("Expected damage a year") : worded("Expected damage"));
    return scenario.empty() ? what : scenario + ": " + what;
}

DamageSum add_damages(const std::string& name, const std::string& scenario, const std::vector<Damage>& damages,
                      std::vector<ExposureRow>& rows) {
    DamageSum sum{name, scenario, {}};
    for (std::size_t f = 0; f < rows.size(); ++f)
        for (const auto& [ending, part] :
             {std::pair("", &Damage::value), std::pair("_low", &Damage::low), std::pair("_high", &Damage::high)}) {
            rows[f].numbers.emplace_back(name + ending, rows[f].is_on_map() ? damages[f].*part : k_no_data);
            if (rows[f].is_on_map()) sum.damage.*part += damages[f].*part;
        }
    return sum;
}

DamageSum add_event_damage(const Fragility& fragility, const std::string& prefix, const std::string& scenario,
                           bool is_open, std::vector<ExposureRow>& rows) {
    std::vector<Damage> all;
    for (std::size_t f = 0; f < rows.size(); ++f) {
        const double damage = fragility.damage(f, rows[f].number(prefix + fragility.of(f).by->column));
        all.push_back({damage, damage, is_open ? fragility.most(f) : damage});
    }
    return add_damages(prefix + k_expected_damage, scenario, all, rows);
}

ExposureTotals write_exposure(const gis::FeatureLayer& layer, const std::vector<ExposureRow>& rows,
                              const std::string& crs_wkt, const Words& words, const ResultDirectory& directory) {
    ExposureTotals totals;
    std::set<std::string> taken{"fid", "feature", "exposed", "count"};
    for (const auto& [name, value] : rows.front().numbers) taken.insert(name);
    for (const auto& [name, value] : rows.front().texts) taken.insert(name);
    std::string head = "feature,exposed,count", table;
    for (const auto& [name, value] : rows.front().texts) head += "," + csv_cell(name);
    for (const auto& [name, value] : rows.front().numbers) head += "," + csv_cell(name);
    for (const auto& [name, value] : layer.features.front().numbers) head += "," + csv_cell(renamed(name, taken));
    for (const auto& [name, value] : layer.features.front().texts) head += "," + csv_cell(renamed(name, taken));
    std::vector<Feature> written;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const Feature& from = layer.features[i];
        const ExposureRow& row = rows[i];
        Feature& to = written.emplace_back();
        to.shape = from.shape;
        const double count = from.count.value_or(1);
        ++totals.features;
        totals.count += count;
        totals.reached += row.is_reached() ? 1 : 0;
        totals.count_reached += row.is_reached() ? count : 0;
        totals.off_map += row.is_on_map() ? 0 : 1;
        totals.has_count = totals.has_count || from.count.has_value();
        const auto cell = [](double value) { return std::isnan(value) ? std::string() : shortest_text(value); };
        table += std::to_string(from.fid) + "," + csv_cell(from.name) + "," + cell(count);
        for (const auto& [name, value] : row.texts) table += "," + csv_cell(value);
        for (const auto& [name, value] : row.numbers) table += "," + cell(value);
        for (const auto& [name, value] : from.numbers) {
            table += "," + cell(value);
            to.numbers[renamed(name, taken)] = value;
        }
        for (const auto& [name, value] : from.texts) {
            table += "," + csv_cell(value);
            to.texts[renamed(name, taken)] = value;
        }
        table += "\n";
        for (const auto& [name, value] : row.numbers) to.numbers[name] = value;
        for (const auto& [name, value] : row.texts) to.texts[name] = value;
        to.numbers["feature"] = static_cast<double>(from.fid);
        to.numbers["count"] = count;
        to.texts["exposed"] = from.name;
    }
    write_text_file(directory.path(k_exposure_table), head + "\n" + table);
    std::map<gis::Shape, gis::StyleText> styles;
    for (const VectorLayer& one : vector_layers())
        if (one.file == k_exposure_file) styles[one.shape] = style_in(one, words);
    gis::write_mixed(directory.path(k_exposure_file), crs_wkt, "exposure", written, styles);
    totals.deepest = deepest_of(layer, rows);
    return totals;
}

std::string exposure_sentence(const ExposureTotals& totals, ReachedBy by, const Words& words) {
    static const std::map<ReachedBy, std::string> k_labels{
        {ReachedBy::the_flow, worded("Exposed features reached")},
        {ReachedBy::any_run, worded("Exposed features reached by at least one run")}};
    const std::string least = totals.is_least ? "≥ " : "";  // the full reach is not known
    const auto of = [&](double part, double all) {
        return words("{1} of {2}", {words.number(grouped(part)), words.number(grouped(all))});
    };
    std::string text = words.labelled(
        words(k_labels.at(by)), least + of(static_cast<double>(totals.reached), static_cast<double>(totals.features)));
    if (totals.has_count) text += "; " + words.labelled(words("Count"), least + of(totals.count_reached, totals.count));
    if (totals.off_map > 0)
        text += "; " + words.labelled(words("off the map"), words.number(grouped(static_cast<double>(totals.off_map))));
    for (const DamageSum& one : totals.damages)
        text += "; " + words.labelled(one.title(words), damage_text(one.damage, words));
    return text;
}

}  // namespace frana::app
