// SPDX-License-Identifier: Apache-2.0
#include "app/result_reader.h"

#include <filesystem>
#include <fstream>

#include "analysis/trace.h"
#include "core/error.h"
#include "gis/crs.h"
#include "gis/raster_in.h"
#include "gis/vector_in.h"
#include "params/ini_file.h"
#include "params/scene_spec.h"

namespace frana::app {
namespace {

namespace fs = std::filesystem;

/// First and last rows of timeseries.csv as numbers by column name; empty where the file is missing.
struct SeriesEnds {
    std::vector<std::string> names;
    std::vector<double> first, last;

    [[nodiscard]] static double value(const SeriesEnds& ends, const std::vector<double>& row,
                                      const std::string& name) {
        for (std::size_t i = 0; i < ends.names.size() && i < row.size(); ++i)
            if (ends.names[i] == name) return row[i];
        return 0;
    }
};

SeriesEnds read_series_ends(const std::string& path) {
    SeriesEnds ends;
    std::ifstream file(path);
    std::string line;
    if (!std::getline(file, line)) return ends;
    ends.names = words_of(trimmed(line));
    while (std::getline(file, line)) {
        std::vector<double> row;
        for (const std::string& word : words_of(trimmed(line)))
            row.push_back(number_from_text(word).value_or(0));
        if (ends.first.empty()) ends.first = row;
        ends.last = row;
    }
    return ends;
}

}  // namespace

ResultReader::ResultReader(std::string directory) : directory_(std::move(directory)) {
    while (directory_.size() > 1 && directory_.back() == '/') directory_.pop_back();
    if (!fs::is_directory(directory_))
        throw Error(ErrorKind::input,
                    Problem{"is not a folder", "RESULT_DIR", directory_, "", "Name a result directory"});
    for (const Layer& layer : result_layers())
        if (has(layer.name + ".tif")) return;
    throw Error(ErrorKind::input, Problem{"holds no result: not one of its rasters is there", "RESULT_DIR",
                                          directory_, "a directory that `frana run` wrote", ""});
}

std::string ResultReader::path(const std::string& name) const {
    return (fs::path(directory_) / name).string();
}

bool ResultReader::has(const std::string& name) const {
    return fs::exists(path(name));
}

Raster ResultReader::raster(const std::string& name) const {
    if (!has(name + ".tif"))
        throw Error(ErrorKind::input, Problem{"is missing in the result", path(name + ".tif"), "", "", ""});
    return gis::read_result_raster(path(name + ".tif"));
}

std::optional<std::string> ResultReader::scene_value(const std::string& key) const {
    if (!has("scene.ini")) return std::nullopt;
    for (const IniEntry& entry : read_ini(path("scene.ini")))
        if (entry.name == key) return entry.value;
    return std::nullopt;
}

double ResultReader::scene_number(const std::string& key, double otherwise) const {
    const auto text = scene_value(key);
    return text ? number_from_text(*text).value_or(otherwise) : otherwise;
}

MultiPolygon ResultReader::outline(const std::string& layer, const std::string& crs_wkt) const {
    MultiPolygon all;
    if (!has("extent.gpkg")) return all;
    try {
        const gis::PolygonLayer read =
            gis::read_polygons(path("extent.gpkg") + "|layer=" + layer, crs_wkt, "extent.gpkg");
        for (const PolygonFeature& feature : read.features)
            all.insert(all.end(), feature.parts.begin(), feature.parts.end());
    } catch (const Error&) {
        all.clear();  // a result without a scar has no such layer
    }
    return all;
}

MapFacts ResultReader::facts() const {
    MapFacts facts;
    facts.model = scene_value("material.model").value_or("");
    facts.scheme = scene_value("numerics.scheme").value_or("unknown");
    facts.threshold = scene_number("output.trace-threshold", OutputSpec{}.trace_threshold);
    const SeriesEnds ends = read_series_ends(path("timeseries.csv"));
    facts.simulated_seconds = SeriesEnds::value(ends, ends.last, "time_s");
    facts.volume = SeriesEnds::value(ends, ends.first, "volume_m3") +
                   SeriesEnds::value(ends, ends.first, "volume_left_m3");
    facts.volume_left = SeriesEnds::value(ends, ends.last, "volume_left_m3");
    facts.last_speed = SeriesEnds::value(ends, ends.last, "max_speed_ms");
    const Raster trace = trace_mask(raster("max_depth"), facts.threshold);
    facts.covered_area = masked_area(trace);
    facts.run_out = runout(raster("bed"), raster("release"), trace);
    return facts;
}

MapSource ResultReader::map_source() const {
    MapSource source;
    source.title =
        scene_value("output.title").value_or(fs::absolute(directory_).lexically_normal().filename().string());
    std::string any;
    for (const Layer& layer : result_layers())
        if (any.empty() && has(layer.name + ".tif")) any = layer.name;
    const GridSpec grid = raster(any).grid;
    source.crs_label = gis::crs_name(grid.crs_wkt);
    source.convergence_deg = gis::meridian_convergence_deg(
        grid.crs_wkt, {(grid.west + grid.east()) / 2, (grid.south() + grid.north) / 2});
    if (has("dtm.tif")) source.terrain = raster("dtm");
    source.release = outline("release", grid.crs_wkt);
    source.scar = outline("scar", grid.crs_wkt);
    if (has("timeseries.csv") && has("max_depth.tif") && has("bed.tif") && has("release.tif")) {
        const MapFacts known = facts();
        source.subtitle = map_subtitle(known);
        source.notes = map_notes(known);
    }
    return source;
}

}  // namespace frana::app
