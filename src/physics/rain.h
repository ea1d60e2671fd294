// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>

#include "physics/parameters.h"

namespace frana {

/// Rain over time, the same everywhere: linear between its points, none before the first and after the last.
inline double Rain::depth_by(double time) const noexcept {
    double depth = 0;
    for (std::size_t i = 1; i < points.size() && points[i - 1].time < time; ++i) {
        const Point &a = points[i - 1], &b = points[i];
        const double length = b.time - a.time, part = std::min(time - a.time, length);
        if (length > 0) depth += part * (a.intensity + 0.5 * part / length * (b.intensity - a.intensity));
    }
    return depth;
}

}  // namespace frana
