// SPDX-License-Identifier: Apache-2.0
#include "analysis/scores.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "analysis/trace.h"
#include "core/error.h"

namespace frana {
namespace {

void check_same_cells(const Raster& depth, const Raster& mask) {
    if (depth.grid.same_cells(mask.grid)) return;
    throw Error(ErrorKind::input, Problem{"simulated and observed rasters do not have the same cells", "comparison", "",
                                          "", "Bring both onto one grid"});
}

Error nothing_observed() {
    return {ErrorKind::input, Problem{"no cell lies inside the observed outline", "comparison", "", "",
                                      "Check the outline's position and CRS, or use smaller cells"}};
}

/// All statistics except the area under the curve.
ComparisonStatistics statistics_at(const Raster& simulated_depth, const Raster& observed_mask, double threshold) {
    check_same_cells(simulated_depth, observed_mask);
    double hits = 0, false_alarms = 0, misses = 0;
    double simulated_cells = 0, observed_cells = 0;
    simulated_depth.values.for_each_stored([&](std::size_t cell, double depth) {
        if (!(depth > threshold)) return;
        ++simulated_cells;
        hits += is_observed(observed_mask.values[cell]);
    });
    observed_mask.values.for_each_stored([&](std::size_t, double value) { observed_cells += is_observed(value); });
    false_alarms = simulated_cells - hits;
    misses = observed_cells - hits;
    const double positives = hits + misses;
    if (positives == 0) throw nothing_observed();

    ComparisonStatistics statistics;
    const double cell = observed_mask.grid.cell_area();
    statistics.threshold_m = threshold;
    statistics.observed_area_m2 = positives * cell;
    statistics.simulated_area_m2 = (hits + false_alarms) * cell;
    statistics.area_difference_percent = 100 * std::abs(false_alarms - misses) / positives;
    statistics.hit_m2 = hits * cell;
    statistics.false_alarm_m2 = false_alarms * cell;
    statistics.miss_m2 = misses * cell;
    statistics.jaccard = hits / (hits + false_alarms + misses);
    statistics.csi = statistics.jaccard;
    statistics.dice = 2 * hits / (2 * hits + false_alarms + misses);
    statistics.true_positive_rate = hits / positives;
    statistics.false_positive_rate = std::min(1.0, false_alarms / (k_negatives_per_positive * positives));
    statistics.d2pc = std::hypot(1 - statistics.true_positive_rate, statistics.false_positive_rate);
    return statistics;
}

}  // namespace

ComparisonStatistics compare(const Raster& simulated_depth, const Raster& observed_mask, double threshold) {
    ComparisonStatistics statistics = statistics_at(simulated_depth, observed_mask, threshold);
    statistics.auroc = area_below(roc_curve(simulated_depth, observed_mask));
    return statistics;
}

std::vector<RocPoint> roc_curve(const Raster& values, const Raster& observed_mask) {
    check_same_cells(values, observed_mask);
    std::vector<std::pair<double, bool>> covered;  // value, observed
    double false_total = 0, positives = 0;
    values.values.for_each_stored([&](std::size_t cell, double value) {
        if (!(value > 0)) return;
        const bool observed = is_observed(observed_mask.values[cell]);
        covered.emplace_back(value, observed);
        if (!observed) ++false_total;
    });
    observed_mask.values.for_each_stored([&](std::size_t, double value) { positives += is_observed(value); });
    if (positives == 0) throw nothing_observed();
    std::sort(covered.begin(), covered.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    const double negatives = std::max(k_negatives_per_positive * positives, false_total);
    std::vector<RocPoint> curve;
    double true_count = 0, false_count = 0;
    for (std::size_t i = 0; i < covered.size(); ++i) {
        (covered[i].second ? true_count : false_count) += 1;
        // Cells of equal value pass the threshold together.
        const bool last_of_its_value = i + 1 == covered.size() || covered[i + 1].first != covered[i].first;
        if (last_of_its_value) curve.push_back({covered[i].first, true_count / positives, false_count / negatives});
    }
    return curve;
}

double area_below(const std::vector<RocPoint>& curve) {
    double area = 0, true_rate = 0, false_rate = 0;
    const auto move_to = [&](double next_true, double next_false) {
        area += (next_false - false_rate) * (true_rate + next_true) / 2;
        true_rate = next_true;
        false_rate = next_false;
    };
    for (const RocPoint& point : curve) move_to(point.true_positive_rate, point.false_positive_rate);
    move_to(1, 1);
    return area;
}

std::vector<ComparisonStatistics> score_curve(const Raster& simulated_depth, const Raster& observed_mask) {
    std::vector<ComparisonStatistics> curve{compare(simulated_depth, observed_mask, 0)};
    const double deepest = maximum(simulated_depth);
    for (double decade = 0.01; decade < deepest; decade *= 10) {
        for (const double factor : {1.0, 1.5, 2.0, 3.0, 5.0, 7.0}) {
            if (factor * decade >= deepest) break;
            curve.push_back(statistics_at(simulated_depth, observed_mask, factor * decade));
            curve.back().auroc = curve.front().auroc;
        }
    }
    return curve;
}

Raster agreement(const Raster& simulated_depth, const Raster& observed_mask, double threshold) {
    check_same_cells(simulated_depth, observed_mask);
    Raster classes(observed_mask.grid, k_no_data);
    const auto set = [&](std::size_t cell, Agreement kind) { classes.values[cell] = static_cast<double>(kind); };
    observed_mask.values.for_each_stored([&](std::size_t cell, double value) {
        if (is_observed(value)) set(cell, simulated_depth.values[cell] > threshold ? Agreement::hit : Agreement::miss);
    });
    simulated_depth.values.for_each_stored([&](std::size_t cell, double depth) {
        if (depth > threshold && !is_observed(observed_mask.values[cell])) set(cell, Agreement::false_alarm);
    });
    return classes;
}

}  // namespace frana
