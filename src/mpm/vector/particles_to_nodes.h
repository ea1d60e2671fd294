// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mpm/vector/chunk_stencil.h"
#include "particles/particle_set.h"
#include "particles/tile_order.h"

namespace frana {
namespace {

/// particles_to_nodes<QuadraticSplineShape, true, Levels>, four particles at a time: weights and contributions are
/// computed in parallel; then each particle adds two quads to each of its nine nodes,
///     {px, py, bed_squares, surface_squares}  and  {mass, area, area_bed, 0}, squares and area_bed only if Levels.
template <bool Levels>
void vector_particles_to_nodes(const ParticleTile &tile, const ParticleSet &particles, NodeGrid &nodes) {
    const double *const x = particles[Field::x], *const y = particles[Field::y];
    const double *const u = particles[Field::u], *const v = particles[Field::v];
    const double *const volume = particles[Field::volume], *const area = particles[Field::area];
    const double *const c_xx = particles[Field::c_xx], *const c_xy = particles[Field::c_xy];
    const double *const c_yx = particles[Field::c_yx], *const c_yy = particles[Field::c_yy];
    const NodeScale grid = nodes.scale();
    NodeSums *const sums = nodes.sums();
    const double *const bed = nodes.bed.data();

    for_chunks(tile.begin, tile.end, [&](std::size_t p, auto n) FRANA_INLINE_LAMBDA {
        const Quad px = load_some(x + p, n), py = load_some(y + p, n);
        const ChunkAxis ax(px, grid), ay(py, grid);
        std::size_t first[4];
        first_nodes(ax, ay, grid, first);
        alignas(32) double weight[9][4];
        {
            Quad wx[3], wy[3];
            ax.weights(wx);
            ay.weights(wy);
            for (int b = 0; b < 3; ++b) {
                for (int a = 0; a < 3; ++a) (wx[a] * wy[b]).store(weight[3 * b + a]);
            }
        }
        const Quad mass = load_some(volume + p, n), claim = load_some(area + p, n);
        const Quad cxx = load_some(c_xx + p, n), cxy = load_some(c_xy + p, n);
        const Quad cyx = load_some(c_yx + p, n), cyy = load_some(c_yy + p, n);
        const Quad to_x = ax.to_first(px, grid.dx), to_y = ay.to_first(py, grid.dx);
        // Rows: a particle's momentum at its first node, and the increments by column and by row.
        Quad at_first[4] = {mass * (load_some(u + p, n) + cxx * to_x + cxy * to_y),
                            mass * (load_some(v + p, n) + cyx * to_x + cyy * to_y), 0.0, 0.0};
        Quad by_column[4] = {mass * cxx * grid.dx, mass * cyx * grid.dx, 0.0, 0.0};
        Quad by_row[4] = {mass * cxy * grid.dx, mass * cyy * grid.dx, 0.0, 0.0};
        transpose(at_first[0], at_first[1], at_first[2], at_first[3]);
        transpose(by_column[0], by_column[1], by_column[2], by_column[3]);
        transpose(by_row[0], by_row[1], by_row[2], by_row[3]);
        alignas(32) double depth[4] = {};
        if constexpr (Levels) (mass / claim).store(depth);

        for (std::size_t k = 0; k < n; ++k) {
            double *const node = &sums[first[k]].px;
            const double *const ground = bed + first[k];
            const std::int64_t stride = grid.stride;
            double z = 0;
            if constexpr (Levels) {
                for (int b = 0; b < 3; ++b) {
                    const double *r = ground + b * stride;
                    z += (weight[3 * b][k] * r[0] + weight[3 * b + 1][k] * r[1]) + weight[3 * b + 2][k] * r[2];
                }
            }
            // With the bed's height t relative to that of the node: {.., .., area t^2, area (t + depth)^2} and area t.
            const double a_k = area[p + k];
            const Quad square{0, 0, a_k, a_k}, surface{0, 0, 0, depth[k]};
            const Quad keeps_rest{volume[p + k], a_k, 0, 0}, level{0, 0, a_k, 0};
            Quad row_brings = at_first[k];
            for (int b = 0; b < 3; ++b) {
                double *const row = node + 8 * b * stride;
                Quad brings = row_brings;
                for (int a = 0; a < 3; ++a) {
                    const Quad w(weight[3 * b + a][k]);
                    Quad moves = brings, stays = keeps_rest;
                    if constexpr (Levels) {
                        const Quad above(z - ground[b * stride + a]), height = above + surface;
                        moves += square * height * height;
                        stays += level * above;
                    }
                    (Quad::load(row + 8 * a) + w * moves).store(row + 8 * a);
                    (Quad::load(row + 8 * a + 4) + w * stays).store(row + 8 * a + 4);
                    brings += by_column[k];
                }
                row_brings += by_row[k];
            }
        }
    });
}

}  // namespace
}  // namespace frana
