// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "mpm/node_grid.h"

namespace frana {

/// What the motion over a curved bed adds to gravity [m/s2]:
///
///     load = v . grad grad Z . v = u^2 Z_xx + 2 u v Z_xy + v^2 Z_yy
///
/// u, v velocity in map view [m/s]. The bed then supports (g + load) / sqrt(n) per mass, n = 1 + |grad Z|^2,
/// which is g cos(theta) + speed^2 / radius along the motion: more in hollows, less over edges, none where it
/// would be negative; and it pushes by -(g + load) grad Z / n in map view, which keeps the speed along the
/// bed where friction does not act. This is a point mass on a surface, exact; specification, section 5.
/// Where it would be negative the mass would fly. Depth-averaged it stays on its bed, without friction, and
/// keeps its energy: were its map velocity kept, as in flight, the steep bed under it would read as speed.
/// Second derivatives are those of the quadric through the nine nodes by least squares (Evans 1980, Z.
/// Geomorphol. Suppl. 36, 274), smoother than plain differences by sqrt(3) on noisy terrain.
/// Nothing at speed zero; depth does not enter.
struct BedCurvature {
    double xx = 0, xy = 0, yy = 0;  ///< grad grad Z [1/m]

    [[nodiscard]] double load(double u, double v) const noexcept {
        return u * u * xx + 2 * u * v * xy + v * v * yy;
    }
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
    return {xx, xy, yy};
}

/// A velocity [m/s] after dt in which nothing but the bed turned it, so that its speed along the bed stays:
/// pushed by -dt load grad Z / n, of which the direction is taken; the speed in map view is that which keeps
/// |v|^2 + (v . grad Z)^2, both where the direction turned and where the slope changes on the way,
///
///     d ln|v| = -dt v . grad F,   F = ln(1 + (e . grad Z)^2) / 2,   e = v / |v|.
///
/// F is differenced between the nodes beside, so that what it gives over an edge in the ground is lost again
/// below it, however sharp the edges. The push alone adds its square to the speed at every step, and more
/// where the slope changes by much from cell to cell: on real terrain it ran away.
/// @param slope_x, slope_y grad Z at the node; n 1 + |grad Z|^2
/// @param column, row padded; nothing happens on the two outermost rings
inline void follow_bed(const NodeGrid& nodes, std::size_t i, std::int64_t column, std::int64_t row,
                       const BedCurvature& k, double slope_x, double slope_y, double n, double dt, double& u,
                       double& v) noexcept {
    const double speed = std::hypot(u, v);
    if (!(speed > 0) || column <= 1 || row <= 1 || column >= nodes.stride() - 2 ||
        row >= nodes.padded_rows() - 2)
        return;
    const auto step = static_cast<std::size_t>(nodes.stride());
    const double* bed = nodes.bed.data();
    const double half_inverse_dx = 0.5 / nodes.cell_size();
    double ex = u / speed, ey = v / speed;
    const auto metric = [&](std::size_t at) {
        const double climb =
            (ex * (bed[at + 1] - bed[at - 1]) + ey * (bed[at + step] - bed[at - step])) * half_inverse_dx;
        return 1 + climb * climb;
    };
    const double change =
        ex * std::log(metric(i + 1) / metric(i - 1)) + ey * std::log(metric(i + step) / metric(i - step));
    const double here = metric(i);
    const double push = dt * k.load(u, v) / n;
    const double turned_u = u - push * slope_x, turned_v = v - push * slope_y;
    if (turned_u * u + turned_v * v > 0) {
        const double turned = std::hypot(turned_u, turned_v);
        ex = turned_u / turned;
        ey = turned_v / turned;
    }
    const double after =
        speed * std::sqrt(here / metric(i)) * std::exp(-0.5 * dt * speed * half_inverse_dx * change);
    u = after * ex;
    v = after * ey;
}

}  // namespace frana
