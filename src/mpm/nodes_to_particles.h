// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <type_traits>

#include "mpm/particle_update.h"
#include "mpm/shape.h"
#include "particles/tile_order.h"

namespace frana {

/// Transfer of velocity from the nodes to the particles (paper, equations 33-34). FLIP is PIC with NodeUpdate::kept
/// = 1.
struct PicTransfer {
    static constexpr bool affine = false;
};
struct ApicTransfer {
    static constexpr bool affine = true;
};

/// Returns the second difference of the nodal velocity, u from column to column, v from row to row.
inline Bend<double> bend_on(const Stencil<QuadraticSplineShape>& s, const NodeMotion* motion, std::int64_t stride) {
    double u[3] = {0, 0, 0}, v[3] = {0, 0, 0};
    for (int b = 0; b < 3; ++b) {
        const NodeMotion* row = motion + s.first + b * stride;
        for (int a = 0; a < 3; ++a) {
            u[a] += s.wy[b] * row[a].u;
            v[b] += s.wx[a] * row[a].v;
        }
    }
    return bend_of(u[0], u[1], u[2], v[0], v[1], v[2]);
}

/// Computes new velocity, position, depth and stress of a tile's particles (paper, equations 33-38). Reads NodeMotion;
/// reads and writes x, y, u, v, area; writes c_* (affine), compression (Relaxed), s_* (Stress). Relaxed adds the area
/// relaxation, which ties h_p to the mass on the grid: A grows or shrinks with the fraction of each cell that particles
/// claim, and only shrinks at a free front. Relaxed and affine together also update the particle's shape q_*, which
/// decides about splitting, and shift the particle (shifting.h). A particle that leaves through an open boundary
/// remains in the arrays until the next sort and is counted `outside`.
///
/// u, v are the velocity that the nodes return in back_u, back_v, along the bed if they do so (BedFrame); positions
/// move with the nodes' velocity in map view.
template <class Shape, class Transfer, class Stress, bool Relaxed>
ParticleReport nodes_to_particles(const ParticleTile& tile, const ParticleUpdate& k, const Stress& stress,
                                  const NodeGrid& nodes, ParticleSet& particles) {
    constexpr bool affine = Transfer::affine, shifts = Relaxed && affine;
    const NodeScale grid = nodes.scale();
    const double dx = grid.dx;
    const double *const x = particles[Field::x], *const y = particles[Field::y];
    const NodeMotion* const motion = nodes.motion();
    // For the splines the inverse of the second moment; for hat functions the affine part is the gradient itself (Jiang
    // et al. 2015).
    const double inverse_moment = Shape::width == 3 ? 4 * grid.inverse_dx * grid.inverse_dx : 1;
    ParticleSweep<double, affine, Stress, Relaxed, shifts> update{
        k, stress, nodes, particles, inverse_moment, solid_near(nodes, particles, tile.begin, tile.end)};

    for (std::size_t p = tile.begin; p < tile.end; ++p) {
        const Stencil<Shape> s(x[p], y[p], grid);
        Gathered<double> g{};
        g.least = 1;
        for (int b = 0; b < Shape::width; ++b) {
            const NodeMotion* row = motion + s.first + b * grid.stride;
            const double to_y = s.to_first_y + b * dx;
            for (int a = 0; a < Shape::width; ++a) {
                const double w = s.wx[a] * s.wy[b], gx = s.gx[a] * s.wy[b], gy = s.wx[a] * s.gy[b];
                const double nu = row[a].u, nv = row[a].v;
                g.u += w * nu;
                g.v += w * nv;
                g.back_u += w * row[a].back_u;
                g.back_v += w * row[a].back_v;
                g.u_x += gx * nu;
                g.u_y += gy * nu;
                g.v_x += gx * nv;
                g.v_y += gy * nv;
                if constexpr (affine && Shape::width == 3) {
                    const double to_x = s.to_first_x + a * dx;
                    g.m_xx += w * row[a].back_u * to_x;
                    g.m_xy += w * row[a].back_u * to_y;
                    g.m_yx += w * row[a].back_v * to_x;
                    g.m_yy += w * row[a].back_v * to_y;
                } else if constexpr (affine) {
                    g.m_xx += gx * row[a].back_u;
                    g.m_xy += gy * row[a].back_u;
                    g.m_yx += gx * row[a].back_v;
                    g.m_yy += gy * row[a].back_v;
                }
                if constexpr (Relaxed) {
                    g.fraction += w * row[a].fraction;
                    g.cell_depth += w * row[a].mass;
                    g.support += w * row[a].support;
                }
                if constexpr (shifts) {
                    g.fraction_x += gx * row[a].fraction;
                    g.fraction_y += gy * row[a].fraction;
                    g.depth_x += gx * row[a].mass;
                    g.depth_y += gy * row[a].mass;
                    g.least = std::min(g.least, row[a].fraction);
                }
            }
        }
        if constexpr (Relaxed) {
            if (g.u_x + g.v_y < 0) g.bend = bend_on(s, motion, grid.stride);
        }
        update(p, std::integral_constant<std::size_t, 1>{}, x[p], y[p], g);
    }
    return update.report();
}

}  // namespace frana
