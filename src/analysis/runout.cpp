// SPDX-License-Identifier: Apache-2.0
#include "analysis/runout.h"

#include <cmath>
#include <numbers>

#include "core/error.h"

namespace frana {

Runout runout(const Raster& bed, const Raster& release, const Raster& trace) {
    const GridSpec& grid = bed.grid;
    if (!grid.same_cells(release.grid) || !grid.same_cells(trace.grid)) {
        throw Error(ErrorKind::input,
                    Problem{"bed, release and trace do not have the same cells", "run-out", "", "", ""});
    }
    Runout result;
    double highest = k_no_data;
    const auto find_top = [&](const Raster& where, bool raised) {
        for (std::int64_t row = 0; row < grid.rows; ++row) {
            for (std::int64_t column = 0; column < grid.columns; ++column) {
                if (!(where.at(row, column) > 0)) continue;
                const double surface = bed.at(row, column) + (raised ? where.at(row, column) : 0);
                if (std::isnan(surface) || surface <= highest) continue;
                highest = surface;
                result.top = grid.cell_centre(row, column);
            }
        }
    };
    find_top(release, true);
    if (std::isnan(highest)) find_top(trace, false);
    if (std::isnan(highest))
        throw Error(ErrorKind::input, Problem{"nothing is released and nothing flows", "run-out", "", "", ""});

    result.tip = result.top;
    for (std::int64_t row = 0; row < grid.rows; ++row) {
        for (std::int64_t column = 0; column < grid.columns; ++column) {
            const double touched = trace.at(row, column);
            if (touched == 0 || std::isnan(touched) || !bed.has_data(row, column)) continue;
            const Point centre = grid.cell_centre(row, column);
            const double distance = std::hypot(centre.x - result.top.x, centre.y - result.top.y);
            if (distance <= result.horizontal_m) continue;
            result.horizontal_m = distance;
            result.drop_m = highest - bed.at(row, column);
            result.tip = centre;
        }
    }
    result.reach_angle_deg = std::atan2(result.drop_m, result.horizontal_m) * 180 / std::numbers::pi;
    return result;
}

}  // namespace frana
