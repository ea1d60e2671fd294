// SPDX-License-Identifier: Apache-2.0
#include "app/pictures/map_layer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>

#include "analysis/hazard.h"
#include "analysis/trace.h"
#include "app/store/result_files.h"
#include "app/store/vector_layers.h"
#include "app/text/number_text.h"
#include "core/error.h"
#include "core/json.h"
#include "gis/raster/raster_in.h"
#include "gis/raster/raster_out.h"
#include "params/grammar/value_text.h"
#include "params/keys/result_rasters.h"
#include "params/keys/used_keys.h"

namespace frana::app {
namespace {

/// "depth > 1.5 m": the quantity before the sign or the first number.
std::string one_threshold(const std::string& english, const Words& words) {
    std::size_t end = std::string::npos;
    for (const char* sign : {" > ", " < ", " \u2264 ", " \u2265 "}) end = std::min(end, english.find(sign));
    if (end == std::string::npos) {
        const std::size_t digit = english.find_first_of("0123456789");
        if (digit == std::string::npos || digit == 0) return words(english);
        end = digit - 1;  // "depth 0.5 – 2 m"
    }
    return words(english.substr(0, end)) + words.number(english.substr(end));
}

/// "depth > 1 m and speed > 1 m/s". Alternatives may be between semicolons.
std::string thresholds(const std::string& english, const Words& words) {
    const std::string next = "; ";
    if (const std::size_t place = english.find(next); place != std::string::npos)
        return thresholds(english.substr(0, place), words) + next +
               thresholds(english.substr(place + next.size()), words);
    for (const char* conjunction : {worded("and"), worded("or")}) {
        const std::string between = " " + std::string(conjunction) + " ";
        const std::size_t place = english.find(between);
        const bool has_number = english.find_first_of("0123456789") != std::string::npos;
        if (place == std::string::npos || !has_number) continue;
        return thresholds(english.substr(0, place), words) + " " + words(conjunction) + " " +
               thresholds(english.substr(place + between.size()), words);
    }
    return one_threshold(english, words);
}

}  // namespace

std::string raster_title(const ResultRaster& row, const std::string& name, const Words& words) {
    const std::string next = ", ", value = row.by_value ? text_for(row, "{}", name) : "";
    std::string pattern = row.by_value ? text_for(row, row.title, row.of_value("{1}")) : row.title, title;
    for (std::size_t end = 0; end != pattern.npos; pattern.erase(0, end + next.size())) {
        end = pattern.find(next);
        const std::string part = pattern.substr(0, end);
        title +=
            (title.empty() ? "" : next) + (part.find(" > ") == part.npos ? words(part, {words.number(value)})
                                                                         : thresholds(Words()(part, {value}), words));
        if (end == pattern.npos) break;
    }
    return title;
}

std::string class_label(const std::string& english, const Words& words) {
    const std::size_t colon = english.find(": ");
    if (colon == std::string::npos) return thresholds(english, words);
    return words.labelled(words(english.substr(0, colon)), thresholds(english.substr(colon + 2), words));
}

Words words_of_scheme(const std::map<std::string, std::string>& metadata, const Words& words) {
    const auto found = metadata.find(k_scheme_words_item);
    if (found == metadata.end()) return words;
    const Json json = Json::parse(found->second, nullptr, false);  // a file may come from anywhere
    OwnTexts texts;
    for (const auto& [language, all] : json.items())
        for (const auto& [english, text] : all.items())
            if (text.is_string()) texts[language][english] = text.get<std::string>();
    return words.with(texts);
}

std::string scheme_title(const std::map<std::string, std::string>& metadata, const Words& words) {
    for (const char* item : {k_scheme_title_item, k_scheme_item})
        if (const auto found = metadata.find(item); found != metadata.end()) return words(found->second);
    return "";
}

namespace {

/// Returns the name in such a label, before the colon.
std::string class_name(const std::string& label) {
    std::string name = label.substr(0, label.find(':'));
    const std::string space = "\u202F";  // before a French colon
    if (name.ends_with(space)) name.resize(name.size() - space.size());
    return name;
}

constexpr const char* k_degree_map = RasterName::hazard_degree;

void hide_zeros(Raster& raster) {
    raster.values.change_each_stored([](std::size_t, double& value) {
        if (value == 0) value = k_no_data;
    });
}

/// Sets title and colours of a raster of the table; returns false for others.
bool set_from_table(const std::string& name, const Words& words, const std::string& direction, MapLayer& layer) {
    const ResultRaster* const row = find_result_raster(name);
    if (row == nullptr || !row->is_drawn()) return false;
    layer.title = raster_title(*row, name, words);
    // On steep ground vertical and normal depths differ by half; those used to other programs think of normal ones.
    if (!direction.empty()) layer.legend_title = layer.title + ", " + words(direction);
    layer.is_normal_depth = direction == k_normal;
    layer.palette = row->palette;
    layer.classes = class_bounds(*row, maximum(layer.values));
    if (row->zero_is_blank) hide_zeros(layer.values);
    return true;
}

std::string usual_palette(const std::string& unit) {
    if (unit == "s" || unit == "min" || unit == "h") return "time";
    return unit.empty() || unit == "m" ? "depth" : "velocity";
}

/// Returns "max_depth: Maximum flow depth [m]" without name and unit.
std::string bare_description(std::string text) {
    const auto colon = text.find(": ");
    if (colon != std::string::npos) text.erase(0, colon + 2);
    const auto bracket = text.rfind(" [");
    return bracket == std::string::npos ? text : text.substr(0, bracket);
}

bool has_scheme(const std::string& kind) {
    const ResultRaster* const row = find_result_raster(kind);
    return row != nullptr && row->of_scheme;
}

using Metadata = std::map<std::string, std::string>;

bool shows_zones(const Metadata& metadata) {
    const auto title = metadata.find("HAZARD_TITLE");
    return title != metadata.end() && title->second != k_intensity_title;
}

/// What the classes of a scheme mean, and the source of their limits.
std::vector<std::string> scheme_notes(const std::string& kind, const Metadata& metadata, const Words& words) {
    const bool is_degree = kind == k_degree_map;
    std::vector<std::string> notes{is_degree               ? words("Degree of hazard from intensity and return period")
                                   : shows_zones(metadata) ? words("Zones of one scenario, not a hazard zone plan")
                                                           : words("Intensity of one scenario, without its frequency")};
    if (const auto source = metadata.find("HAZARD_SOURCE"); source != metadata.end())
        notes.push_back(words.labelled(words("Source"), words(source->second)));
    return notes;
}

/// Names the scheme in the titles, and its meaning, limits and source on the map.
void add_scheme(const std::string& kind, const Metadata& metadata, const Words& words, MapLayer& layer) {
    if (shows_zones(metadata) && kind == "hazard") layer.title = words(metadata.at("HAZARD_TITLE"));
    if (const std::string title = scheme_title(metadata, words); !title.empty()) layer.title += ", " + title;
    std::vector<std::string> notes = scheme_notes(kind, metadata, words), limits;
    for (int i = 1;; ++i) {
        const auto limit = metadata.find(k_limit_item + std::to_string(i));
        if (limit == metadata.end()) break;
        limits.push_back(class_label(limit->second, words));
    }
    notes.insert(notes.begin() + 1, limits.begin(), limits.end());
    layer.notes.insert(layer.notes.begin(), notes.begin(), notes.end());
}

/// The table that gave the friction, and its source.
std::vector<std::string> friction_notes(const Metadata& metadata, const Words& words) {
    const auto table = metadata.find(k_friction_item), source = metadata.find(k_friction_source_item);
    if (table == metadata.end() || source == metadata.end()) return {};
    const std::string unread = metadata.contains(k_friction_read_item) ? "" : " (" + words("not read") + ")";
    std::vector<std::string> notes{
        words.labelled(words("Friction table"), words_of_scheme(metadata, words)(table->second)),
        words.labelled(words("Source"), source->second + unread)};
    if (const auto of = metadata.find(k_friction_of_item); of != metadata.end()) {
        const auto varied = metadata.find(k_friction_varied_item);
        for (const std::string& note :
             study_friction_notes(of->second, varied == metadata.end() ? "" : varied->second, words))
            notes.push_back(note);
    }
    return notes;
}

/// Whether a raster of maxima of a result omits what flew over its cells.
bool omits_flights(const std::string& path, const std::string& kind) {
    constexpr std::array k_of_maxima{RasterName::max_depth, RasterName::max_velocity, RasterName::max_pressure,
                                     "hazard"};
    return std::find(k_of_maxima.begin(), k_of_maxima.end(), kind) != k_of_maxima.end() &&
           std::filesystem::exists(std::filesystem::path(path).parent_path() / raster_file(RasterName::jump_height));
}

/// The name of the table's row that frana wrote to a band, before its description.
std::optional<std::string> probability_of(const gis::RasterText& text) {
    const std::string name = text.description.substr(0, text.description.find(": "));
    const ResultRaster* const row = find_result_raster(name);
    if (row == nullptr || !row->is_probability) return std::nullopt;
    return name;
}

}  // namespace

std::vector<std::string> needed_notes(const std::string& path, const Words& words) {
    const std::string kind = std::filesystem::path(path).stem().string();
    const gis::RasterText text = gis::read_raster_text(path);
    std::vector<std::string> notes = has_scheme(kind)
                                         ? scheme_notes(kind, text.metadata, words_of_scheme(text.metadata, words))
                                         : friction_notes(text.metadata, words);
    if (omits_flights(path, kind)) notes.push_back(words(k_high_flights));
    return notes;
}

std::vector<std::string> study_friction_notes(const std::string& of, const std::string& varied, const Words& words) {
    std::vector<std::string> notes{of == k_largest_friction ? words("Friction of the source with the largest area")
                                                            : words("Friction of the study's central scene")};
    std::vector<std::string> titles;
    for (const std::string& key : words_of(varied)) titles.push_back(title_in(key, words));
    if (!titles.empty()) notes.push_back(words.labelled(words("Varied"), joined(titles, ", ")));
    return notes;
}

std::optional<std::string> probability_name(const std::string& path) {
    return probability_of(gis::read_raster_text(path));
}

MapLayer read_map_layer(const std::string& path, const Words& words, bool foreign, std::optional<Raster> values) {
    const gis::RasterText text = gis::read_raster_text(path);
    MapLayer layer;
    layer.values = values ? *std::move(values) : gis::read_result_raster(path);
    if (foreign && text.classes.empty()) hide_zeros(layer.values);
    const std::filesystem::path file(path);
    layer.name = file.stem().string();
    layer.unit = text.unit;
    layer.source = file.filename().string();
    if (const auto time = text.metadata.find("TIME_S"); time != text.metadata.end())
        layer.time = number_from_text(time->second);
    // A frame's name is that of its raster and its number: depth_0012.
    std::string kind = layer.name;
    if (layer.time) kind.resize(std::min(kind.size(), kind.rfind('_')));
    if (const ResultRaster* const row = find_result_raster(kind)) {
        layer.is_surface = row->is_surface;
        layer.is_ground = row->kind == ResultRaster::Kind::given && row->is_produced_by != nullptr;
    }
    const auto probability = probability_of(text);
    const std::string direction = depth_direction(text.description);
    const bool is_known = probability ? set_from_table(*probability, words, direction, layer)
                                      : !foreign && set_from_table(kind, words, direction, layer);
    if (!is_known) {
        layer.title = bare_description(text.description);
        if (layer.title.empty()) layer.title = layer.name;
        layer.palette = usual_palette(layer.unit);
    }
    if (!text.classes.empty()) {
        layer.classes.clear();
        const Words own = words_of_scheme(text.metadata, words);
        for (const gis::NamedClass& one : text.classes)
            layer.categories.push_back({static_cast<double>(one.value), class_label(one.label, own), one.colour});
        layer.notes = class_areas(layer, words);
        if (has_scheme(kind)) add_scheme(kind, text.metadata, own, layer);
        if (const auto depth = text.metadata.find(gis::k_depth_item);
            depth != text.metadata.end() && kind != "comparison")
            layer.notes.push_back(words.labelled(words("Flow depth"), words(depth->second)));
    }
    for (std::string& note : friction_notes(text.metadata, words)) layer.notes.push_back(std::move(note));
    if (!foreign && omits_flights(path, kind)) layer.notes.push_back(words(k_high_flights));
    return layer;
}

MapLayer read_greatest_layer(const std::vector<std::string>& paths, const Words& words) {
    MapLayer layer = read_map_layer(paths.front(), words);
    for (std::size_t i = 1; i < paths.size(); ++i) {
        const Raster more = gis::read_result_raster(paths[i]);
        if (!more.grid.same_cells(layer.values.grid))
            throw Error(ErrorKind::input, Problem{"has different cells from " + paths.front(), paths[i], "", "", ""});
        more.values.for_each_stored([&](std::size_t cell, double value) {
            double& greatest = layer.values.values[cell];
            greatest = std::fmax(greatest, value);  // a number takes precedence over nodata
        });
    }
    set_from_table(layer.name.substr(0, layer.name.find_last_of('_')), words,
                   depth_direction(gis::read_raster_text(paths.front()).description), layer);
    layer.time.reset();
    return layer;
}

void open_above(MapLayer& layer) {
    if (!layer.classes.empty() && std::isfinite(layer.classes.back()))
        layer.classes.push_back(std::numeric_limits<double>::infinity());
}

std::vector<std::string> class_areas(const MapLayer& layer, const Words& words) {
    std::vector<std::string> lines;
    for (const render::ClassLabel& one : layer.categories) {
        std::int64_t cells = 0;
        layer.values.values.for_each_stored([&](std::size_t, double value) { cells += value == one.value; });
        const std::string name = class_name(one.label);
        lines.push_back(words.labelled(
            name, words.number(grouped(static_cast<double>(cells) * layer.values.grid.cell_area())) + " m²"));
    }
    return lines;
}

}  // namespace frana::app
