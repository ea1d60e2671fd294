// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>

#include "core/geometry.h"

namespace frana {

/// Returns the speed along the bed [m/s] for a velocity (u, v) in map view and the vertical velocity `climb` = v . grad
/// Z.
inline double speed_along_bed(double u, double v, double climb) noexcept {
    return std::sqrt(u * u + v * v + climb * climb);
}

/// Returns the vertical velocity v . grad Z of a velocity in map view [m/s], from the neighbouring nodes.
inline double climb_at(const double* bed, std::int64_t stride, double half_inverse_dx, double u, double v) noexcept {
    return half_inverse_dx * (u * (bed[1] - bed[-1]) + v * (bed[stride] - bed[-stride]));
}

/// Inner product of velocities in map view, measured along a bed of slope grad Z: u . v + (u . grad Z)(v . grad Z).
struct AlongBed {
    double slope_x = 0, slope_y = 0;

    [[nodiscard]] double dot(Point u, Point v) const noexcept {
        return u.x * v.x + u.y * v.y + (u.x * slope_x + u.y * slope_y) * (v.x * slope_x + v.y * slope_y);
    }
    [[nodiscard]] double speed(Point v) const noexcept {
        return speed_along_bed(v.x, v.y, v.x * slope_x + v.y * slope_y);
    }
};

/// A vector in map view, of one point (double) or of four (Quad).
template <class Number>
struct MapVector {
    Number x, y;
};

/// BedFrame::in_map of (x, y). Always inlined: the fast kernels, compiled for another instruction set, must share no
/// function with the rest.
template <class Number>
[[gnu::always_inline]] inline MapVector<Number> in_map(Number x, Number y, Number slope_x, Number slope_y,
                                                       Number root) {
    const Number climb = (x * slope_x + y * slope_y) / (root * (root + 1));
    return {x - climb * slope_x, y - climb * slope_y};
}

/// Velocities along a bed of slope grad Z, rotated into the horizontal about the contour line:
///
///     w = u + (u . grad Z) grad Z / (root + 1),   root = sqrt(1 + |grad Z|^2),
///
/// so that |w| is the speed along the bed, |w|^2 = |u|^2 + (u . grad Z)^2, for the velocity u in map view. The map is
/// linear, so that on a plane the exchange of either velocity is equivalent; across an edge between planes of any slope
/// w is unchanged.
struct BedFrame {
    double slope_x = 0, slope_y = 0, root = 1;

    static BedFrame of(Point slope) noexcept {
        return {slope.x, slope.y, std::sqrt(1 + slope.x * slope.x + slope.y * slope.y)};
    }
    [[nodiscard]] Point along_bed(double u, double v) const noexcept {
        const double climb = (u * slope_x + v * slope_y) / (root + 1);
        return {u + climb * slope_x, v + climb * slope_y};
    }
    [[nodiscard]] Point in_map(double x, double y) const noexcept {
        const auto turned = frana::in_map(x, y, slope_x, slope_y, root);
        return {turned.x, turned.y};
    }
};

}  // namespace frana
