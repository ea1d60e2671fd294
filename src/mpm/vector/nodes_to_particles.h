// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mpm/particle_update.h"
#include "mpm/vector/chunk_stencil.h"

namespace frana {
namespace {

/// Values gathered by four particles; those needed only by Shifts are not set without it.
template <bool Shifts>
struct ChunkGather : Gathered<Quad> {
    /// Each node is two quads, {u, v, back_u, back_v} and {mass, fraction, unused, support}. Particle by particle only
    /// the sums of the first along rows and along columns are computed, with the splines' weights, and the mean of the
    /// second; all else follows from those seven, for four particles at once.
    FRANA_INLINE ChunkGather(Quad px, Quad py, const NodeScale& grid, const NodeMotion* motion) {
        const ChunkAxis ax(px, grid), ay(py, grid);
        std::size_t first[4];
        first_nodes(ax, ay, grid, first);
        Quad wx[3], wy[3];
        ax.weights(wx);
        ay.weights(wy);
        alignas(32) double weight_x[3][4], weight_y[3][4];
        for (int a = 0; a < 3; ++a) {
            wx[a].store(weight_x[a]);
            wy[a].store(weight_y[a]);
        }
        Quad rows[3][4], columns[3][4], means[4];
        for (std::size_t k = 0; k < 4; ++k) {
            const NodeMotion* row = motion + first[k];  // lanes that repeat the first particle do so here as well
            const Quad w0(weight_x[0][k]), w1(weight_x[1][k]), w2(weight_x[2][k]);
            Quad column0 = 0.0, column1 = 0.0, column2 = 0.0;
            Quad mean = 0.0;
            for (int b = 0; b < 3; ++b, row += grid.stride) {
                const Quad west = Quad::load(&row[0].u), middle = Quad::load(&row[1].u), east = Quad::load(&row[2].u);
                const Quad weight(weight_y[b][k]);
                rows[b][k] = w0 * west + w1 * middle + w2 * east;
                column0 += weight * west;
                column1 += weight * middle;
                column2 += weight * east;
                mean += weight *
                        (w0 * Quad::load(&row[0].mass) + w1 * Quad::load(&row[1].mass) + w2 * Quad::load(&row[2].mass));
            }
            columns[0][k] = column0;
            columns[1][k] = column1;
            columns[2][k] = column2;
            means[k] = mean;
        }
        transpose(means[0], means[1], means[2], means[3]);
        cell_depth = means[0];
        fraction = means[1];
        support = means[3];
        if constexpr (Shifts) gather_slopes(ax, ay, weight_x, weight_y, grid, motion, first);
        for (int a = 0; a < 3; ++a) {
            transpose(rows[a][0], rows[a][1], rows[a][2], rows[a][3]);
            transpose(columns[a][0], columns[a][1], columns[a][2], columns[a][3]);
        }
        u = weighted(wy, rows, 0);
        v = weighted(wy, rows, 1);
        back_u = weighted(wy, rows, 2);
        back_v = weighted(wy, rows, 3);
        Quad slope[3], moment[3];
        ax.slopes(grid.inverse_dx, slope);
        moments(ax, px, wx, grid, moment);
        u_x = weighted(slope, columns, 0);
        v_x = weighted(slope, columns, 1);
        m_xx = weighted(moment, columns, 2);
        m_yx = weighted(moment, columns, 3);
        ay.slopes(grid.inverse_dx, slope);
        moments(ay, py, wy, grid, moment);
        u_y = weighted(slope, rows, 0);
        v_y = weighted(slope, rows, 1);
        m_xy = weighted(moment, rows, 2);
        m_yy = weighted(moment, rows, 3);
        // u from column to column, v from row to row.
        bend = bend_of(columns[0][0], columns[1][0], columns[2][0], rows[0][1], rows[1][1], rows[2][1]);
    }

