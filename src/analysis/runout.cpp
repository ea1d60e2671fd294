// SPDX-License-Identifier: Apache-2.0
#include "analysis/runout.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "core/error.h"

namespace frana {

std::vector<Runout> runouts_by_flow(const SeparateFlows& flows, const Raster& bed, const Raster& release,
                                    const Raster& trace) {
    const GridSpec& grid = bed.grid;
    if (!grid.same_cells(release.grid) || !grid.same_cells(trace.grid)) {
        throw Error(ErrorKind::input,
                    Problem{"bed, release and trace do not have the same cells", "run-out", "", "", ""});
    }
    std::vector<Runout> all(flows.count());
    std::vector<double> highest(flows.count(), k_no_data);
    const auto centre_of = [&](std::size_t cell) {
        const auto n = static_cast<std::int64_t>(cell);
        return grid.cell_centre(n / grid.columns, n % grid.columns);
    };
    const auto raise_top = [&](std::size_t flow, std::size_t cell, double thickness) {
        const double surface = bed.values[cell] + thickness;
        if (std::isnan(surface) || surface <= highest[flow]) return;
        highest[flow] = surface;
        all[flow].top = centre_of(cell);
    };
    const auto visit_flow = [&](std::size_t cell, const auto& visit) {
        if (const std::size_t flow = flows.flow_of(cell); flow < flows.count()) visit(flow, cell);
    };
    release.values.for_each_stored([&](std::size_t cell, double value) {
        if (!(value > 0)) return;
        visit_flow(cell, [&](std::size_t flow, std::size_t) { raise_top(flow, cell, value); });
    });
    const auto for_each_traced = [&](const auto& visit) {
        trace.values.for_each_stored([&](std::size_t cell, double touched) {
            if (touched != 0 && !std::isnan(touched)) visit_flow(cell, visit);
        });
    };
    std::vector<bool> released(flows.count());
    for (std::size_t flow = 0; flow < flows.count(); ++flow) released[flow] = !std::isnan(highest[flow]);
    for_each_traced([&](std::size_t flow, std::size_t cell) {
        if (!released[flow]) raise_top(flow, cell, 0);
    });

    std::vector<std::int64_t> cells(flows.count(), 0);
    for (Runout& one : all) one.tip = one.top;
    for_each_traced([&](std::size_t flow, std::size_t cell) {
        Runout& one = all[flow];
        ++cells[flow];
        if (std::isnan(bed.values[cell])) return;
        const Point centre = centre_of(cell);
        const double distance = std::hypot(centre.x - one.top.x, centre.y - one.top.y);
        if (distance <= one.horizontal_m) return;
        one.horizontal_m = distance;
        one.drop_m = highest[flow] - bed.values[cell];
        one.tip = centre;
    });
    for (std::size_t flow = 0; flow < flows.count(); ++flow) {
        Runout& one = all[flow];
        one.covered_area_m2 = static_cast<double>(cells[flow]) * grid.cell_area();
        one.reach_angle_deg = one.reach_angle(one.horizontal_m);
    }
    return all;
}

std::vector<Runout> runouts(const SeparateFlows& flows, const Raster& bed, const Raster& release, const Raster& trace) {
    std::vector<Runout> all = runouts_by_flow(flows, bed, release, trace);
    if (all.empty())
        throw Error(ErrorKind::input, Problem{"nothing is released and nothing flows", "run-out", "", "", ""});
    const auto is_traced = [](const Runout& one) { return one.covered_area_m2 > 0; };
    if (std::any_of(all.begin(), all.end(), is_traced))
        all.erase(std::remove_if(all.begin(), all.end(), std::not_fn(is_traced)), all.end());
    std::stable_sort(all.begin(), all.end(),
                     [](const Runout& a, const Runout& b) { return a.horizontal_m > b.horizontal_m; });
    return all;
}

}  // namespace frana
