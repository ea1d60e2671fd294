// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <vector>

#include "core/geometry.h"
#include "core/raster.h"

namespace frana {

/// Agreement in depth of a simulated deposit with an observed one, over the cells where either is deeper than the
/// threshold and the observation has data. With d = simulated minus observed depth:
struct DepositScores {
    double area_m2 = 0;             ///< of those cells
    double observed_volume_m3 = 0;  ///< over those cells
    double simulated_volume_m3 = 0;
    double bias_m = 0;                 ///< mean of d
    double mean_absolute_error_m = 0;  ///< mean of |d|
    double rmse_m = 0;                 ///< sqrt(mean of d^2)
    double correlation = 0;            ///< Pearson's, of the two depths; NaN if one does not vary
    /// Over all surveyed cells, losses too: volumes by which the ground rose and sank, both positive.
    double observed_raised_m3 = 0, observed_lowered_m3 = 0, simulated_raised_m3 = 0, simulated_lowered_m3 = 0;
    double change_rmse_m = 0;               ///< there
    double simulated_raised_beyond_m3 = 0;  ///< where there is no survey
};

/// `simulated` and `observed` change of elevation [m], on the same cells (NaN: none, not surveyed). For the deposit a
/// loss counts as none. Throws Error(input) if the cells differ or neither has a deposit.
DepositScores compare_deposit(const Raster& simulated, const Raster& observed, double threshold);

/// Agreement of a simulated trace with an observed one, cell by cell.
///
/// With TP, FP, FN the hit, false alarm and miss areas: jaccard = csi = TP/(TP+FP+FN), dice = 2TP/(2TP+FP+FN), true
/// positive rate = TP/(TP+FN). The values must not depend on the size of the map, so the area of possible false alarms
/// is not the map but five times the observed area, as in r.avaflow: TN = 5(TP+FN) - FP, and the false positive rate is
/// FP/(5(TP+FN)), at most 1.
struct ComparisonStatistics {
    double threshold_m = 0;  ///< depth over which a cell counts as covered
    double observed_area_m2 = 0;
    double simulated_area_m2 = 0;
    double area_difference_percent = 0;  ///< |simulated - observed| / observed
    double hit_m2 = 0;
    double false_alarm_m2 = 0;
    double miss_m2 = 0;
    double jaccard = 0;
    double dice = 0;
    double csi = 0;  ///< critical success index; equal to jaccard, by the name used in forecasting
    double true_positive_rate = 0;
    double false_positive_rate = 0;
    double d2pc = 0;   ///< distance to perfect classification: sqrt((1 - TPR)^2 + FPR^2), 0 is perfect
    double auroc = 0;  ///< area under the ROC curve as the threshold runs over all depths, 1 is perfect

    /// (simulated - observed) / observed
    [[nodiscard]] double signed_area_difference_percent() const noexcept {
        return simulated_area_m2 < observed_area_m2 ? -area_difference_percent : area_difference_percent;
    }
};

/// Compares a depth [m] (NaN: never reached) with a mask (not 0 and not NaN: observed) on the same cells. Throws
/// Error(input) if the grids differ or nothing was observed.
ComparisonStatistics compare(const Raster& simulated_depth, const Raster& observed_mask, double threshold);

/// Returns the values for thresholds [m] of 0 and 1, 1.5, 2, 3, 5, 7 times powers of ten from 0.01 up to the greatest
/// depth; auroc belongs to the whole curve and is the same in each. Throws as compare does.
std::vector<ComparisonStatistics> score_curve(const Raster& simulated_depth, const Raster& observed_mask);

/// False alarms are relative to this many times the observed area (r.avaflow's normalisation).
inline constexpr double k_negatives_per_positive = 5;

/// Whether a value of a mask marks observed ground.
inline bool is_observed(double mask) {
    return mask != 0 && !std::isnan(mask);
}

/// A point of the ROC curve: the rates if the cells with at least this value count as simulated.
struct RocPoint {
    double value = 0;
    double true_positive_rate = 0, false_positive_rate = 0;
};
/// Returns the curve for every value above 0 that occurs, the greatest first: which begins at (0, 0), up to the last of
/// them. Throws as compare does.
std::vector<RocPoint> roc_curve(const Raster& values, const Raster& observed_mask);
/// Returns the area under its straight lines, and under that from its last point to (1, 1).
double area_below(const std::vector<RocPoint>& curve);

enum class Agreement { hit = 1, false_alarm = 2, miss = 3 };

/// The same cell by cell: values of Agreement, NaN where neither covers.
Raster agreement(const Raster& simulated_depth, const Raster& observed_mask, double threshold);

/// The lines bounding an area (or drawn by hand), for distances in map view.
class LineSet {
  public:
    /// All rings, including holes; collinear neighbouring segments are joined.
    explicit LineSet(const MultiPolygon& area);
    /// Open lines, unchanged.
    explicit LineSet(const std::vector<Polyline>& lines);

    [[nodiscard]] bool empty() const noexcept { return segments_.empty(); }
    /// Returns the length of all lines [m].
    [[nodiscard]] double length() const;
    /// Returns the distance from a point to the nearest point of the lines [m]; NaN if there are no lines.
    [[nodiscard]] double distance(Point point) const;
    /// Returns points along the lines, at equal distances of at most `spacing` within each straight segment, each in
    /// the middle of the part it represents.
    [[nodiscard]] std::vector<Point> samples(double spacing) const;

  private:
    void add(const Polyline& line, bool closed);
    std::vector<Segment> segments_;
    NearestSegment nearest_;  // of the same lines
};

/// Distance between two sets of lines.
struct LineDistance {
    double mean_m = 0;           ///< over the length of both
    double percentile_95_m = 0;  ///< 95 % of that length is nearer
    double hausdorff_m = 0;      ///< the greatest distance
};

/// Returns the distances from each boundary's samples to the other boundary, both directions pooled. The sampling
/// (spacing [m]) can miss the greatest distance by half a spacing. Throws Error(input) if either set is empty.
LineDistance distance_between(const LineSet& one, const LineSet& other, double spacing);

/// Returns mean, 95th percentile (nearest rank) and maximum of the absolute values of some distances. At least one.
LineDistance distance_statistics(std::vector<double> distances);

}  // namespace frana
