// SPDX-License-Identifier: Apache-2.0
#include "app/commands/input_table.h"

#include <cstdio>
#include <filesystem>

#include "app/input/transform_report.h"
#include "app/process/terminal.h"
#include "app/text/number_text.h"
#include "app/text/text_table.h"
#include "core/shortest_text.h"

namespace frana::app {
namespace {

std::string corners(const Bounds& box, bool degrees) {
    char text[160];
    const int decimals = degrees ? 6 : 2;
    std::snprintf(text, sizeof text, "%.*f %.*f\n%.*f %.*f", decimals, box.west, decimals, box.south, decimals,
                  box.east, decimals, box.north);
    return text;
}

void add(TextTable& table, const UsedFile& file) {
    const std::string name = file.role + "\n" + std::filesystem::path(file.path).filename().string() +
                             (file.layer.empty() ? "" : "\nlayer " + file.layer);
    const bool placed = !file.crs_label.empty();  // a table of numbers has no position
    table.add(
        {name, file.crs_label, placed ? corners(file.bounds, file.degrees) : "", file.content, file.nodata,
         placed ? transform_text(file.transform) + (file.resampling.empty() ? "" : "\nresampling: " + file.resampling)
                : "",
         placed ? accuracy_text(file.transform) : ""});
}

}  // namespace

std::string input_table(const Prepared& prepared, std::int64_t memory_bytes) {
    TextTable table({{"Input", 24},
                     {"CRS", 22},
                     {"Extent (west south, east north)", 31},
                     {"Resolution, content", 22},
                     {"No data", 14},
                     {"Operation to the working CRS", 34},
                     {"Accuracy", 8}});
    for (const UsedFile& file : prepared.files) add(table, file);
    const TerrainInput& ground = prepared.ground;
    const GridSpec& grid = prepared.scene.grid;
    const std::string filled = ground.filled_cells > 0 ? grouped(ground.filled_cells) + " filled"
                                                       : "policy " + prepared.spec.terrain.nodata_policy;
    table.add({"Working grid", ground.crs_label, corners(grid.bounds(), false),
               grouped(grid.columns) + " x " + grouped(grid.rows) + " of\n" + shortest_text(grid.cell_size) + " m",
               grouped(ground.nodata_cells) + "\n" + filled,
               "memory of a run: about " + bytes_text(static_cast<double>(memory_bytes)), ""});
    return table.text(output_width());
}

}  // namespace frana::app
