// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/geometry.h"

namespace frana {

/// A feature of any kind, in map coordinates: areas, lines and points.
struct MixedShape {
    MultiPolygon areas;
    std::vector<Polyline> lines;
    std::vector<Point> points;

    [[nodiscard]] bool empty() const noexcept { return areas.empty() && lines.empty() && points.empty(); }
};

}  // namespace frana
