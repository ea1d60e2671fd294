// SPDX-License-Identifier: Apache-2.0
// What a result's own scene and outlines say besides their values.
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/pictures/result_numbers.h"
#include "app/pictures/result_reader.h"
#include "app/store/result_files.h"
#include "app/store/vector_layers.h"
#include "app/text/number_text.h"
#include "gis/access/table_in.h"
#include "gis/vector/vector_in.h"
#include "params/grammar/value_text.h"
#include "params/keys/result_rasters.h"
#include "params/keys/used_keys.h"

namespace frana::app {

namespace {

/// "friction angle uniform(10, 26); ..." of a study's summary, the first keys.
std::string varied_keys(const Json& summary, const Words& words) {
    constexpr std::size_t k_most = 4;
    const auto list = summary.find("varied");
    if (list == summary.end() || !list->is_array()) return "";
    std::vector<std::string> parts;
    for (const Json& one : *list) {
        if (parts.size() == k_most) {
            parts.emplace_back("\u2026");
            break;
        }
        parts.push_back(title_in(value_in<std::string>(one, "/key").value_or(""), words) + " " +
                        value_in<std::string>(one, "/distribution").value_or(""));
    }
    return joined(parts, "; ");
}

}  // namespace

/// What maps of a study show besides their values: how many runs they are made of, and outlines of probability.
void ResultReader::add_study(MapSource& source) const {
    source.extent = raster_on(source.terrain.grid.columns > 0 ? source.terrain.grid : grid(), k_hit_count);
    const std::optional<Json> summary = has(k_summary_file) ? read_json_file(path(k_summary_file)) : std::nullopt;
    if (summary) {
        source.warnings = limits_of_use(warnings_in(*summary));
        const auto finished = value_in<std::int64_t>(*summary, "/finished"),
                   failed = value_in<std::int64_t>(*summary, "/failed");
        const auto error = value_in<double>(*summary, "/largest_standard_error");
        const bool per_polygon = value_in<std::string>(*summary, "/sampling") == "per-polygon";
        if (finished)
            source.subtitle =
                words_.labelled(words_(per_polygon ? worded("Slopes") : worded("Runs")), std::to_string(*finished));
        // A probability of values that somebody chose, and of a failure that is taken for granted: no hazard by itself.
        if (const std::string keys = varied_keys(*summary, words_); finished && !keys.empty()) {
            const auto rate = value_in<double>(*summary, "/frequency/rate_per_year");
            source.scenario =
                rate ? words_.labelled(words_("Annual rate"), words_.number(number_text(*rate, 3)) + "/a") + ". " +
                           words_.labelled(words_("Varied"), keys)
                     : words_("If the slope fails: fraction of {1} runs; varied: {2}",
                              {std::to_string(*finished), keys});
        }
        const auto troubles = troubles_in(*summary);
        if (troubles && troubles->any()) {
            const std::string told = headline(*troubles).in(words_);
            if (troubles->are_first())
                source.scenario = told + ". " + scenario_line(source);
            else
                source.notes.push_back(told);
        }
        if (troubles && troubles->warned > 0 && !troubles->are_first())
            source.notes.push_back(words_("{1} of {2} runs gave warnings",
                                          {std::to_string(troubles->warned), std::to_string(troubles->runs)}));
        if (troubles && troubles->flew > 0) source.notes.push_back(words_(k_high_flights));
        if (failed && *failed > 0)
            source.notes.push_back(words_.labelled(words_("Failed runs"), std::to_string(*failed)));
        if (error)
            source.notes.push_back(words_.labelled(words_("Standard error of the probabilities"),
                                                   "≤ " + words_.number(number_text(100 * *error, 2)) + " %"));
    }
    const std::string& crs = source.extent.grid.crs_wkt;
    const auto first = summary ? value_in<double>(*summary, "/depth_thresholds_m/0") : std::nullopt;
    const std::string threshold = first ? number_text(*first) : "?";
    for (const StudyQuantile& quantile : k_study_quantiles) {
        MultiPolygon area = outline(probability_layer(quantile.name), crs);
        if (area.empty()) continue;
        const Rgb colour = quantile.fraction < 0.5   ? k_unlikely_colour
                           : quantile.fraction > 0.5 ? k_likely_colour
                                                     : k_even_chance_colour;
        source.marks.push_back({words_("> {2} m in {1} % of the runs",
                                       {words_.number(number_text(100 * quantile.fraction)), words_.number(threshold)}),
                                std::move(area), colour, 1.6, quantile.fraction < 0.5});
    }
}

Language ResultReader::own_language() const {
    auto code = scene_value("output.language");
    if (!code && is_of_study() && has(k_summary_file))
        if (const std::optional<Json> summary = read_json_file(path(k_summary_file)))
            code = value_in<std::string>(*summary, "/language");
    return language_of_code(code.value_or("")).value_or(Language::english);
}

MapStyle ResultReader::style() const {
    MapStyle style;
    style.words = words_;
    if (const auto size = size_from_text(scene_value("output.map-size").value_or(""))) style.size = *size;
    if (const auto formats = scene_value("output.map-formats")) style.formats = words_of(*formats);
    style.background = scene_value("output.map-background").value_or("");
    style.context = scene_value("output.map-context").value_or("");
    style.attribution = scene_value("output.map-attribution").value_or("");
    if (const auto scale = scene_value("output.map-scale")) style.scale = number_from_text(*scale);
    if (const auto turn = scene_value("output.map-turn")) style.turn_deg = number_from_text(*turn);
    style.author = scene_value("output.map-author").value_or("");
    style.logo = scene_value("output.map-logo").value_or("");
    style.date = date_on_maps(scene_value("output.map-date"), run_date());
    return style;
}

std::string ResultReader::run_date() const {
    const std::optional<Json> summary = has(k_summary_file) ? read_json_file(path(k_summary_file)) : std::nullopt;
    return summary ? value_in<std::string>(*summary, "/date").value_or("") : "";
}

std::vector<std::vector<std::string>> ResultReader::figures_at(const std::vector<double>& times) const {
    std::vector<std::vector<std::string>> figures(times.size());
    if (!has(k_series_file)) return figures;
    const gis::Table table = gis::read_table(path(k_series_file), "RESULT_DIR");
    const auto column = [&](const char* name) {
        const auto place = std::find(table.columns.begin(), table.columns.end(), name) - table.columns.begin();
        std::vector<double> values;
        for (const auto& row : table.rows)
            values.push_back(place < std::ssize(row)
                                 ? number_from_text(row[static_cast<std::size_t>(place)]).value_or(k_no_data)
                                 : k_no_data);
        return values;
    };
    const std::vector<double> time = column("time_s"), volume = column("volume_m3"), area = column("covered_area_m2"),
                              front = column("front_distance_m"), speed = column("max_speed_ms");
    for (std::size_t i = 0; i < times.size(); ++i) {
        const auto nearest = std::min_element(time.begin(), time.end(), [&](double a, double b) {
            return std::abs(a - times[i]) < std::abs(b - times[i]);
        });
        if (nearest == time.end()) continue;
        const auto row = static_cast<std::size_t>(nearest - time.begin());
        const auto add = [&](const std::string& label, double value, const std::string& text) {
            if (std::isfinite(value)) figures[i].push_back(words_.labelled(label, words_.number(text)));
        };
        add(words_("Volume"), volume[row], grouped(volume[row]) + " m³");
        add(words_("Covered area"), area[row], grouped(area[row]) + " m²");
        add(words_("Front distance"), front[row], grouped(front[row]) + " m");
        add(words_("Maximum velocity"), speed[row], number_text(speed[row], 2) + " m/s");
    }
    return figures;
}

std::vector<std::string> ResultReader::release_names(const std::string& crs_wkt) const {
    const std::string file = path(k_outlines_file);
    if (!has_layer(k_outlines_file, "release")) return {};
    std::vector<std::string> names;
    bool named = false;  // else these are the areas' numbers
    for (const Feature& one : gis::read_polygons(file + "|layer=release", crs_wkt, "RESULT_DIR").features) {
        const auto name = one.texts.find("name");
        if (name == one.texts.end()) return {};
        names.push_back(name->second);
        named = named || name->second != std::to_string(names.size());
    }
    if (!named) names.clear();
    return names;
}

}  // namespace frana::app
