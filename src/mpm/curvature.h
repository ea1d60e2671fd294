// SPDX-License-Identifier: Apache-2.0
#pragma once

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
/// Second derivatives are those of the quadric through the nine nodes by least squares (Evans 1980, Z.
/// Geomorphol. Suppl. 36, 274), smoother than plain differences by sqrt(3) on noisy terrain.
/// Nothing at speed zero; depth does not enter.
/// @param column, row padded; 0 on the outermost ring, which no particle reaches
inline double curvature_load(const NodeGrid& nodes, std::size_t i, std::int64_t column, std::int64_t row,
                             double u, double v) noexcept {
    if (column <= 0 || row <= 0 || column >= nodes.stride() - 1 || row >= nodes.padded_rows() - 1) return 0;
    const auto step = static_cast<std::size_t>(nodes.stride());
    const double *z = nodes.bed.data() + i, *south = z - step, *north = z + step;
    const double inverse_dx2 = 1 / (nodes.cell_size() * nodes.cell_size());
    const double west = south[-1] + z[-1] + north[-1], east = south[1] + z[1] + north[1];
    const double below = south[-1] + south[0] + south[1], above = north[-1] + north[0] + north[1];
    const double xx = (west - 2 * (south[0] + z[0] + north[0]) + east) * inverse_dx2 / 3;
    const double yy = (below - 2 * (z[-1] + z[0] + z[1]) + above) * inverse_dx2 / 3;
    const double xy = (north[1] + south[-1] - north[-1] - south[1]) * inverse_dx2 / 4;
    return u * u * xx + 2 * u * v * xy + v * v * yy;
}

}  // namespace frana
