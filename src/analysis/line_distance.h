// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/geometry.h"
#include "core/nearest_segment.h"

namespace frana {

/// The lines bounding an area (or drawn by hand), for distances in map view.
class LineSet {
  public:
    /// All rings, including holes; collinear neighbouring segments are joined.
    explicit LineSet(const MultiPolygon& area);
    /// Open lines, unchanged.
    explicit LineSet(const std::vector<Polyline>& lines);

    [[nodiscard]] bool empty() const noexcept { return segments_.empty(); }
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
