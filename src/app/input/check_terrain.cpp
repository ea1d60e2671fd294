// SPDX-License-Identifier: Apache-2.0
#include "app/input/check_terrain.h"

#include <algorithm>
#include <cmath>

#include "analysis/terrain_sanity.h"
#include "app/text/number_text.h"
#include "core/error.h"

namespace frana::app {
namespace {

constexpr double k_steepest_median = 60;  // degrees; of the steepest mountains some 45
// A single cell of fine models: higher than trees and houses. Of coarse ones a summit may be as steep as 56 degrees.
constexpr double k_needle = 20, k_needle_cells = 1.5;

Sentence place_of(const GridSpec& looked_at, const GridSpec& grid, const Spot& spot) {
    const Point centre = looked_at.cell_centre(spot.row, spot.column);
    const auto cell = [&](double distance) { return std::to_string(std::llround(distance / grid.cell_size - 0.5)); };
    return worded("{1} (row {2}, column {3})", {number_text(centre.x, 9) + ", " + number_text(centre.y, 9),
                                                cell(grid.north - centre.y), cell(centre.x - grid.west)});
}

const char* const k_remedy = worded(
    "If it is nodata, set terrain.nodata-value; if the unit differs, set terrain.vertical-unit or convert the file");

}  // namespace

void check_terrain(const SceneReading& reading, const Raster& terrain, const GridSpec& grid, RunLog& log) {
    const auto place = [&](const GridSpec& of, const Spot& spot) { return place_of(terrain.grid, of, spot); };
    const double needle = std::max(k_needle, k_needle_cells * terrain.grid.cell_size);
    const TerrainSanity found = terrain_sanity(terrain, needle);
    if (found.highest.value < found.lowest.value) return;  // no sample of a large DTM lies where it has data
    const Spot& extreme = found.highest.value > -found.lowest.value ? found.highest : found.lowest;
    if (std::abs(extreme.value) > k_impossible_elevation) {
        throw Error(
            ErrorKind::input,
            Problem{"contains an impossible elevation", reading.where("terrain.dtm") + ": " + reading.scene.terrain.dtm,
                    number_text(extreme.value, 6) + " m at " + place(grid, extreme).text(),
                    grouped(-k_impossible_elevation) + " to " + grouped(k_impossible_elevation) + " m", k_remedy});
    }
    if (found.highest.value > k_highest_ground)
        log.warn(worded("DTM: the highest elevation is {1} m at {2}, higher than any mountain. {3}",
                        {numeral(number_text(found.highest.value, 6)), place(grid, found.highest), k_remedy}));
    if (found.lowest.value < k_lowest_ground)
        log.warn(worded("DTM: the lowest elevation is {1} m at {2}, lower than any dry ground. {3}",
                        {numeral(number_text(found.lowest.value, 6)), place(grid, found.lowest), k_remedy}));
    if (found.median_slope_deg > k_steepest_median)
        log.warn(worded(
            "DTM: half of the ground is steeper than {1} degrees: elevations and eastings may be in different units. "
            "Check terrain.vertical-unit and the coordinate reference system",
            {numeral(number_text(found.median_slope_deg, 3))}));
    if (found.needles == 0) return;
    std::vector<Sentence> list;
    for (const Spot& spot : found.first_needles)
        list.push_back(worded("{1} m at {2}", {numeral(number_text(spot.value, 4)), place(grid, spot)}));
    if (found.needles > static_cast<std::int64_t>(list.size())) list.emplace_back(std::string("..."));
    log.warn(worded(found.needles == 1
                        ? worded("DTM: {1} single cell stands more than {2} m above or below all eight "
                                 "neighbours; they deflect the flow and falsify its speed: {3}. Repair the "
                                 "DTM there (a mast, a bird, noise, undeclared nodata)")
                        : worded("DTM: {1} single cells stand more than {2} m above or below all eight "
                                 "neighbours; they deflect the flow and falsify its speed: {3}. Repair the "
                                 "DTM there (a mast, a bird, noise, undeclared nodata)"),
                    {numeral(grouped(found.needles)), numeral(number_text(needle)), listed(list)}));
}

}  // namespace frana::app
