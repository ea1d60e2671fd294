// SPDX-License-Identifier: Apache-2.0
#include "render/canvas/dashes.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace frana::render {

std::vector<Polyline> dashed(std::span<const Point> points, const std::vector<double>& dashes) {
    constexpr double k_shortest = 0.05;  // of the first stroke: a length of zero would never advance
    std::vector<Polyline> strokes;
    std::size_t phase = 0;
    double left = dashes[0];
    Polyline stroke{points.front()};
    for (std::size_t i = 1; i < points.size(); ++i) {
        Point from = points[i - 1];
        const Point to = points[i];
        double length = std::hypot(to.x - from.x, to.y - from.y);
        while (length > left) {
            const double fraction = left / length;
            from = {from.x + fraction * (to.x - from.x), from.y + fraction * (to.y - from.y)};
            length -= left;
            if (phase % 2 == 0) {
                stroke.push_back(from);
                strokes.push_back(std::move(stroke));
            }
            phase = (phase + 1) % dashes.size();
            left = std::max(dashes[phase], k_shortest * dashes[0]);
            stroke = {from};
        }
        left -= length;
        stroke.push_back(to);
    }
    if (phase % 2 == 0 && stroke.size() > 1) strokes.push_back(std::move(stroke));
    return strokes;
}

}  // namespace frana::render
