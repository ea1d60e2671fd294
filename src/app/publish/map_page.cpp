// SPDX-License-Identifier: Apache-2.0
#include "app/publish/map_page.h"

#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "analysis/exposure.h"
#include "analysis/trace.h"
#include "app/input/share_directory.h"
#include "app/pictures/map_layer.h"
#include "app/store/result_files.h"
#include "app/store/vector_layers.h"
#include "app/text/number_text.h"
#include "app/text/text_file.h"
#include "app/text/text_table.h"
#include "core/error.h"
#include "core/json.h"
#include "core/text.h"
#include "gis/raster/raster_in.h"
#include "gis/raster/raster_out.h"
#include "gis/raster/styles.h"
#include "gis/vector/vector_in.h"
#include "params/keys/result_rasters.h"

namespace frana::app {
namespace {

constexpr double k_most_cells = 1e6;
constexpr std::size_t k_most_bytes = 5'500'000;  // of packed cells: with texts and Leaflet below 6 MB
constexpr double k_of_class = 0.01, k_ground_step = 0.1;
constexpr std::int64_t k_margin = 8;  // at least, round the flow [cells]
constexpr int k_lattice = 9;          // places with known degrees along a side

/// The greatest of 1, 2, 5 times a power of ten that is not above a value.
double step_below(double value) {
    const double decade = std::pow(10.0, std::floor(std::log10(value) + 1e-9));
    for (const double factor : {5.0, 2.0})
        if (factor * decade <= value * (1 + 1e-9)) return factor * decade;
    return decade;
}

/// Packs values as share/web/map.js unpacks them.
std::string packed(const Raster& raster, double step) {
    const std::size_t count = raster.values.size();
    std::string planes(4 * count, '\0');
    for (std::int64_t row = 0; row < raster.grid.rows; ++row) {
        std::uint32_t last = 0;
        for (std::int64_t column = 0; column < raster.grid.columns; ++column) {
            const std::size_t cell = raster.index(row, column);
            const double value = raster.values[cell];
            auto steps = std::isfinite(value) ? static_cast<std::int32_t>(std::llround(value / step)) : 0;
            if (std::isfinite(value) && steps >= 0) ++steps;  // 0: no data
            const std::uint32_t difference = static_cast<std::uint32_t>(steps) - last;
            for (std::size_t byte = 0; byte < 4; ++byte)
                planes[cell + byte * count] = static_cast<char>(difference >> (8 * byte) & 0xffU);
            last = static_cast<std::uint32_t>(steps);
        }
    }
    constexpr int k_level = 4;  // a third less time than the default, a fortieth more bytes
    uLongf size = compressBound(static_cast<uLong>(planes.size()));
    std::string bytes(size, '\0');
    compress2(reinterpret_cast<Bytef*>(bytes.data()), &size, reinterpret_cast<const Bytef*>(planes.data()),
              static_cast<uLong>(planes.size()), k_level);
    return base64({bytes.data(), size});
}

Json points_json(const std::vector<Point>& points, const GridSpec& grid) {
    Json json = Json::array();
    const auto rounded = [](double metres) { return std::round(10 * metres) / 10; };
    for (const Point& point : points) json.push_back({rounded(point.x - grid.west), rounded(point.y - grid.south())});
    return json;
}

std::string css(Rgb colour) {
    return "rgb(" + std::to_string(colour.r) + "," + std::to_string(colour.g) + "," + std::to_string(colour.b) + ")";
}

Json classes_json(const std::vector<gis::ColourStop>& stops) {
    Json json = Json::array();
    for (const gis::ColourStop& stop : stops)
        json.push_back({{"to", std::isfinite(stop.value) ? Json(stop.value) : Json()},
                        {"colour", {stop.colour.r, stop.colour.g, stop.colour.b}},
                        {"label", stop.label}});
    return json;
}

class MapPage {
  public:
    MapPage(const ResultReader& result, const MapSource& source) : result_(result), source_(source) {}

