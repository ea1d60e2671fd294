// SPDX-License-Identifier: Apache-2.0
#include "app/input_table.h"

#include <cstdio>
#include <filesystem>

#include "app/number_text.h"
#include "app/text_table.h"
#include "app/transform_report.h"
#include "core/json.h"
#include "gis/crs.h"

namespace frana::app {
namespace {

std::string corners(const Bounds& box, bool degrees) {
    char text[160];
    const int decimals = degrees ? 6 : 2;
    std::snprintf(text, sizeof text, "%.*f %.*f\n%.*f %.*f", decimals, box.west, decimals, box.south,
                  decimals, box.east, decimals, box.north);
    return text;
}

bool is_geographic(const std::string& crs_wkt) {
    return !crs_wkt.empty() && gis::longitude_turn(crs_wkt) > 0;
}

std::string titled(const std::string& role, const std::string& file) {
    return role + "\n" + std::filesystem::path(file).filename().string();
}

std::string resolution(const gis::RasterInfo& file) {
    const std::string unit = is_geographic(file.crs_wkt) ? " degrees" : "";
    return grouped(file.columns) + " x " + grouped(file.rows) + " of\n" + figure(file.cell_x, 6) + " x " +
           figure(file.cell_y, 6) + unit + "\n" + file.data_type + " in " + file.vertical_unit +
           (file.vertical_unit_stated ? "" : " (assumed)") + (file.rotated ? "\nrotated" : "");
}

std::string nodata(const gis::RasterInfo& file, std::int64_t cells) {
    return grouped(cells) + "\n" + (file.has_nodata ? figure(file.nodata, 9) : "none declared");
}

void add_layer(TextTable& table, const std::string& role, const std::string& file,
               const gis::PolygonLayer& layer) {
    double area_m2 = 0;
    for (const PolygonFeature& feature : layer.features) area_m2 += area(feature.parts);
    table.add({titled(role, file) + "\nlayer " + layer.layer_name, layer.crs_label,
               corners(layer.own_bounds, is_geographic(layer.crs_wkt)),
               std::to_string(layer.features.size()) + " polygons\n" + grouped(area_m2) + " m2", "",
               transform_text(layer.transform), accuracy_text(layer.transform)});
}

void add_raster(TextTable& table, const std::string& role, const gis::RasterInfo& file,
                const gis::TransformInfo& transform, const std::string& resampling,
                std::int64_t nodata_cells) {
    table.add({titled(role, file.path), file.crs_wkt.empty() ? "none" : file.crs_label,
               corners(file.bounds, is_geographic(file.crs_wkt)), resolution(file),
               nodata(file, nodata_cells), transform_text(transform) + "\nresampling: " + resampling,
               accuracy_text(transform)});
}

}  // namespace

std::string input_table(const Prepared& prepared, std::int64_t memory_bytes) {
    TextTable table({{"Input", 24},
                     {"CRS", 22},
                     {"Extent (west south, east north)", 24},
                     {"Resolution", 22},
                     {"No data", 14},
                     {"Operation to the working CRS", 34},
                     {"Accuracy", 8}});
    const TerrainInput& ground = prepared.ground;
    add_raster(table, "DTM", ground.file, ground.transform, ground.resampling_used, ground.nodata_cells);
    if (prepared.release.perimeter)
        add_layer(table, "Release perimeter", *prepared.spec.release.perimeter, *prepared.release.perimeter);
    for (const RasterUse& use : prepared.release.thickness_uses)
        add_raster(table, "Release thickness", use.file, use.transform, use.resampling, use.nodata_cells);
    if (prepared.scar) add_layer(table, "Scar", *prepared.spec.scar.perimeter, *prepared.scar);
    const GridSpec& grid = prepared.scene.grid;
    const std::string filled = ground.filled_cells > 0 ? grouped(ground.filled_cells) + " filled"
                                                       : "policy " + prepared.spec.terrain.nodata_policy;
    table.add(
        {"Working grid", ground.crs_label, corners(grid.bounds(), false),
         grouped(grid.columns) + " x " + grouped(grid.rows) + " of\n" + shortest_text(grid.cell_size) + " m",
         grouped(ground.nodata_cells) + "\n" + filled,
         "memory of a run: about " + bytes_text(static_cast<double>(memory_bytes)), ""});
    return table.text();
}

}  // namespace frana::app
