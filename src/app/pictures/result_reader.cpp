// SPDX-License-Identifier: Apache-2.0
#include "app/pictures/result_reader.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "analysis/ground_statistics.h"
#include "app/pictures/result_numbers.h"
#include "app/store/result_files.h"
#include "app/store/scene_identity.h"
#include "app/store/vector_layers.h"
#include "app/text/number_text.h"
#include "app/text/text_file.h"
#include "app/text/text_table.h"
#include "app/text/version.h"
#include "core/error.h"
#include "core/files.h"
#include "core/text.h"
#include "core/words/words.h"
#include "gis/crs/crs.h"
#include "gis/raster/raster_in.h"
#include "gis/vector/vector_in.h"
#include "params/grammar/ini_file.h"
#include "params/grammar/value_text.h"
#include "params/keys/parameter.h"
#include "params/keys/result_rasters.h"
#include "params/keys/scene_parameters.h"
#include "params/keys/scene_spec.h"
#include "render/map/map2d.h"

namespace frana::app {
namespace {

/// The features of all layers of the file.
std::vector<Feature> features_of(const std::string& gpkg, const std::string& crs_wkt) {
    std::vector<Feature> all;
    const std::set<std::string> filled = gis::filled_layers(gpkg, "RESULT_DIR");
    for (const VectorLayer& row : vector_layers()) {
        if (row.file != k_exposure_file || filled.count(row.name) == 0) continue;
        gis::FeatureLayer layer = gis::read_features(gpkg + "|layer=" + row.name, crs_wkt, "RESULT_DIR", "", "");
        for (Feature& one : layer.features) all.push_back(std::move(one));
    }
    return all;
}

/// Whether a feature is reached by what a raster shows: 1, 0, NaN: nobody knows. A map of an event's rate marks where
/// it happens. A map of what is exceeded once in T years marks what is reached as often, that of a scenario what the
/// scenario reaches.
double reached_on(const std::string& raster, const Feature& feature) {
    const auto number = [&](const std::string& name) {
        const auto found = feature.numbers.find(name);
        return found == feature.numbers.end() ? k_no_data : found->second;
    };
    const double any = number(k_reached), own = number(raster);
    if (!std::isnan(own)) return static_cast<double>(own > 0);  // how often, or how likely, the raster's event is
    const ResultRaster* const row = find_result_raster(raster);
    if (row == nullptr || !row->by_value || !(any > 0)) return any;
    const std::string value = raster.substr(row->of_value("").size());
    if (row->of_scenario) {
        const double depth = number(value + "_max_depth_m");
        return std::isnan(depth) ? any : static_cast<double>(depth > 0);
    }
    const double rate = number("annual_rate_reached"), years = number_from_text(value).value_or(k_no_data);
    constexpr double k_rounding = 1e-9;
    return row->joint[0] != '\0' || std::isnan(rate) ? any : static_cast<double>(rate * years >= 1 - k_rounding);
}

void add(const MixedShape& shape, render::Outline& outline) {
    outline.polygons.insert(outline.polygons.end(), shape.areas.begin(), shape.areas.end());
    outline.lines.insert(outline.lines.end(), shape.lines.begin(), shape.lines.end());
    for (const Point& place : shape.points) outline.places.push_back({"", place});
}

/// Returns the exposed features of a result for its maps: those that are reached, those that are not, and those of
/// which the map says nothing, each kind with its number; the reached ones uppermost.
/// @param raster that the map shows
std::vector<render::Outline> exposure_marks(const std::vector<Feature>& features, const std::string& raster,
                                            const Words& words) {
    std::vector<render::Outline> marks;
    const std::vector<ExposureLook>& looks = exposure_looks();
    for (auto look = looks.rbegin(); look != looks.rend(); ++look) {
        render::Outline outline{"", {}, look->colour, look->width_px, look->dashed};
        std::size_t count = 0;
        for (const Feature& one : features) {
            const double reached = reached_on(raster, one);
            if (one.shape.empty() || !(reached == look->reached || (std::isnan(reached) && std::isnan(look->reached))))
                continue;
            add(one.shape, outline);
            ++count;
        }
        if (count == 0) continue;
        outline.label = words.labelled(words(look->label), words.number(grouped(static_cast<double>(count))));
        marks.push_back(std::move(outline));
    }
    return marks;
}

}  // namespace

const ParticleQuantity* find_particle_quantity(const std::string& name) {
    static constexpr ParticleQuantity k_all[] = {{"particles", "speed_ms", "velocity", worded("Speed of particles")},
                                                 {"particle_cohesion", RasterName::cohesion_ratio,
                                                  RasterName::cohesion_ratio, worded("Cohesion left of particles")}};
    const auto* const found =
        std::find_if(std::begin(k_all), std::end(k_all), [&](const ParticleQuantity& q) { return name == q.name; });
    return found == std::end(k_all) ? nullptr : found;
}

render::Dots read_particle_dots(const std::string& path, const ParticleQuantity& quantity) {
    if (!std::filesystem::exists(path)) {
        throw Error(ErrorKind::input,
                    Problem{"the result has no particles at this time", path, "", "",
                            "Run the scene with particles-gpkg among output.formats and output.frames = on"});
    }
    const gis::ValuedPoints points =
        gis::read_valued_points(path, {quantity.attribute, "depth_m", "volume_m3"}, "particles");
    const auto &values = points.columns[0], &depths = points.columns[1], &volumes = points.columns[2];
    render::Dots dots;
    double area = 0;
    for (std::size_t i = 0; i < points.places.size(); ++i) {
        dots.dots.push_back({points.places[i], depths[i], values[i]});
        if (depths[i] > 0) area += volumes[i] / depths[i];
    }
    std::stable_sort(dots.dots.begin(), dots.dots.end(),
                     [](const render::Dot& a, const render::Dot& b) { return a.value < b.value; });
    constexpr double k_apart = 0.85;  // of the distance between particles: they remain separate
    if (!dots.dots.empty()) dots.width_m = k_apart * std::sqrt(area / static_cast<double>(dots.dots.size()));
    return dots;
}

namespace {

std::string cells_text(const GridSpec& grid) {
    return std::to_string(grid.columns) + " x " + std::to_string(grid.rows) + " cells of " +
           shortest_text(grid.cell_size) + " from " + extent_text(grid.bounds());
}

}  // namespace

void require_cells(const GridSpec& grid, const std::string& file, const GridSpec& expected, const std::string& other) {
    if (grid.same_cells(expected)) return;
    throw Error(ErrorKind::input, Problem{"does not have the cells of " + other, file, cells_text(grid),
                                          cells_text(expected), "One of the two is not from this run"});
}

namespace {

namespace fs = std::filesystem;

/// Adds the scores of a comparison's map, from the file that frana wrote. Throws Error(input) if it is truncated.
void add_statistics(const std::string& path, const Words& words, std::vector<std::string>& notes) {
    const std::optional<Json> json = read_json_file(path);
    if (!json) throw Error(ErrorKind::input, Problem{"is incomplete", path, "", "", "Compare again: frana compare"});
    const auto add = [&](const std::string& key, const std::string& label, const std::string& unit) {
        if (const auto value = value_in<double>(*json, "/" + key))
            notes.push_back(words.labelled(label, words.number(number_text(*value, 3)) + unit));
    };
    add("threshold_m", words("Depth threshold"), " m");
    const auto simulated = value_in<double>(*json, "/simulated_area_m2"),
               observed = value_in<double>(*json, "/observed_area_m2");
    if (simulated && observed && *observed > 0)
        notes.push_back(
            words.labelled(words("Area difference"),
                           words.number(signed_number_text(100 * (*simulated - *observed) / *observed)) + " %"));
    add("jaccard", "Jaccard", "");
    add("dice", "Dice", "");
}

Error newer(const std::string& file, std::int64_t format, std::int64_t known) {
    return {ErrorKind::input,
            Problem{"was written by a newer frana than this one", file, "format " + std::to_string(format),
                    "up to " + std::to_string(known), "Update frana"}};
}

// Results without a format number were written before formats had one.
void refuse_newer_summary(const std::string& path) {
    const std::optional<Json> json = read_json_file(path);
    const auto format = json ? value_in<std::int64_t>(*json, "/format") : std::nullopt;
    if (format && *format > k_result_format) throw newer(path, *format, k_result_format);
}

/// Fills cells without a value from another raster on the same grid, if they are greater than zero.
void include(Raster& extent, const Raster& more) {
    more.values.for_each_stored([&](std::size_t cell, double value) {
        if (value > 0 && std::isnan(std::as_const(extent).values[cell])) extent.values[cell] = value;
    });
}

/// Adds the names of the rasters of a row that has one for each value.
void add_files_of(const ResultRaster& row, const std::string& folder, std::vector<std::string>& names) {
    const auto first = static_cast<std::ptrdiff_t>(names.size());
    for (const fs::directory_entry& entry : folder_entries(fs::path(folder))) {
        const std::string name = entry.path().stem().string();
        if (entry.path().extension() == ".tif" && find_result_raster(name) == &row) names.push_back(name);
    }
    std::sort(names.begin() + first, names.end(), precedes);
}

}  // namespace

ResultReader::ResultReader(std::string directory, std::optional<Language> language) : directory_(std::move(directory)) {
    while (directory_.size() > 1 && directory_.back() == '/') directory_.pop_back();
    if (!fs::is_directory(directory_))
        throw Error(ErrorKind::input,
                    Problem{"is not a folder", "RESULT_DIR", directory_, "", "Name a result directory"});
    refuse_newer_summary(path(k_summary_file));
    if (const auto format = integer_from_text(scene_value("scene.format").value_or("1"));
        format && *format > k_scene_format)
        throw newer(path(k_scene_file), *format, k_scene_format);
    words_ = Words(language ? *language : own_language());
    if (is_of_study()) return;
    for (const ResultRaster& row : main_rasters())
        if (has(row.name + ".tif")) return;
    throw Error(ErrorKind::input, Problem{"contains no result: none of its rasters is there", "RESULT_DIR", directory_,
                                          "a directory that `frana run` wrote", ""});
}

std::string ResultReader::path(const std::string& name) const {
    return (fs::path(directory_) / name).string();
}

bool ResultReader::has(const std::string& name) const {
    return fs::exists(path(name));
}

bool ResultReader::is_of_study() const {
    return has(raster_file(k_hit_count));
}

void ResultReader::require(const std::string& name) const {
    if (!has(name)) throw Error(ErrorKind::input, Problem{"is missing in the result", path(name), "", "", ""});
}

Raster ResultReader::vertical_raster(const std::string& name) const {
    return scene_value("output.depth") == k_normal_depth ? vertical_depth(raster(name), raster(RasterName::bed))
                                                         : raster(name);
}

Raster ResultReader::raster(const std::string& name) const {
    require(name + ".tif");
    if (auto values = in_memory(name)) return *std::move(values);
    return gis::read_result_raster(path(name + ".tif"));
}

std::optional<Raster> ResultReader::in_memory(const std::string& name) const {
    const Raster* const found = run_ != nullptr ? run_->find_raster(name) : nullptr;
    if (found == nullptr) return std::nullopt;
    Raster values = *found;
    if (!crs_) {  // a file may have another WKT of the same
        const std::string wkt = gis::inspect_raster(path(name + ".tif"), "RESULT_DIR").crs_wkt;
        crs_ = wkt.empty() ? "" : gis::horizontal_crs(wkt);
    }
    values.grid.crs_wkt = *crs_;
    values.values.change_each_stored([](std::size_t, double& value) {
        value = std::isfinite(value) ? static_cast<double>(static_cast<float>(value)) : k_no_data;
    });
    return values;
}

Raster ResultReader::raster_on(const GridSpec& grid, const std::string& name) const {
    Raster read = raster(name);
    require_cells(read.grid, path(name + ".tif"), grid, path(grid_raster() + ".tif"));
    return read;
}

std::optional<std::string> ResultReader::scene_value(const std::string& key) const {
    if (!has(k_scene_file)) return std::nullopt;
    if (!scene_) scene_ = read_ini(path(k_scene_file));
    for (const IniEntry& entry : *scene_)
        if (present_name(entry.name) == key) {
            static const std::vector<Parameter>& k_keys = scene_parameters();
            const Parameter* const parameter = find_parameter(k_keys, key);
            if (parameter == nullptr || !parameter->reads_files()) return entry.value;
            SceneSpec scene;
            if (parameter->read(scene, entry.value)) return entry.value;
            const std::string folder = fs::absolute(directory_).string();
            parameter->map_files(scene, [&](const std::string& file) { return absolute_path(file, folder); });
            return parameter->write(scene);
        }
    return std::nullopt;
}

double ResultReader::scene_number(const std::string& key, double otherwise) const {
    const auto text = scene_value(key);
    return text ? number_from_text(*text).value_or(otherwise) : otherwise;
}

bool ResultReader::has_layer(const std::string& file, const std::string& layer) const {
    if (!has(file)) return false;
    auto& [time, filled] = layers_[file];
    if (const auto now = fs::last_write_time(path(file)); now != time) {
        filled = gis::filled_layers(path(file), "RESULT_DIR");
        time = now;
    }
    return filled.count(layer) > 0;
}

MultiPolygon ResultReader::outline(const std::string& layer, const std::string& crs_wkt) const {
    MultiPolygon all;
    // The outline of a later comparison comes before the run's own; a result without a scar has no such layer.
    const char* const name = has_layer(k_comparison_outline, layer) ? k_comparison_outline : k_outlines_file;
    const std::string file = path(name);
    if (!has_layer(name, layer)) return all;
    for (const Feature& feature : gis::read_polygons(file + "|layer=" + layer, crs_wkt, "RESULT_DIR").features)
        all.insert(all.end(), feature.shape.areas.begin(), feature.shape.areas.end());
    return all;
}

MapFacts ResultReader::facts(const std::optional<MainStatistics>& statistics) const {
    MapFacts facts;
    facts.model = scene_value("material.model").value_or("");
    facts.scheme = scene_value("numerics.scheme").value_or("unknown");
    const SeriesEnds ends = read_series_ends(path(k_series_file));
    facts.simulated_seconds = ends.simulated_seconds;
    facts.volume = ends.volume;
    facts.volume_left = ends.volume_left;
    facts.statistics = statistics ? statistics : read_main_statistics(directory_);
    return facts;
}

const GridSpec& ResultReader::grid() const {
    if (!grid_) grid_ = raster(grid_raster()).grid;
    return *grid_;
}

std::string ResultReader::grid_raster() const {
    return drawable().front();
}

const std::vector<StoredFrame>& ResultReader::frames() const {
    if (frames_.empty()) frames_ = stored_frames(path(k_frame_folder));
    return frames_;
}

const MapLayer& ResultReader::greatest(const std::string& quantity) const {
    const auto known = greatest_.find(quantity);
    if (known != greatest_.end()) return known->second;
    if (find_result_raster("max_" + quantity) != nullptr) {
        require("max_" + quantity + ".tif");
        return greatest_.emplace(quantity, map_layer("max_" + quantity)).first->second;
    }
    std::vector<std::string> files;
    for (const StoredFrame& frame : frames()) files.push_back(frame.raster_file(quantity));
    return greatest_.emplace(quantity, read_greatest_layer(files, words_)).first->second;
}

void ResultReader::show_figures_of(double time, MapLayer& layer) const {
    if (!has(k_series_file)) return;
    layer.notes = figures_at({time}).front();
    layer.notes_alone = true;  // the result's are those of the end
}

MapLayer ResultReader::particle_layer(const StoredFrame& frame, const ParticleQuantity& quantity) const {
    MapLayer layer = greatest(quantity.colours);  // maps of different times are comparable
    layer.dots = read_particle_dots(frame.particle_file, quantity);
    layer.name = quantity.name + ("_t" + number_text(frame.time, 6));
    layer.title = words_(quantity.title);
    layer.time = frame.time;
    layer.source = "frames/" + fs::path(frame.particle_file).filename().string() + ", " + quantity.attribute;
    open_above(layer);
    show_figures_of(frame.time, layer);
    layer.notes.push_back(
        words_.labelled(words_("Particles"), words_.number(grouped(static_cast<double>(layer.dots->dots.size())))));
    return layer;
}

MapLayer ResultReader::map_layer(const std::string& name) const {
    MapLayer layer = layer_of(name);
    if (!exposed_) {
        exposed_.emplace();
        if (has(k_exposure_file)) attempt([&] { exposed_ = features_of(path(k_exposure_file), grid().crs_wkt); });
    }
    layer.exposed = exposure_marks(*exposed_, layer.name, words_);
    return layer;
}

MapLayer ResultReader::layer_of(const std::string& name) const {
    const auto at = name.find('@');
    const std::string kind = name.substr(0, at);
    const ParticleQuantity* const of_particles = find_particle_quantity(kind);
    const ResultRaster* const of_frames = find_result_raster(kind);
    const auto present = [&](const std::string& raster) {
        return has(k_frame_list) && fs::exists(frames().front().raster_file(raster));
    };
    const bool in_frames = kind == "depth" || kind == "velocity" ||
                           (of_particles != nullptr && (kind == "particles" || present(of_particles->colours))) ||
                           (of_frames != nullptr && of_frames->in_frames && present(kind));
    if (at != std::string::npos && in_frames) {
        const auto time = number_from_text(name.substr(at + 1));
        if (!time) throw Error(ErrorKind::input, Problem{"contains no time", "--map", name, kind + "@SECONDS", ""});
        const std::vector<StoredFrame>& all = frames();
        const auto nearest = std::min_element(all.begin(), all.end(), [&](const auto& a, const auto& b) {
            return std::abs(a.time - *time) < std::abs(b.time - *time);
        });
        if (of_particles != nullptr) return particle_layer(*nearest, *of_particles);
        const std::string file = nearest->raster_file(kind);
        MapLayer layer = read_map_layer(file, words_);
        require_cells(layer.values.grid, file, grid(), path(grid_raster() + ".tif"));
        layer.source.insert(0, "frames/");
        layer.name = kind + "_t" + number_text(nearest->time, 6);
        // The greatest values over time define the colours, so that maps of different times are comparable.
        const bool over_frames = find_result_raster("max_" + kind) == nullptr;
        if (over_frames || has("max_" + kind + ".tif")) layer.classes = greatest(kind).classes;
        show_figures_of(nearest->time, layer);
        return layer;
    }
    if (has(name + ".tif")) {
        MapLayer layer = read_map_layer(path(name + ".tif"), words_, false, in_memory(name));
        // Other rasters of the user beside those of a run may have any grid; that of the comparison has all of a
        // surveyed outline that reaches beyond them.
        const ResultRaster* const row = find_result_raster(name);
        if (row != nullptr && row->in_result() && !(name == "comparison" && layer.values.grid.covers(grid())))
            require_cells(layer.values.grid, path(name + ".tif"), grid(), path(grid_raster() + ".tif"));
        if (row != nullptr && row->is_flow_depth && has(raster_file("release")) && has("max_depth.tif"))
            layer.classes = depth_classes();
        if (name == "comparison" && has(k_comparison_file))
            add_statistics(path(k_comparison_file), words_, layer.notes);
        return layer;
    }
    const std::string study = convergence_directory(directory_) + "/" + name + ".tif";
    if (name == RasterName::uncertainty && fs::exists(study)) return read_map_layer(study, words_);
    std::string known = joined(drawable(), ", ");
    if (has(k_frame_list)) {
        known += ", depth@SECONDS, velocity@SECONDS, particles@SECONDS";
        for (const ResultRaster& row : result_rasters())
            if (row.in_frames && present(row.name)) known += ", " + row.name + "@SECONDS";
        if (present(RasterName::cohesion_ratio)) known += ", particle_cohesion@SECONDS";
    }
    throw Error(ErrorKind::input, Problem{"is not a raster of this result", "map", name, known, ""});
}

const std::vector<double>& ResultReader::depth_classes() const {
    if (depth_classes_.empty()) {
        const Raster deepest = raster_on(grid(), RasterName::max_depth), release = raster_on(grid(), "release");
        depth_classes_ = class_bounds(*find_result_raster(RasterName::max_depth), deepest, release);
    }
    return depth_classes_;
}

std::vector<std::string> ResultReader::drawable() const {
    std::vector<std::string> names;
    for (const ResultRaster& row : result_rasters()) {
        if (!row.in_result() || !row.is_drawn()) continue;
        if (!row.by_value && has(row.name + ".tif")) names.push_back(row.name);
        if (row.by_value) add_files_of(row, directory_, names);
    }
    return names;
}

/// Places and lines of the run; files that no longer exist are omitted.
std::vector<render::Outline> ResultReader::marks(const std::string& crs_wkt) const {
    constexpr Rgb k_context{45, 45, 55}, k_zones{110, 70, 20}, k_obstacles{90, 90, 90}, k_lines{70, 50, 120},
        k_gauges{150, 0, 60};
    std::vector<render::Outline> all;
    const auto areas = [&](const std::string& key, const std::string& label, Rgb colour, bool is_dashed) {
        const auto file = scene_value(key);
        if (!file) return;
        attempt([&] {
            render::Outline outline{words_(label), {}, colour, 1.8, is_dashed};
            for (const Feature& one : gis::read_polygons(*file, crs_wkt, key).features)
                outline.polygons.insert(outline.polygons.end(), one.shape.areas.begin(), one.shape.areas.end());
            all.push_back(std::move(outline));
        });
    };
    const auto lines = [&](const std::string& file, const std::string& label, Rgb colour, bool is_dashed) {
        render::Outline outline{words_(label), {}, colour, 2, is_dashed};
        for (const gis::NamedLine& line : gis::read_marks(file, crs_wkt, label).lines)
            if (line.name != "flow path") {
                outline.lines.push_back(line.line);
                outline.names.push_back(line.name);
            }
        if (!outline.lines.empty()) all.push_back(std::move(outline));
    };
    if (const auto file = scene_value("output.map-context"))
        attempt([&] {
            render::Outline outline{words_("Surroundings"), {}, k_context, 1.4, false};
            for (const Feature& one : gis::read_features(*file, crs_wkt, "output.map-context", "", "").features)
                add(one.shape, outline);
            all.push_back(std::move(outline));
        });
    areas("terrain.friction-zones", worded("Friction zones"), k_zones, true);
    areas("terrain.obstacles", worded("Obstacles"), k_obstacles, false);
    if (const auto walls = scene_value("terrain.walls"))
        attempt([&] { lines(*walls, worded("Walls"), k_obstacles, false); });
    areas("terrain.walls", worded("Walls"), k_obstacles, false);  // of any kind
    // Files written by the run itself have not moved.
    if (has_layer(k_profile_lines, "lines"))
        lines(path(k_profile_lines) + "|layer=lines", worded("Profiles"), k_lines, true);
    if (has_layer(k_gauge_places, "sections"))
        lines(path(k_gauge_places) + "|layer=sections", worded("Cross-sections"), k_lines, false);
    if (has_layer(k_gauge_places, "gauges")) {
        render::Outline outline{words_("Gauges"), {}, k_gauges, 2, false};
        for (const gis::NamedPoint& one :
             gis::read_marks(path(k_gauge_places) + "|layer=gauges", crs_wkt, "gauges").points)
            outline.places.push_back({one.name, one.place});
        all.push_back(std::move(outline));
    }
    return all;
}

MapSource ResultReader::map_source(const std::optional<MainStatistics>& statistics) const {
    MapSource source;
    source.title =
        scene_value("output.title").value_or(fs::absolute(directory_).lexically_normal().filename().string());
    const GridSpec grid = this->grid();
    source.crs_label = gis::crs_name(grid.crs_wkt);
    source.convergence_deg =
        gis::meridian_convergence_deg(grid.crs_wkt, {(grid.west + grid.east()) / 2, (grid.south() + grid.north) / 2});
    if (has(raster_file(RasterName::dtm))) source.terrain = raster_on(grid, RasterName::dtm);
    source.release = outline("release", grid.crs_wkt);
    source.release_names = release_names(grid.crs_wkt);
    source.scar = outline("scar", grid.crs_wkt);
    source.trace = outline("trace", grid.crs_wkt);
    source.marks = marks(grid.crs_wkt);
    const auto dtm = scene_value("terrain.dtm");
    source.terrain_source =
        scene_value("terrain.source").value_or(dtm ? fs::path(*dtm).filename().string() : std::string());
    source.style = style();
    source.longitude_latitude = longitude_latitude(grid.crs_wkt);
    if (is_of_study()) add_study(source);
    if (!has("max_depth.tif") || !has("release.tif")) return source;
    const Raster release = raster_on(grid, "release");
    Raster max_depth = raster_on(grid, RasterName::max_depth);
    if (has(k_series_file)) {
        const MapFacts known = facts(statistics);
        source.subtitle = map_subtitle(known, words_);
        source.notes = map_notes(known, words_);
        source.scenario =
            scenario_words({[this](const std::string& key) { return scene_value(key); },
                            has(k_scene_file) && read_text_file(path(k_scene_file)).find("From: default\ndensity = ") !=
                                                     std::string::npos,
                            source.release_names, known.volume, known.simulated_seconds,
                            known.statistics ? known.statistics->end : std::nullopt},
                           words_);
        // A summary that is not written yet, or that of an earlier part of the run, does not know them.
        if (!statistics && has(k_summary_file))
            source.warnings = limits_of_use(warnings_in(read_json_file(path(k_summary_file)).value_or(Json::object())));
    }
    source.extent = std::move(max_depth);
    include(source.extent, release);
    // Where a surveyed outline reaches beyond the result, its comparison has other cells.
    if (has(raster_file("comparison")))
        if (const Raster comparison = raster("comparison"); comparison.grid.same_cells(grid))
            include(source.extent, comparison);
    return source;
}

}  // namespace frana::app