    [[nodiscard]] std::string html() {
        for (const std::string& name : result_.drawable()) {
            const MapLayer layer = result_.map_layer(name);
            if (!layer.values.grid.same_cells(result_.grid())) continue;
            if (!layer.is_ground) include(layer.values);
        }
        if (window_.rows <= 0) return {};
        place_window();
        Json data{{"language", language_code(words_.language())},
                  {"crs", source_.crs_label},
                  {"grid",
                   {{"columns", grid_.columns},
                    {"rows", grid_.rows},
                    {"cell", grid_.cell_size},
                    {"west", grid_.west},
                    {"south", grid_.south()}}},
                  {"words",
                   {{"maps", words_("Maps")},
                    {"degrees", words_("Latitude, longitude")},
                    {"time", words_("Time")},
                    {"here", words_("At this place")},
                    {"play", words_("Play")},
                    {"pause", words_("Pause")},
                    {"in", words_("Zoom in")},
                    {"out", words_("Zoom out")}}},
                  {"degrees", degrees()}};
        data["ground"] = ground();
        data["along"] = Json::array();
        data["layers"] = layers(data["along"]);
        if (data["layers"].empty()) return {};
        data["first"] = first_of(data["layers"]);
        data["frames"] = frames();
        data["shapes"] = shapes();
        return page(data);
    }

