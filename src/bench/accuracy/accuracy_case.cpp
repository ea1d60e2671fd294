// SPDX-License-Identifier: Apache-2.0
#include "bench/accuracy/accuracy_case.h"

#include <algorithm>

namespace frana::bench {

CaseStatistics compare_with_exact(TimedFlow& run, const std::function<ExactState(Point)>& exact,
                                  const std::function<bool(Point)>& inside) {
    const Flow::NodalFields fields = run.fields();
    const GridSpec& grid = fields.depth.grid;
    double depth = 0, depth2 = 0, exact_depth = 0, exact_depth2 = 0, greatest = 0;
    double momentum = 0, momentum2 = 0, exact_momentum = 0, exact_momentum2 = 0, still = 0, still2 = 0;
    std::int64_t cells = 0;
    for (std::int64_t row = 0; row < grid.rows; ++row) {
        for (std::int64_t column = 0; column < grid.columns; ++column) {
            const Point place = grid.local_from_map(grid.cell_centre(row, column));
            if (inside && !inside(place)) continue;
            const ExactState state = exact(place);
            const double e = std::abs(fields.depth.at(row, column) - state.depth);
            const double q =
                std::hypot(fields.momentum_x.at(row, column) - state.qx, fields.momentum_y.at(row, column) - state.qy);
            const double q_exact = std::hypot(state.qx, state.qy);
            const double q_still = state.depth * std::sqrt(k_gravity * state.depth);
            depth += e;
            depth2 += e * e;
            greatest = std::isnan(e) ? e : std::max(greatest, e);
            exact_depth += state.depth;
            exact_depth2 += state.depth * state.depth;
            momentum += q;
            momentum2 += q * q;
            exact_momentum += q_exact;
            exact_momentum2 += q_exact * q_exact;
            still += q_still;
            still2 += q_still * q_still;
            ++cells;
        }
    }
    CaseStatistics statistics;
    statistics.cell_size = grid.cell_size;
    statistics.l1_depth = depth / exact_depth;
    statistics.l2_depth = std::sqrt(depth2 / exact_depth2);
    statistics.linf_depth = greatest;
    statistics.l1_momentum = momentum / (exact_momentum > 0 ? exact_momentum : still);
    statistics.l2_momentum = std::sqrt(momentum2 / (exact_momentum2 > 0 ? exact_momentum2 : still2));
    statistics.mean_depth_error = depth / static_cast<double>(cells);
    statistics.particles = run.peak_particles();
    statistics.steps = run.model().steps();
    statistics.wall_seconds = run.seconds();
    statistics.cpu_seconds = run.cpu_seconds();
    if (run.non_finite() > 0) statistics.error = "values became non-finite";
    return statistics;
}

}  // namespace frana::bench
