// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "mpm/node_grid.h"
#include "mpm/shape.h"
#include "particles/particle_set.h"
#include "particles/tile_order.h"

namespace frana {

/// Linear artificial viscosity under compression, as a share of rho h sqrt(g h) dx (share/doc/numerics.md,
/// "Compression").
inline constexpr double k_shock_viscosity = 0.5;

/// Hydrostatic pressure, bed slope and in-plane stress, to the nodes' forces over density.
/// Plain form (paper, equation 28): F_i = sum A [ 1/2 g h^2 grad N_i - g h grad Z N_i ] - sum V sigma grad
/// N_i. Referenced form (share/doc/numerics.md, "Reference level"; NodeLevel): h^2 and h are measured against the
/// node's own still level or mean depth, which integrates to zero in the continuum, so that a uniform state exerts
/// exactly no force whatever the particles' arrangement; update_nodes adds back the weight of a reference
/// that follows the bed. Reads x, y, volume, area, s_* if Stress, compression if Referenced; reads NodeLevel;
/// adds to NodeForces fx, fy.
template <class Shape, bool Referenced, bool Stress>
void pressure_to_nodes(const ParticleTile& tile, const ParticleSet& particles, double gravity, NodeGrid& nodes) {
    const double* x = particles[Field::x];
    const double* y = particles[Field::y];
    const double* volume = particles[Field::volume];
    const double* area = particles[Field::area];
    const double* compression = particles[Field::compression];
    const double* s_xx = particles[Field::s_xx];
    const double* s_xy = particles[Field::s_xy];
    const double* s_yy = particles[Field::s_yy];
    const NodeScale grid = nodes.scale();
    const double dx = grid.dx;
    const std::int64_t stride = grid.stride;
    NodeForces* const forces = nodes.forces();
    const NodeLevel* const levels = nodes.levels.data();
    const double* const bed = nodes.bed.data();

    for (std::size_t p = tile.begin; p < tile.end; ++p) {
        const Stencil<Shape> s(x[p], y[p], grid);
        const Interpolated z = interpolate(s, bed, stride);
        const double depth = volume[p] / area[p];
        const double half_gravity_area = 0.5 * gravity * area[p];
        double pressure = half_gravity_area * depth * depth;
        if constexpr (Referenced) {
            pressure += k_shock_viscosity * volume[p] * std::sqrt(gravity * depth) * compression[p] * dx;
        }
        double xx = 0, xy = 0, yy = 0;
        if constexpr (Stress) {
            xx = volume[p] * s_xx[p];
            xy = volume[p] * s_xy[p];
            yy = volume[p] * s_yy[p];
        }
        const double slope_x = gravity * area[p] * z.dx, slope_y = gravity * area[p] * z.dy;
        for (int b = 0; b < Shape::width; ++b) {
            const std::size_t first = s.first + static_cast<std::size_t>(b * stride);
            for (int a = 0; a < Shape::width; ++a) {
                const std::size_t i = first + static_cast<std::size_t>(a);
                const double grad_x = s.gx[a] * s.wy[b], grad_y = s.wx[a] * s.gy[b], w = s.wx[a] * s.wy[b];
                double node_pressure = pressure, weight = depth * w;
                if constexpr (Referenced) {
                    const NodeLevel& level = levels[i];
                    const double reference =
                        level.ponding * std::max(0.0, level.level - z.value) + (1 - level.ponding) * level.depth;
                    node_pressure -= half_gravity_area * level.support * reference * reference;
                    weight = (depth - level.support * reference) * w;
                }
                forces[i].fx += (node_pressure - xx) * grad_x - xy * grad_y - slope_x * weight;
                forces[i].fy += (node_pressure - yy) * grad_y - xy * grad_x - slope_y * weight;
            }
        }
    }
}

}  // namespace frana
