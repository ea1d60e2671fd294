// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mpm/node_grid.h"
#include "mpm/shape.h"
#include "particles/particle_set.h"
#include "particles/tile_order.h"

namespace frana {

/// Adds mass, momentum and area of a tile's particles to the nodes (paper, equations 27 and 29; affine part: APIC).
/// Reads x, y, u, v, volume, area, and c_* if Affine; adds to NodeSums.
template <class Shape, bool Affine, bool Levels>
void particles_to_nodes(const ParticleTile& tile, const ParticleSet& particles, NodeGrid& nodes) {
    const double* x = particles[Field::x];
    const double* y = particles[Field::y];
    const double* u = particles[Field::u];
    const double* v = particles[Field::v];
    const double* volume = particles[Field::volume];
    const double* area = particles[Field::area];
    const double* c_xx = particles[Field::c_xx];
    const double* c_xy = particles[Field::c_xy];
    const double* c_yx = particles[Field::c_yx];
    const double* c_yy = particles[Field::c_yy];
    const NodeScale grid = nodes.scale();
    const double dx = grid.dx;
    const std::int64_t stride = grid.stride;
    NodeSums* const sums = nodes.sums();
    const double* const bed = nodes.bed.data();

    for (std::size_t p = tile.begin; p < tile.end; ++p) {
        const Stencil<Shape> s(x[p], y[p], grid);
        double u0 = u[p], v0 = v[p], u_a = 0, v_a = 0, u_b = 0, v_b = 0;
        if constexpr (Affine) {
            u0 += c_xx[p] * s.to_first_x + c_xy[p] * s.to_first_y;
            v0 += c_yx[p] * s.to_first_x + c_yy[p] * s.to_first_y;
            u_a = c_xx[p] * dx;
            v_a = c_yx[p] * dx;
            u_b = c_xy[p] * dx;
            v_b = c_yy[p] * dx;
        }
        double z = 0, depth = 0;
        if constexpr (Levels) {
            z = interpolate(s, bed, stride).value;
            depth = volume[p] / area[p];
        }
        for (int b = 0; b < Shape::width; ++b) {
            NodeSums* row = sums + s.first + b * stride;
            for (int a = 0; a < Shape::width; ++a) {
                const double w = s.wx[a] * s.wy[b];
                const double mass = w * volume[p];
                row[a].mass += mass;
                row[a].px += mass * (u0 + a * u_a + b * u_b);
                row[a].py += mass * (v0 + a * v_a + b * v_b);
                row[a].area += w * area[p];
                if constexpr (Levels) {
                    const double above = z - bed[s.first + static_cast<std::size_t>(b * stride + a)];
                    row[a].area_bed += w * area[p] * above;
                    row[a].bed_squares += w * area[p] * above * above;
                    row[a].surface_squares += w * area[p] * (above + depth) * (above + depth);
                }
            }
        }
    }
}

}  // namespace frana
