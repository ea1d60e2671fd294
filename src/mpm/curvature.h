// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>

#include "core/geometry.h"
#include "mpm/node_grid.h"

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

/// Acceleration that motion over a curved bed adds to gravity [m/s2]:
///
///     load = v . grad grad Z . v = u^2 Z_xx + 2 u v Z_xy + v^2 Z_yy
///
/// u, v velocity in map view [m/s]. The bed then supports (g + load) / sqrt(n) per mass, n = 1 + |grad Z|^2, which is g
/// cos(theta) + speed^2 / radius along the motion: more in hollows, less over edges, 0 instead of negative. It pushes
/// by -(g + load) grad Z / n in map view, which conserves the speed along the bed without friction. Exact for a point
/// mass on a surface (share/doc/model.md, "Curvature").
/// Where the support would be negative, a point mass would leave the bed. The depth-averaged flow stays on it, without
/// friction, and keeps its energy: if its map velocity were kept, as in flight, the steep bed under it would convert it
/// into a higher speed.
/// Second derivatives are those of the quadric through the nine nodes by least squares (Evans 1980, Z. Geomorphol.
/// Suppl. 36, 274), smoother than plain differences by sqrt(3) on noisy terrain.
/// 0 at speed zero; independent of depth.
struct BedCurvature {
    double xx = 0, xy = 0, yy = 0;  ///< grad grad Z [1/m]
    double x = 0, y = 0;            ///< grad Z by Sobel's weights [-]: across an edge oblique to the grid, differences
                                    ///< along rows and columns alone are off in direction and would deflect the flow
                                    ///< that crosses it (from 45 to 70 degrees by up to 33 degrees; with these by 5)

    [[nodiscard]] double load(double u, double v) const noexcept { return u * u * xx + 2 * u * v * xy + v * v * yy; }
};

/// @param column, row padded; 0 on the outermost ring, which no particle reaches
inline BedCurvature bed_curvature(const NodeGrid& nodes, std::size_t i, std::int64_t column,
                                  std::int64_t row) noexcept {
    if (column <= 0 || row <= 0 || column >= nodes.stride() - 1 || row >= nodes.padded_rows() - 1) return {};
    const auto step = static_cast<std::size_t>(nodes.stride());
    const double *z = nodes.bed.data() + i, *south = z - step, *north = z + step;
    const double inverse_dx2 = 1 / (nodes.cell_size() * nodes.cell_size());
    const double west = south[-1] + z[-1] + north[-1], east = south[1] + z[1] + north[1];
    const double below = south[-1] + south[0] + south[1], above = north[-1] + north[0] + north[1];
    const double xx = (west - 2 * (south[0] + z[0] + north[0]) + east) * inverse_dx2 / 3;
    const double yy = (below - 2 * (z[-1] + z[0] + z[1]) + above) * inverse_dx2 / 3;
    const double xy = (north[1] + south[-1] - north[-1] - south[1]) * inverse_dx2 / 4;
    const double eighth = 0.125 / nodes.cell_size();
    const double x = eighth * (east - west + (z[1] - z[-1])), y = eighth * (above - below + (north[0] - south[0]));
    return {xx, xy, yy, x, y};
}

/// Rotates a velocity in map view [m/s] over a time dt by the bed alone. Where the fall line turns along the motion, w
/// turns as well, at the rate
///
///     (grad Z x grad grad Z u) / (root (root + 1)),
///
/// which makes the path a geodesic; its magnitude, the speed along the bed, is unchanged.
inline void turn_by_bed(const BedCurvature& k, const BedFrame& frame, double dt, double& u, double& v) noexcept {
    const double rise_x = k.xx * u + k.xy * v, rise_y = k.xy * u + k.yy * v;
    const double root = std::sqrt(1 + k.x * k.x + k.y * k.y);
    const double half = 0.5 * dt * (k.x * rise_y - k.y * rise_x) / (root * (root + 1));
    const double cosine = (1 - half * half) / (1 + half * half), sine = 2 * half / (1 + half * half);
    const Point w = frame.along_bed(u, v);
    const Point turned = frame.in_map(cosine * w.x - sine * w.y, sine * w.x + cosine * w.y);
    u = turned.x;
    v = turned.y;
}

/// The velocity in map view with which a particle moves over `dt` [m/s]: its velocity along the bed stays, but the
/// slope halfway is not that of the start, grad Z + dt/2 grad grad Z u. Positions are of second order with it.
/// @param u velocity in map view at the start, of `frame`
inline Point velocity_underway(const BedCurvature& k, const BedFrame& frame, double dt, Point u) noexcept {
    const Point along = frame.along_bed(u.x, u.y);
    const double half = 0.5 * dt;
    return BedFrame::of(
               {frame.slope_x + half * (k.xx * u.x + k.xy * u.y), frame.slope_y + half * (k.xy * u.x + k.yy * u.y)})
        .in_map(along.x, along.y);
}

}  // namespace frana
