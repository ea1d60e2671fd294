// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry.h"

namespace frana {

/// `contains` for many points: the edges are sorted into bands by y, so that a point is compared only with the edges of
/// its band. The result equals that of `contains` for every point.
class InsideTest {
  public:
    explicit InsideTest(const MultiPolygon& polygons);

    [[nodiscard]] bool operator()(Point point) const;

  private:
    struct Edge {
        Point a, b;
        std::uint32_t polygon, ring;  // ring 0 is the outer one
    };

    [[nodiscard]] std::size_t band(double y) const;

    double south_ = 0, north_ = 0, height_ = 1;
    std::vector<Edge> edges_;            // by polygon and ring
    std::vector<std::size_t> begins_;    // of each band in `listed_`, and the end of the last
    std::vector<std::uint32_t> listed_;  // edges that cross each band, in their order
};

}  // namespace frana
