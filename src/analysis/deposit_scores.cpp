// SPDX-License-Identifier: Apache-2.0
#include "analysis/deposit_scores.h"

#include <cmath>

#include "core/error.h"

namespace frana {

DepositScores compare_deposit(const Raster& simulated, const Raster& observed, double threshold) {
    if (!simulated.grid.same_cells(observed.grid)) {
        throw Error(ErrorKind::input, Problem{"simulated and observed deposit do not have the same cells", "comparison",
                                              "", "", "Bring both onto one grid"});
    }
    double count = 0, sum_s = 0, sum_o = 0, absolute = 0, squares = 0, ss = 0, oo = 0, so = 0;
    for (std::size_t i = 0; i < simulated.values.size(); ++i) {
        if (std::isnan(observed.values[i])) continue;
        const double s = simulated.values[i] > 0 ? simulated.values[i] : 0;
        const double o = observed.values[i] > 0 ? observed.values[i] : 0;
        if (!(s > threshold) && !(o > threshold)) continue;
        ++count;
        sum_s += s;
        sum_o += o;
        absolute += std::abs(s - o);
        squares += (s - o) * (s - o);
        ss += s * s;
        oo += o * o;
        so += s * o;
    }
    if (count == 0) {
        throw Error(ErrorKind::input, Problem{"neither the simulation nor the survey has a deposit", "comparison", "",
                                              "", "Lower the threshold"});
    }
    const double cell = simulated.grid.cell_area();
    DepositScores scores;
    scores.area_m2 = count * cell;
    scores.observed_volume_m3 = sum_o * cell;
    scores.simulated_volume_m3 = sum_s * cell;
    scores.bias_m = (sum_s - sum_o) / count;
    scores.mean_absolute_error_m = absolute / count;
    scores.rmse_m = std::sqrt(squares / count);
    const double variance_s = ss - sum_s * sum_s / count, variance_o = oo - sum_o * sum_o / count;
    // Equal values leave a remainder from rounding.
    const bool both_vary = variance_s > 1e-12 * ss && variance_o > 1e-12 * oo;
    scores.correlation = both_vary ? (so - sum_s * sum_o / count) / std::sqrt(variance_s * variance_o) : k_no_data;
    return scores;
}

}  // namespace frana