  private:
    void include(const Raster& raster) {
        std::int64_t row0 = raster.grid.rows, row1 = 0, column0 = raster.grid.columns, column1 = 0;
        raster.values.for_each_stored([&](std::size_t cell, double value) {
            if (std::isnan(value)) return;
            const auto row = static_cast<std::int64_t>(cell) / raster.grid.columns;
            const auto column = static_cast<std::int64_t>(cell) % raster.grid.columns;
            row0 = std::min(row0, row);
            row1 = std::max(row1, row + 1);
            column0 = std::min(column0, column);
            column1 = std::max(column1, column + 1);
        });
        if (row1 <= row0) return;
        if (window_.rows > 0) {
            row0 = std::min(row0, window_.row);
            row1 = std::max(row1, window_.row + window_.rows);
            column0 = std::min(column0, window_.column);
            column1 = std::max(column1, window_.column + window_.columns);
        }
        window_ = {row0, column0, row1 - row0, column1 - column0};
    }
    /// With the ground round the flow.
    void place_window() {
        const GridSpec& all = result_.grid();
        const std::int64_t margin = k_margin + std::max(window_.rows, window_.columns) / 4;
        const std::int64_t row = std::max<std::int64_t>(0, window_.row - margin),
                           column = std::max<std::int64_t>(0, window_.column - margin);
        window_ = {row, column, std::min(all.rows, window_.row + window_.rows + margin) - row,
                   std::min(all.columns, window_.column + window_.columns + margin) - column};
        const auto cells = static_cast<double>(window_.rows) * static_cast<double>(window_.columns);
        factor_ = static_cast<std::int64_t>(std::ceil(std::sqrt(std::max(1.0, cells / k_most_cells))));
        grid_ = part_of(all, window_);
        grid_.columns = (grid_.columns + factor_ - 1) / factor_;
        grid_.rows = (grid_.rows + factor_ - 1) / factor_;
        grid_.cell_size *= static_cast<double>(factor_);
    }
    /// The window's blocks of cells, each with its greatest value, or the least. Of a large map only the cells that it
    /// stores are visited.
    [[nodiscard]] Raster shown(const Raster& raster, bool least = false) const {
        Raster blocks(grid_, k_no_data);
        raster.values.for_each_stored([&](std::size_t cell, double value) {
            const auto row = static_cast<std::int64_t>(cell) / raster.grid.columns - window_.row;
            const auto column = static_cast<std::int64_t>(cell) % raster.grid.columns - window_.column;
            if (row < 0 || column < 0 || row >= window_.rows || column >= window_.columns) return;
            double& block = blocks.at(row / factor_, column / factor_);
            block = least ? std::fmin(block, value) : std::fmax(block, value);
        });
        return blocks;
    }
    /// The cells of a raster with their step; nothing where the page has no room, which `what` tells.
    [[nodiscard]] std::optional<Json> cells(const Raster& raster, double step, const std::string& what) {
        std::string text = packed(raster, step);
        if (bytes_ + text.size() > k_most_bytes) {
            if (std::find(left_out_.begin(), left_out_.end(), what) == left_out_.end()) left_out_.push_back(what);
            return std::nullopt;
        }
        bytes_ += text.size();
        return Json{{"step", step}, {"cells", std::move(text)}};
    }
    [[nodiscard]] Json ground() {
        if (!result_.has(raster_file(RasterName::dtm))) return {};
        const Raster terrain = result_.raster(RasterName::dtm);
        if (!terrain.grid.same_cells(result_.grid())) return {};
        std::optional<Json> json = cells(shown(terrain), k_ground_step, words_("Elevation"));
        if (json) (*json)["title"] = words_("Elevation");
        return json ? *json : Json();
    }
    /// Degrees change so evenly over a map that nine places along a side give them to a centimetre.
    [[nodiscard]] Json degrees() const {
        if (!source_.longitude_latitude) return {};
        Json json{{"count", k_lattice}, {"longitudes", Json::array()}, {"latitudes", Json::array()}};
        const Bounds box = grid_.bounds();
        for (int j = 0; j < k_lattice; ++j)
            for (int i = 0; i < k_lattice; ++i) {
                const Point place = source_.longitude_latitude(
                    {box.west + box.width() * i / (k_lattice - 1), box.south + box.height() * j / (k_lattice - 1)});
                json["longitudes"].push_back(place.x);
                json["latitudes"].push_back(place.y);
            }
        return json;
    }
    /// Title, unit, classes and step of a layer.
    [[nodiscard]] Json look(const MapLayer& layer) const {
        Json json{{"name", layer.name},
                  {"title", shown_text(layer.legend_title.empty() ? layer.title : layer.legend_title)},
                  {"unit", layer.unit == "-" ? "" : layer.unit}};
        if (!layer.categories.empty()) {
            json["exact"] = true;
            json["classes"] = Json::array();
            for (const render::ClassLabel& one : layer.categories)
                json["classes"].push_back(
                    {{"to", one.value}, {"colour", {one.colour.r, one.colour.g, one.colour.b}}, {"label", one.label}});
            return json;
        }
        json["classes"] =
            classes_json(gis::class_stops(palette(layer.palette), bounds_of(layer), json["unit"], words_));
        return json;
    }
    static std::vector<double> bounds_of(const MapLayer& layer) {
        return layer.classes.empty() ? class_bounds(false, maximum(layer.values)) : layer.classes;
    }
    /// Classes are exact, other values in hundredths of the least class.
    static double step_of(const MapLayer& layer) {
        if (!layer.categories.empty()) return 1;
        for (const double bound : bounds_of(layer))
            if (bound > 0) return step_below(k_of_class * bound);
        return k_of_class;
    }
    [[nodiscard]] Json layers(Json& along) {
        Json all = Json::array();
        for (const std::string& name : result_.drawable()) {
            const MapLayer layer = result_.map_layer(name);
            if (!layer.values.grid.same_cells(result_.grid())) continue;
            Json json = look(layer);
            const double step = step_of(layer);
            const auto packed_cells = cells(shown(layer.values, layer.palette == "time"), step, layer.title);
            if (!packed_cells) continue;
            json.update(*packed_cells);
            add_doubt(name, step, json);
            json["notes"] = layer.notes;
            if (layer.unit == "m" || layer.unit == "m/s") {
                std::string unit = layer.unit;
                std::erase(unit, '/');
                json["column"] = name + "_" + unit;
                if (along.size() < 4) along.push_back(name);
            }
            all.push_back(std::move(json));
        }
        return all;
    }
    /// The layer that is shown at first.
    static std::string first_of(const Json& layers) {
        for (const char* shown :
             {RasterName::hazard_degree, RasterName::max_depth, "annual_rate_depth", "probability_depth"})
            for (const Json& layer : layers)
                if (const std::string name = layer["name"]; name.starts_with(shown)) return name;
        return layers.front()["name"];
    }
    /// The margin of a chance, the interval of a value, the bound that open runs leave: further bands of its file, as
    /// "probability_depth_1_margin: ...".
    void add_doubt(const std::string& name, double step, Json& json) {
        const std::string file = result_.path(raster_file(name));
        int band = 1;
        for (const std::string& description : gis::read_raster_text(file).further) {
            ++band;
            const std::string own = description.substr(0, description.find(':'));
            if (!own.starts_with(name + "_")) continue;
            if (auto one = cells(shown(gis::read_result_raster(file, band)), step, json["title"]))
                json[own.substr(name.size() + 1)] = *std::move(one);
        }
    }
    [[nodiscard]] Json frames() {
        if (!result_.has(k_frame_list) || result_.frames().empty()) return {};
        const MapLayer first = result_.map_layer("depth@0");
        Json json = look(first), list = Json::array();
        for (const StoredFrame& frame : result_.frames()) {
            const Raster depth = gis::read_result_raster(frame.raster_file("depth"));
            if (!depth.grid.same_cells(result_.grid())) return {};
            std::optional<Json> one = cells(shown(depth), step_of(first), words_("Time"));
            if (!one) return {};
            (*one)["time"] = frame.time;
            list.push_back(std::move(*one));
        }
        json["list"] = std::move(list);
        return json;
    }
    /// "Maximum depth [m]" of max_depth, "Maximum depth [m], T100" of T100_max_depth; others are their own title.
    static std::string column_title(const std::string& column, const gis::AttributeTitles& titles) {
        std::string found = column;
        std::size_t longest = 0;
        for (const auto& [name, title] : titles) {
            const bool is_whole = column == name, is_of_scenario = (name.starts_with("max_") || name == "intensity") &&
                                                                   column.ends_with('_' + name);
            if (name.size() <= longest || !(is_whole || is_of_scenario)) continue;
            longest = name.size();
            found = is_whole ? title : title + ", " + column.substr(0, column.size() - name.size() - 1);
        }
        return found;
    }
    /// Attributes that frana titles, those of the user, each by name. What a file needs for itself is not among them.
    [[nodiscard]] Json rows_of(const Feature& feature, const gis::AttributeTitles& titles) const {
        std::vector<std::pair<std::string, std::string>> known, own;
        const auto add = [&](const std::string& column, const std::string& text) {
            const bool is_named =
                column == "exposed" && std::any_of(feature.texts.begin(), feature.texts.end(), [&](const auto& one) {
                    return one.first != column && one.second == text;
                });
            if (column == "feature" || is_named || text == k_on_map) return;
            const std::string title = column_title(column, titles);
            (title == column ? own : known).emplace_back(title, text);
        };
        for (const auto& [column, text] : feature.texts)
            if (!text.empty()) add(column, text);
        for (const auto& [column, number] : feature.numbers)
            if (std::isfinite(number)) add(column, words_.number(number_text(number, 4)));
        Json rows = Json::array();
        for (auto* const some : {&own, &known}) {
            std::sort(some->begin(), some->end(),
                      [](const auto& one, const auto& other) { return precedes(one.first, other.first); });
            for (const auto& [title, text] : *some) rows.push_back({shown_text(title), shown_text(text)});
        }
        return rows;
    }
    [[nodiscard]] Json feature_json(const Feature& feature, const gis::AttributeTitles& titles) const {
        Json json{{"rows", rows_of(feature, titles)}};
        if (const auto reached = feature.numbers.find(k_reached); reached != feature.numbers.end())
            for (const ExposureLook& one : exposure_looks())
                if (one.reached == reached->second) json["colour"] = css(one.colour);
        if (!feature.shape.points.empty()) json["points"] = points_json(feature.shape.points, grid_);
        if (!feature.shape.lines.empty())
            for (const Polyline& line : feature.shape.lines) json["lines"].push_back(points_json(line, grid_));
        for (const Polygon& polygon : feature.shape.areas) json["areas"].push_back(rings_json(polygon));
        return json;
    }
    [[nodiscard]] Json rings_json(const Polygon& polygon) const {
        Json rings{points_json(polygon.outer, grid_)};
        for (const Ring& hole : polygon.holes) rings.push_back(points_json(hole, grid_));
        return rings;
    }
    /// What the scene gave to be seen and no file of the result has, as far as it meets the map: surroundings, walls,
    /// obstacles, zones. Nothing can be asked of it.
    void add_given(Json& all) {
        const Bounds box = grid_.bounds();
        const auto meets = [&](const std::vector<Point>& line) {
            Bounds of{HUGE_VAL, HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
            for (const Point& p : line)
                of = {std::min(of.west, p.x), std::min(of.south, p.y), std::max(of.east, p.x), std::max(of.north, p.y)};
            return of.west <= box.east && of.east >= box.west && of.south <= box.north && of.north >= box.south;
        };
        for (const render::Outline& mark : source_.marks) {
            if (std::any_of(all.begin(), all.end(), [&](const Json& one) { return one["title"] == mark.label; }))
                continue;
            Json features = Json::array();
            const auto add = [&](const char* kind, Json part) {
                features.push_back({{"rows", Json::array()}, {kind, Json::array({std::move(part)})}});
            };
            for (const Polygon& polygon : mark.polygons)
                if (meets(polygon.outer)) add("areas", rings_json(polygon));
            for (const Polyline& line : mark.lines)
                if (meets(line)) add("lines", points_json(line, grid_));
            if (features.empty()) continue;
            const std::size_t bytes = features.dump().size();
            if (bytes_ + bytes > k_most_bytes) {
                left_out_.push_back(mark.label);
                continue;
            }
            bytes_ += bytes;
            const Json one{{"title", mark.label},    {"colour", css(mark.colour)},
                           {"width", mark.width_px}, {"dashed", mark.dashed},
                           {"visible", true},        {"features", std::move(features)}};
            all.insert(all.begin(), one);
        }
    }
    [[nodiscard]] Json shapes() {
        Json all = Json::array();
        const gis::AttributeTitles titles = attribute_titles(words_);
        for (const VectorLayer& row : vector_layers()) {
            if (row.name == "members" || row.name == "stations" || !result_.has_layer(row.file, row.name)) continue;
            const std::string file = result_.path(row.file) + "|layer=" + row.name;
            Json features = Json::array();
            for (const Feature& feature : gis::read_features(file, "", row.file, "", "").features)
                if (!feature.shape.empty()) features.push_back(feature_json(feature, titles));
            if (!all.empty() && all.back()["title"] == layer_title(row, words_)) {  // points, lines and areas are one
                for (Json& feature : features) all.back()["features"].push_back(std::move(feature));
                continue;
            }
            const bool is_main =
                row.file != k_member_outlines && (row.file != k_outlines_file || row.name == "release" ||
                                                  row.name == "scar");  // slopes are the releases
            all.push_back({{"title", layer_title(row, words_)},
                           {"colour", css(row.look.colour)},
                           {"width", 1 + 2 * row.look.width_mm},
                           {"dashed", row.look.dashed},
                           {"visible", is_main},
                           {"features", std::move(features)}});
            if (row.file != k_exposure_file) continue;
            for (const ExposureLook& one : exposure_looks())
                all.back()["looks"].push_back({{"colour", css(one.colour)}, {"label", words_(one.label)}});
        }
        add_given(all);
        return all;
    }
    [[nodiscard]] std::string page(const Json& data) const {
        const auto text = [&](const std::string& english) { return escaped_markup(words_(english)); };
        const auto part = [](const std::string& path) {
            std::string bytes = read_text_file(path);
            if (bytes.empty())
                throw Error(ErrorKind::environment, Problem{"a part of map.html is missing", path, "", "",
                                                            "Install frana whole, and Debian's libjs-leaflet"});
            return bytes;
        };
        const auto web = [&](const char* file) { return part(share_directory() + "/web/" + file); };
        const auto leaflet = [&](const char* file) { return part(std::string(FRANA_LEAFLET "/") + file); };
        std::string json = data.dump(-1, ' ', false, Json::error_handler_t::replace), notes;
        for (std::size_t at = 0; (at = json.find('<', at)) != std::string::npos;) json.replace(at, 1, "\\u003c");
        if (factor_ > 1)
            notes +=
                words_("Cells of {1} m: the greatest value", {words_.number(number_text(grid_.cell_size, 4))}) + ". ";
        if (!left_out_.empty()) notes += words_.labelled(words_("Left out"), joined(left_out_, ", ")) + ". ";
        std::string style = leaflet("leaflet.css");  // its pictures are not used
        for (std::size_t at = 0; (at = style.find("background-image:url(", at)) != std::string::npos;)
            style.erase(at, style.find(')', at) + 1 - at);
        return "<!DOCTYPE html>\n<html lang=\"" + language_code(words_.language()) +
               "\">\n<head>\n<meta charset=\"utf-8\">\n"
               "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src 'unsafe-inline'; "
               "style-src 'unsafe-inline'; img-src data:\">\n"
               "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
               escaped_markup(source_.title) + "</title>\n<style>" + style + "</style>\n<style>" + web("map.css") +
               "</style>\n</head>\n<body>\n<header><h1>" + escaped_markup(source_.title) + "</h1><p>" +
               escaped_markup(
                   sentences(scenario_line(source_), source_.one_run.empty() ? "" : words_(source_.one_run))) +
               "</p><p class=\"screen\">" +
               text(worded("Click for values; with the keyboard, Enter asks for the middle.")) +
               "</p></header>\n<div id=\"map\" tabindex=\"0\" role=\"application\" aria-label=\"" +
               text(worded("Maps")) + "\"></div>\n<aside>\n<label class=\"screen\">" + text(worded("Maps")) +
               "<select id=\"layer\"></select></label>\n<fieldset id=\"time\" class=\"screen\"><legend>" +
               text(worded("Time")) +
               " <span id=\"time-text\"></span></legend><label><input type=\"range\" id=\"frame\" min=\"0\" "
               "value=\"0\" "
               "aria-label=\"" +
               text(worded("Time")) + "\"></label><button id=\"play\" type=\"button\" aria-pressed=\"false\">" +
               text(worded("Play")) + "</button></fieldset>\n<div id=\"legend\"></div>\n<label class=\"screen\">" +
               text(worded("Opacity")) +
               "<input type=\"range\" id=\"opacity\" min=\"0\" max=\"100\" value=\"75\"></label>\n"
               "<fieldset id=\"outlines\"><legend>" +
               text(worded("Outlines")) +
               "</legend></fieldset>\n<button id=\"line\" type=\"button\" aria-pressed=\"false\">" +
               text(worded("Values along a line")) + "</button><p id=\"line-help\" class=\"small\" hidden>" +
               text(worded("Click its points; double-click ends it.")) +
               "</p><button id=\"save\" type=\"button\" hidden>" + text(worded("Save as CSV")) +
               "</button>\n<div id=\"chart\"></div>\n<div id=\"values\" aria-live=\"polite\"></div>\n"
               "<p class=\"small\">" +
               escaped_markup(notes + map_sources(source_)) +
               "</p>\n</aside>\n<script type=\"application/json\" id=\"data\">" + json + "</script>\n<script>" +
               leaflet("leaflet.min.js") + "</script>\n<script>\n" + web("map.js") + "</script>\n</body>\n</html>\n";
    }

    const ResultReader& result_;
    const MapSource& source_;
    Words words_ = result_.words();
    CellWindow window_{0, 0, 0, 0};
    std::int64_t factor_ = 1;  ///< of the result's cells along the side of one that is shown
    GridSpec grid_;            ///< that is shown
    std::size_t bytes_ = 0;
    std::vector<std::string> left_out_;
};

}  // namespace

void write_map_page(const ResultReader& result, const MapSource& source) {
    const std::string html = MapPage(result, source).html();
    if (!html.empty()) write_text_file(result.path(k_map_page_file), html);
}

}  // namespace frana::app
