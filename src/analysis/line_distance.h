// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/geometry.h"
#include "core/nearest_segment.h"

namespace frana {

/// The lines that bound an area (or lines drawn by hand), for distances in map view.
class LineSet {
  public:
    /// All rings, holes included; neighbouring pieces on one straight line become one.
    explicit LineSet(const MultiPolygon& area);
    /// Open lines as they are.
    explicit LineSet(const std::vector<Polyline>& lines);

    [[nodiscard]] bool empty() const noexcept { return segments_.empty(); }
    /// Distance from a point to the nearest place of the lines [m]; NaN where there is none.
    [[nodiscard]] double distance(Point point) const;
    /// Points along the lines, at equal distances of at most `spacing` within each straight piece, each in
    /// the middle of the stretch it stands for.
    [[nodiscard]] std::vector<Point> samples(double spacing) const;

  private:
    void add(const Polyline& line, bool closed);
    std::vector<Segment> segments_;
    NearestSegment nearest_;  // of the same
};

/// How far two sets of lines lie apart.
struct LineDistance {
    double mean_m = 0;           ///< over the length of both
    double percentile_95_m = 0;  ///< 95 % of that length lie nearer
    double hausdorff_m = 0;      ///< the farthest place
};

/// Distances from each boundary's samples to the other boundary, both ways pooled. The sampling (spacing [m])
/// can miss the farthest place by half of it. Throws Error(input) when either is empty.
LineDistance distance_between(const LineSet& one, const LineSet& other, double spacing);

/// Mean, 95th percentile (nearest rank) and maximum of the sizes of some distances. At least one.
LineDistance distance_statistics(std::vector<double> distances);

}  // namespace frana
