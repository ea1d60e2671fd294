// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/grid_spec.h"

namespace frana {

struct Segment {
    Point from, to;  // never equal
};

/// Finds the segment nearest to a point among many with a tree of bounding boxes, halved at the medians of the
/// segments. The distance equals that of comparing with every segment, to the bit.
class NearestSegment {
  public:
    NearestSegment() = default;
    explicit NearestSegment(std::vector<Segment> segments);

    [[nodiscard]] const std::vector<Segment>& segments() const noexcept { return segments_; }
    /// Returns the square of the distance; infinite if there is no segment.
    [[nodiscard]] double square_of_distance(Point point) const;

  private:
    struct Box {
        Bounds bounds;
        std::size_t first, last;              // segments
        std::array<std::size_t, 2> halves{};  // child boxes; both 0: none
    };

    std::size_t build(std::size_t first, std::size_t last);
    void search(std::size_t box, Point point, double& nearest) const;

    std::vector<Segment> segments_;
    std::vector<Box> boxes_;
};

}  // namespace frana
