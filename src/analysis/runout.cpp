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
    const auto centre_of = [&](std::size_t cell) {
        const auto n = static_cast<std::int64_t>(cell);
        return grid.cell_centre(n / grid.columns, n % grid.columns);
    };
    const auto find_top = [&](const Raster& where, bool raised) {
        where.values.for_each_stored([&](std::size_t cell, double value) {
            if (!(value > 0)) return;
            const double surface = bed.values[cell] + (raised ? value : 0);
            if (std::isnan(surface) || surface <= highest) return;
            highest = surface;
            result.top = centre_of(cell);
        });
    };
    find_top(release, true);
    if (std::isnan(highest)) find_top(trace, false);
    if (std::isnan(highest))
        throw Error(ErrorKind::input, Problem{"nothing is released and nothing flows", "run-out", "", "", ""});

    result.tip = result.top;
    trace.values.for_each_stored([&](std::size_t cell, double touched) {
        if (touched == 0 || std::isnan(touched) || std::isnan(bed.values[cell])) return;
        const Point centre = centre_of(cell);
        const double distance = std::hypot(centre.x - result.top.x, centre.y - result.top.y);
        if (distance <= result.horizontal_m) return;
        result.horizontal_m = distance;
        result.drop_m = highest - bed.values[cell];
        result.tip = centre;
    });
    result.reach_angle_deg = std::atan2(result.drop_m, result.horizontal_m) * 180 / std::numbers::pi;
    return result;
}

}  // namespace frana
