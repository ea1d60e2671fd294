// SPDX-License-Identifier: Apache-2.0
#include "app/input/prepare_obstacles.h"

#include <algorithm>
#include <cmath>

#include "app/input/layer_values.h"
#include "app/input/transform_report.h"
#include "app/text/number_text.h"
#include "core/counted_texts.h"
#include "core/words/words.h"
#include "gis/raster/footprint.h"
#include "gis/vector/vector_in.h"

namespace frana::app {
namespace {

// A footprint on the grid larger than drawn by this factor gives a warning.
constexpr double k_widened = 1.5;

std::optional<gis::PolygonLayer> read_layer(const SceneReading& reading, const std::string& key,
                                            const std::string& file, const TerrainInput* ground,
                                            std::vector<UsedFile>& files, RunLog& log, Problems& problems) {
    gis::PolygonLayer layer = gis::read_polygons(file, target_crs(reading, ground), reading.where(key));
    log.note(key + " " + file + ": " + std::to_string(layer.features.size()) + " features in " + layer.crs_label);
    log.warn_of(key, layer.warnings);
    files.push_back(used_polygons(key == "terrain.walls" ? worded("Walls") : worded("Obstacles"), file, layer));
    if (ground != nullptr) report_transform(key, layer.transform, ground->terrain.grid.cell_size, log);
    if (ground == nullptr || !is_on_ground(reading, key, layer.bounds, *ground, false, problems)) return std::nullopt;
    return layer;
}

/// Sets every cell of a feature to at least `value`; logs how much larger the footprint became if it is thin.
void stamp(const gis::PolygonLayer& layer, std::size_t feature, double value, const std::string& key, Raster& raster,
           CountedTexts& warnings, Problems& problems, const std::string& where) {
    const MultiPolygon& parts = layer.features[feature].parts;
    std::int64_t cells = 0;
    gis::visit_cells(parts, raster.grid, gis::Cover::closed, [&](std::int64_t row, std::int64_t column) {
        ++cells;
        raster.at(row, column) = std::max(raster.at(row, column), value);
    });
    const double footprint = static_cast<double>(cells) * raster.grid.cell_area(), drawn = area(parts);
    if (cells == 0) {
        problems.add({feature_name(layer, feature) + " covers no cell", where, grouped(drawn) + " m2", "",
                      "Choose smaller cells"});
    } else if (footprint > k_widened * drawn) {
        warnings.add("narrow", worded("{1}: feature {2} of {3} is narrower than the cells: it covers {4} m2 of the "
                                      "working grid, the drawn area is {5} m2; choose smaller cells",
                                      {key, std::to_string(feature + 1), layer.layer_name, numeral(grouped(footprint)),
                                       numeral(grouped(drawn))}));
    }
}

void raise_ground(const SceneReading& reading, TerrainInput* ground, std::vector<UsedFile>& files, RunLog& log,
                  Problems& problems) {
    const TerrainSpec& spec = reading.scene.terrain;
    const std::string key = "terrain.obstacles";
    const auto layer = read_layer(reading, key, *spec.obstacles, ground, files, log, problems);
    if (!layer || !spec.obstacle_height) return;
    Raster height(ground->terrain.grid);
    CountedTexts warnings;
    for (std::size_t f = 0; f < layer->features.size(); ++f) {
        const auto metres = value_of(reading, "terrain.obstacle-height", *spec.obstacle_height, *layer, f, problems);
        if (metres) stamp(*layer, f, *metres, key, height, warnings, problems, reading.where(key));
    }
    for (const Sentence& warning : warnings.texts()) log.warn(warning);
    double most = 0;
    std::int64_t raised = 0;
    height.values.for_each_stored([&](std::size_t cell, double metres) {
        if (!(metres > 0)) return;
        ground->terrain.values[cell] += metres;
        most = std::max(most, metres);
        ++raised;
    });
    log.note("obstacles raise " + grouped(raised) + " cells of the bed by up to " + number_text(most, 4) + " m");
}

}  // namespace

std::optional<Raster> prepare_obstacles(const SceneReading& reading, TerrainInput* ground, std::vector<UsedFile>& files,
                                        RunLog& log, Problems& problems) {
    const TerrainSpec& spec = reading.scene.terrain;
    std::optional<Raster> walls;
    try {
        if (spec.obstacles) raise_ground(reading, ground, files, log, problems);
    } catch (const Error& error) {
        problems.add(error);
    }
    try {
        if (!spec.walls) return walls;
        const std::string key = "terrain.walls";
        const auto layer = read_layer(reading, key, *spec.walls, ground, files, log, problems);
        if (!layer) return walls;
        walls.emplace(ground->terrain.grid);
        CountedTexts warnings;
        for (std::size_t f = 0; f < layer->features.size(); ++f)
            stamp(*layer, f, 1, key, *walls, warnings, problems, reading.where(key));
        for (const Sentence& warning : warnings.texts()) log.warn(warning);
        std::int64_t cells = 0;
        walls->values.for_each_stored([&](std::size_t, double wall) { cells += wall == 1; });
        log.note("walls stand on " + grouped(cells) + " cells");
    } catch (const Error& error) {
        problems.add(error);
    }
    return walls;
}

}  // namespace frana::app
