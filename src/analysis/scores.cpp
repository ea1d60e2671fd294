// SPDX-License-Identifier: Apache-2.0
#include "analysis/scores.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "analysis/trace.h"
#include "core/error.h"

namespace frana {

DepositScores compare_deposit(const Raster& simulated, const Raster& observed, double threshold) {
    if (!simulated.grid.same_cells(observed.grid)) {
        throw Error(ErrorKind::input, Problem{"simulated and observed deposit do not have the same cells", "comparison",
                                              "", "", "Bring both onto one grid"});
    }
    DepositScores scores;
    const double cell = simulated.grid.cell_area();
    const auto add = [cell](double change, double& raised, double& lowered) {
        (change > 0 ? raised : lowered) += std::abs(change) * cell;
    };
    double surveyed = 0, differences = 0;
    double count = 0, sum_s = 0, sum_o = 0, absolute = 0, squares = 0, ss = 0, oo = 0, so = 0;
    for (std::size_t i = 0; i < simulated.values.size(); ++i) {
        const double change = std::isnan(simulated.values[i]) ? 0 : simulated.values[i];
        if (std::isnan(observed.values[i])) {
            scores.simulated_raised_beyond_m3 += std::max(change, 0.0) * cell;
            continue;
        }
        ++surveyed;
        differences += (change - observed.values[i]) * (change - observed.values[i]);
        add(change, scores.simulated_raised_m3, scores.simulated_lowered_m3);
        add(observed.values[i], scores.observed_raised_m3, scores.observed_lowered_m3);
        const double s = change > 0 ? change : 0;
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
    scores.change_rmse_m = std::sqrt(differences / surveyed);
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

namespace {

bool on_one_line(Point a, Point b, Point c) {
    const double cross = (b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x);
    const double along = (b.x - a.x) * (c.x - b.x) + (b.y - a.y) * (c.y - b.y);
    return along > 0 && std::abs(cross) <= 1e-9 * along;
}

}  // namespace

LineSet::LineSet(const MultiPolygon& area) {
    for (const Polygon& polygon : area) {
        add(polygon.outer, true);
        for (const Ring& hole : polygon.holes) add(hole, true);
    }
    nearest_ = NearestSegment(segments_);
}

LineSet::LineSet(const std::vector<Polyline>& lines) {
    for (const Polyline& line : lines) add(line, false);
    nearest_ = NearestSegment(segments_);
}

void LineSet::add(const Polyline& line, bool closed) {
    const std::size_t first = segments_.size();
    const std::size_t count = line.size() < 2 ? 0 : line.size() - (closed ? 0 : 1);
    for (std::size_t i = 0; i < count; ++i) {
        const Point from = line[i], to = line[(i + 1) % line.size()];
        if (from.x == to.x && from.y == to.y) continue;
        if (segments_.size() > first && on_one_line(segments_.back().from, from, to)) {
            segments_.back().to = to;
        } else {
            segments_.push_back({from, to});
        }
    }
}

double LineSet::distance(Point point) const {
    return empty() ? std::numeric_limits<double>::quiet_NaN() : std::sqrt(nearest_.square_of_distance(point));
}

double LineSet::length() const {
    double sum = 0;
    for (const Segment& s : segments_) sum += std::hypot(s.to.x - s.from.x, s.to.y - s.from.y);
    return sum;
}

std::vector<Point> LineSet::samples(double spacing) const {
    std::vector<Point> points;
    for (const Segment& s : segments_) {
        const double length = std::hypot(s.to.x - s.from.x, s.to.y - s.from.y);
        const auto count = static_cast<std::size_t>(std::ceil(length / spacing));
        for (std::size_t i = 0; i < count; ++i) {
            const double t = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
            points.push_back({s.from.x + t * (s.to.x - s.from.x), s.from.y + t * (s.to.y - s.from.y)});
        }
    }
    return points;
}

LineDistance distance_statistics(std::vector<double> distances) {
    for (double& distance : distances) distance = std::abs(distance);
    std::sort(distances.begin(), distances.end());
    double sum = 0;
    for (const double distance : distances) sum += distance;
    const double count = static_cast<double>(distances.size());
    const auto rank = static_cast<std::size_t>(std::ceil(0.95 * count)) - 1;
    return {sum / count, distances[rank], distances.back()};
}

LineDistance distance_between(const LineSet& one, const LineSet& other, double spacing) {
    if (one.empty() || other.empty()) {
        throw Error(ErrorKind::input, Problem{"an outline is empty, so its distance from the other is undefined",
                                              "comparison", "", "", "Lower the depth threshold or check the files"});
    }
    std::vector<double> distances;
    for (const Point& point : one.samples(spacing)) distances.push_back(other.distance(point));
    for (const Point& point : other.samples(spacing)) distances.push_back(one.distance(point));
    return distance_statistics(std::move(distances));
}

}  // namespace frana
