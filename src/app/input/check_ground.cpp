// SPDX-License-Identifier: Apache-2.0
#include "app/input/check_ground.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "analysis/touched_cells.h"
#include "app/text/number_text.h"
#include "gis/raster/footprint.h"

namespace frana::app {
namespace {

bool has_ground(const MixedShape& shape, const Raster& terrain) {
    const std::vector<std::size_t> cells = touched_cells(shape, terrain.grid);
    return cells.empty() ||
           std::any_of(cells.begin(), cells.end(), [&](std::size_t cell) { return !std::isnan(terrain.values[cell]); });
}

}  // namespace

void warn_of_unknown_exposure(const gis::ExposedLayer& layer, const Bounds& map, const Raster* terrain, RunLog& log) {
    std::size_t unknown = 0;
    std::string first;
    for (const gis::ExposedFeature& feature : layer.features) {
        const bool is_outside = feature.shape.empty() || place_of(feature.shape, map) == MapPlace::outside;
        if (!is_outside &&
            (terrain == nullptr || terrain->values.is_tiled() || has_ground(feature.shape, std::as_const(*terrain))))
            continue;
        if (unknown++ == 0) first = feature.name;
    }
    if (unknown == 0) return;
    const auto whole = [](std::size_t count) { return numeral(grouped(static_cast<double>(count))); };
    log.warn(
        worded("{1} of {2} exposed features are off the map or on ground without elevation, the first is {3}: the "
               "result will say nothing of them",
               {whole(unknown), whole(layer.features.size()), first}));
}

namespace {

// Mean slopes [degrees]. Landslides start on some 10 to 50 degrees; those on less are dams, tailings and quick clay.
constexpr double k_flat_release = 2, k_steep_release = 55;
// Granular flows and mudflows run out over 5 to 35 degrees. Feet read as metres turn 30 degrees into 62.
constexpr double k_steep_path = 45;

const char* const k_steep_remedy = worded(
    "Elevations in feet or decimetres read as metres look like this: check the elevations above against a map, "
    "terrain.vertical-unit, and the DTM for steps and towers");

}  // namespace

Sentence ground_sentence(const GroundStatistics& ground) {
    return worded("{1} to {2} m, slope {3} degrees on average, {4} at most",
                  {numeral(number_text(ground.lowest, 5)), numeral(number_text(ground.highest, 5)),
                   numeral(number_text(ground.mean_slope_deg, 2)), numeral(number_text(ground.steepest_slope_deg, 2))});
}

std::optional<GroundStatistics> ground_of_release(const Scene& scene) {
    GroundSum sum(scene.terrain);
    for (const ReleaseArea& area : scene.release)
        for (const Polygon& polygon : area.outline)  // one at a time: memory is that of the window round it
            gis::visit_cells({polygon}, scene.grid, gis::Cover::centres,
                             [&](std::int64_t row, std::int64_t column) { sum.add(row, column); });
    return sum.statistics();
}

void warn_of_release_ground(const GroundStatistics& ground, RunLog& log) {
    if (ground.mean_slope_deg > k_steep_release) {
        log.warn(worded("the release is nearly vertical: {1}. {2}", {ground_sentence(ground), k_steep_remedy}));
    } else if (ground.mean_slope_deg < k_flat_release) {
        log.warn(worded(
            "the release is nearly flat: {1}. Check that perimeter and DTM belong to the same place (coordinate "
            "reference systems), that the elevations are in metres (terrain.vertical-unit), and that the DTM has its "
            "elevations there",
            {ground_sentence(ground)}));
    }
}

void warn_of_held_release(const GroundStatistics& ground, double friction, const UsedUnit& unit, RunLog& log) {
    const double angle = std::atan(friction) * 180 / std::numbers::pi;
    const bool is_told = ground.mean_slope_deg < k_flat_release;  // by warn_of_release_ground
    if (!(friction > 0) || ground.steepest_slope_deg >= angle || is_told) return;
    const Sentence remedy =
        unit.metres >= 1 ? worded(
                               "Elevations that are too low for their eastings look like this, as metres that were "
                               "converted as if they were feet: check the elevations above against a map, and the "
                               "friction")
        : unit.is_of_file
            ? worded(
                  "The elevations were converted from {1}, as the file says: if they are in metres already, set "
                  "terrain.vertical-unit = metre. Otherwise check the elevations above against a map, and the friction",
                  {unit.name})
            : worded(
                  "The elevations were converted from {1}: if they are in metres already, set terrain.vertical-unit = "
                  "metre. Otherwise check the elevations above against a map, and the friction",
                  {unit.name});
    log.warn(
        worded("the release is held by friction: its ground, {1}, is nowhere as steep as the slope of {2} degrees "
               "that its friction holds, so that at most its edges move. {3}",
               {ground_sentence(ground), numeral(number_text(angle, 3)), remedy}));
}

void warn_of_path_ground(const GroundStatistics& ground, RunLog& log) {
    if (ground.mean_slope_deg > k_steep_path)
        log.warn(worded("the path is steeper than those of landslides: {1}. {2}",
                        {ground_sentence(ground), k_steep_remedy}));
}

}  // namespace frana::app
