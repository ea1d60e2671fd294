// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace frana {

/// Rain over time, the same everywhere: linear between its points, none before the first and after the last.
struct Rain {
    struct Point {
        double time = 0;       ///< [s]
        double intensity = 0;  ///< [m/s], of vertical depth
    };
    std::vector<Point> points;  ///< times rise; an equal time is a step

    [[nodiscard]] bool falls() const noexcept { return !points.empty(); }
    /// When the last of it has fallen [s].
    [[nodiscard]] double end() const noexcept { return falls() ? points.back().time : 0; }
    /// Depth that has fallen by a time: the integral, without error [m].
    [[nodiscard]] double depth_by(double time) const noexcept {
        double depth = 0;
        for (std::size_t i = 1; i < points.size() && points[i - 1].time < time; ++i) {
            const Point &a = points[i - 1], &b = points[i];
            const double length = b.time - a.time, part = std::min(time - a.time, length);
            if (length > 0) depth += part * (a.intensity + 0.5 * part / length * (b.intensity - a.intensity));
        }
        return depth;
    }
};

}  // namespace frana