  private:
    /// Gradients of depth and fraction, and the least fraction of any node: a separate sweep over the second quads,
    /// since few steps shift.
    FRANA_INLINE void gather_slopes(const ChunkAxis& ax, const ChunkAxis& ay, const double (&weight_x)[3][4],
                                    const double (&weight_y)[3][4], const NodeScale& grid, const NodeMotion* motion,
                                    const std::size_t (&first)[4]) {
        alignas(32) double along_x[3][4], along_y[3][4];
        Quad slope[3];
        ax.slopes(grid.inverse_dx, slope);
        for (int a = 0; a < 3; ++a) slope[a].store(along_x[a]);
        ay.slopes(grid.inverse_dx, slope);
        for (int a = 0; a < 3; ++a) slope[a].store(along_y[a]);
        Quad slopes[4], lows[4];
        for (std::size_t k = 0; k < 4; ++k) {
            const NodeMotion* row = motion + first[k];
            Quad slope_x = 0.0, slope_y = 0.0, low = 1.0;
            for (int b = 0; b < 3; ++b, row += grid.stride) {
                const Quad west = Quad::load(&row[0].mass), middle = Quad::load(&row[1].mass),
                           east = Quad::load(&row[2].mass);
                slope_x += Quad(weight_y[b][k]) *
                           (Quad(along_x[0][k]) * west + Quad(along_x[1][k]) * middle + Quad(along_x[2][k]) * east);
                slope_y += Quad(along_y[b][k]) *
                           (Quad(weight_x[0][k]) * west + Quad(weight_x[1][k]) * middle + Quad(weight_x[2][k]) * east);
                low = min(min(low, west), min(middle, east));
            }
            slopes[k] = first_halves(slope_x, slope_y);
            lows[k] = low;
        }
        transpose(slopes[0], slopes[1], slopes[2], slopes[3]);
        depth_x = slopes[0];
        fraction_x = slopes[1];
        depth_y = slopes[2];
        fraction_y = slopes[3];
        least = {lows[0][1], lows[1][1], lows[2][1], lows[3][1]};
    }
    static FRANA_INLINE Quad weighted(const Quad (&weights)[3], const Quad (&sums)[3][4], int quantity) {
        return weights[0] * sums[0][quantity] + weights[1] * sums[1][quantity] + weights[2] * sums[2][quantity];
    }
    static FRANA_INLINE void moments(const ChunkAxis& axis, Quad position, const Quad (&weights)[3],
                                     const NodeScale& grid, Quad (&moment)[3]) {
        const Quad to_first = axis.to_first(position, grid.dx);
        for (int a = 0; a < 3; ++a) moment[a] = weights[a] * (to_first + a * grid.dx);
    }
};

/// nodes_to_particles<QuadraticSplineShape, ApicTransfer, Stress, true>, four particles at a time.
/// Shifts: whether ParticleUpdate::shift is not 0.
template <bool Shifts, class Stress>
ParticleReport vector_nodes_to_particles(const ParticleTile& tile, const ParticleUpdate& k, const Stress& stress,
                                         const NodeGrid& nodes, ParticleSet& particles) {
    const NodeScale grid = nodes.scale();
    const double *const x = particles[Field::x], *const y = particles[Field::y];
    const double inverse_moment = 4 * grid.inverse_dx * grid.inverse_dx;
    ParticleSweep<Quad, true, Stress, true, Shifts> update{
        k, stress, nodes, particles, inverse_moment, solid_near(nodes, particles, tile.begin, tile.end)};
    for_chunks(tile.begin, tile.end, [&](std::size_t p, auto n) FRANA_INLINE_LAMBDA {
        const Quad old_x = load_some(x + p, n), old_y = load_some(y + p, n);
        const ChunkGather<Shifts> gathered(old_x, old_y, grid, nodes.motion());
        update(p, n, old_x, old_y, gathered);
    });
    return update.report();
}

}  // namespace
}  // namespace frana
