// SPDX-License-Identifier: Apache-2.0
#include "app/publish/report_maps.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "app/publish/html_page.h"
#include "app/store/result_files.h"
#include "app/store/vector_layers.h"
#include "app/text/number_text.h"
#include "params/grammar/value_text.h"
#include "params/keys/result_rasters.h"

namespace frana::app {
namespace {

namespace fs = std::filesystem;

const char* const k_main_map = "max_depth";

/// "Maximum depth, at most 12 m", or the areas of the classes.
std::string range_text(const ReportInput& input, const ResultRaster& row) {
    const Words& words = input.words;
    if (row.kind == ResultRaster::Kind::classes) {
        std::vector<std::string> areas;
        for (const HazardArea& area : input.hazard)
            areas.push_back(words(area.kind.name) + " " + words.number(grouped(area.area_m2)) + " m²");
        return joined(areas, ", ");
    }
    const Raster* const raster = input.result.find_raster(row.name);
    if (raster == nullptr || raster->values.size() == 0) return "";
    double greatest = -std::numeric_limits<double>::infinity();
    raster->values.for_each_stored([&](std::size_t, double value) {
        if (std::isfinite(value)) greatest = std::max(greatest, value);
    });
    if (!std::isfinite(greatest)) return "";
    return words("at most {1}", {words.number(number_text(greatest, 3)) +
                                 (row.unit.empty() || row.unit == "-" ? "" : " " + row.unit)});
}

ReportMap described(const ReportInput& input, const std::string& name, const std::string& file) {
    const Words& words = input.words;
    const std::string layer = raster_of_map(name);
    const bool is_view = layer != name;
    const ResultRaster* const row = find_result_raster(layer);
    const std::string title = row == nullptr ? layer : words(row->title);
    const std::string range = row == nullptr ? "" : range_text(input, *row);
    ReportMap map{name, file, title, ""};
    if (is_view) map.caption += ", " + words("in perspective");
    if (!range.empty()) map.caption += ": " + range;
    const MainStatistics& main = input.facts.statistics;
    const std::vector<std::string> values{map.caption, words.number(grouped(main.covered_area_m2)),
                                          words.number(number_text(main.threshold)),
                                          words.number(grouped(main.run_out().horizontal_m))};
    map.alt = is_view ? words("View of the slope. {1}. Covered {2} m² deeper than {3} m, run-out {4} m", values)
                      : words("Map. {1}. Covered {2} m² deeper than {3} m, run-out {4} m", values);
    return map;
}

}  // namespace

std::vector<ReportMap> report_maps(const ReportInput& input, const ResultDirectory& directory) {
    std::vector<ReportMap> maps;
    for (const std::string& name : map_names())
        if (const std::string file = drawn_for_page(directory.folder(), directory.path("maps/" + name + ".png"));
            fs::exists(file))
            maps.push_back(described(input, name, file));
    std::stable_partition(maps.begin(), maps.end(), [](const ReportMap& map) { return map.name == k_main_map; });
    return maps;
}

}  // namespace frana::app
