// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "mpm/along_bed.h"
#include "mpm/node_grid.h"

namespace frana {

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
