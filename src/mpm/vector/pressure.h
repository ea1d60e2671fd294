// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mpm/pressure.h"
#include "mpm/vector/chunk_stencil.h"

namespace frana {
namespace {

/// The nodes touched by a run of particles, in padded indices; with one more column, which rows of four lanes read and
/// write with weight zero.
struct NodeBox {
    static constexpr std::int64_t k_columns = 36, k_rows = 36;
    std::int64_t i0, j0, columns, rows;

    NodeBox(const double* x, const double* y, std::size_t begin, std::size_t end, const NodeScale& grid) {
        Quad x_low(x[begin]), x_high(x[begin]), y_low(y[begin]), y_high(y[begin]);
        for (std::size_t p = begin; p < end; p += 4) {
            const std::size_t n = end - p < 4 ? end - p : 4;
            const Quad px = load_some(x + p, n), py = load_some(y + p, n);
            x_low = min(x_low, px);
            x_high = max(x_high, px);
            y_low = min(y_low, py);
            y_high = max(y_high, py);
        }
        const ChunkAxis west(-greatest(-x_low), grid), east(greatest(x_high), grid);
        const ChunkAxis south(-greatest(-y_low), grid), north(greatest(y_high), grid);
        i0 = static_cast<std::int64_t>(west.first(grid.origin_x)[0]);
        j0 = static_cast<std::int64_t>(south.first(grid.origin_y)[0]);
        columns = static_cast<std::int64_t>(east.first(grid.origin_x)[0]) - i0 + 4;
        rows = static_cast<std::int64_t>(north.first(grid.origin_y)[0]) - j0 + 3;
    }
    [[nodiscard]] bool fits() const { return columns <= k_columns && rows <= k_rows; }
};

/// NodeLevel and the forces of a box of nodes, one array each, so that a row of nodes is one load.
struct LevelBox {
    static constexpr std::size_t k_size = NodeBox::k_columns * NodeBox::k_rows + 4;
    alignas(32) double thickness[k_size];  // (1 - ponding) depth
    alignas(32) double level[k_size], ponding[k_size], support[k_size], held[k_size], share[k_size];
    alignas(32) double fx[k_size], fy[k_size];
    Shares shares = Shares::none;

    LevelBox(const NodeBox& box, const NodeGrid& nodes) {
        const std::int64_t last = nodes.stride() - 1;
        double least = 1, most = 0;
        for (std::int64_t j = 0; j < box.rows; ++j) {
            const NodeLevel* row = nodes.levels.data() + (box.j0 + j) * nodes.stride();
            const std::int64_t to = j * NodeBox::k_columns;
            for (std::int64_t i = 0; i < box.columns; ++i) {
                const NodeLevel& from = row[box.i0 + i < last ? box.i0 + i : last];
                thickness[to + i] = (1 - from.ponding) * from.depth;
                level[to + i] = from.level;
                ponding[to + i] = from.ponding;
                support[to + i] = from.support;
                held[to + i] = from.held;
                share[to + i] = from.share;
                least = from.share < least ? from.share : least;
                most = from.share > most ? from.share : most;
                fx[to + i] = fy[to + i] = 0;
            }
        }
        shares = !(most > 0) ? Shares::none : least < 1 ? Shares::any : Shares::all;
    }
    void add_forces_to(const NodeBox& box, NodeGrid& nodes) const {
        for (std::int64_t j = 0; j < box.rows; ++j) {
            NodeForces* row = nodes.forces() + (box.j0 + j) * nodes.stride() + box.i0;
            const std::int64_t from = j * NodeBox::k_columns;
            for (std::int64_t i = 0; i + 1 < box.columns; ++i) {
                row[i].fx += fx[from + i];
                row[i].fy += fy[from + i];
            }
        }
    }
};

/// Adds the forces of a tile's particles to the copy of their nodes.
template <bool Stress, Shares Held>
void push_in_box(const ParticleTile& tile, const ParticleSet& particles, double gravity, const NodeGrid& nodes,
                 const NodeBox& box, LevelBox& local) {
    const double *const x = particles[Field::x], *const y = particles[Field::y];
    const double *const volume = particles[Field::volume], *const area = particles[Field::area];
    const double* const compression = particles[Field::compression];
    const double *const s_xx = particles[Field::s_xx], *const s_xy = particles[Field::s_xy];
    const double* const s_yy = particles[Field::s_yy];
    const NodeScale grid = nodes.scale();
    const double* const bed = nodes.bed.data();
    const Quad shift{-0.5, 0, 0.5, 0}, square{0.5, -1, 0.5, 0}, constant{0, 0.75, 0, 0};
    const Quad linear = Quad{1, -2, 1, 0} * grid.inverse_dx, slope_constant = shift * grid.inverse_dx;

    for_chunks(tile.begin, tile.end, [&](std::size_t p, auto n) FRANA_INLINE_LAMBDA {
        const ChunkAxis ax(load_some(x + p, n), grid), ay(load_some(y + p, n), grid);
        std::size_t first[4];
        first_nodes(ax, ay, grid, first);
        alignas(32) double offset_x[4], weight_y[3][4], slope_y[3][4], box_first[4];
        ax.offset.store(offset_x);
        {
            Quad wy[3], gy[3];
            ay.weights(wy);
            ay.slopes(grid.inverse_dx, gy);
            for (int b = 0; b < 3; ++b) {
                wy[b].store(weight_y[b]);
                gy[b].store(slope_y[b]);
            }
        }
        (ay.first(grid.origin_y - box.j0) * static_cast<double>(NodeBox::k_columns) + ax.first(grid.origin_x - box.i0))
            .store(box_first);
        alignas(32) double pressure[4], depth[4], half_weight[4], weight[4];
        {
            const Quad mass = load_some(volume + p, n), claim = load_some(area + p, n), h = mass / claim;
            const Quad half = 0.5 * gravity * claim;
            shocked_pressure(half, h, mass, load_some(compression + p, n), gravity, grid.dx).store(pressure);
            h.store(depth);
            half.store(half_weight);
            (gravity * claim).store(weight);
        }
        for (std::size_t k = 0; k < n; ++k) {
            const Quad offset(offset_x[k]), h = offset + shift;
            const Quad wx = square * (h * h) + constant, gx = linear * offset + slope_constant;
            const double* const ground = bed + first[k];
            const Quad south = Quad::load(ground), middle = Quad::load(ground + grid.stride),
                       north = Quad::load(ground + 2 * grid.stride);
            const Quad across = weight_y[0][k] * south + weight_y[1][k] * middle + weight_y[2][k] * north;
            const Quad along = slope_y[0][k] * south + slope_y[1][k] * middle + slope_y[2][k] * north;
            const Quad z = sum_everywhere(wx * across), rise_x = sum_everywhere(gx * across),
                       rise_y = sum_everywhere(wx * along);
            ParticlePush<Quad> push{
                pressure[k], half_weight[k], depth[k], weight[k] * rise_x, weight[k] * rise_y, 0.0, 0.0, 0.0, 0.0};
            if constexpr (Stress) {
                push.xx = volume[p + k] * s_xx[p + k];
                push.xy = volume[p + k] * s_xy[p + k];
                push.yy = volume[p + k] * s_yy[p + k];
            }
            const auto at = static_cast<std::int64_t>(box_first[k]);
            if constexpr (Held != Shares::none) {
                const double* const held = local.held + at;
                push.held = sum_everywhere(wx * (weight_y[0][k] * Quad::load(held) +
                                                 weight_y[1][k] * Quad::load(held + NodeBox::k_columns) +
                                                 weight_y[2][k] * Quad::load(held + 2 * NodeBox::k_columns)));
            }
            for (int b = 0; b < 3; ++b) {
                const std::int64_t i = at + b * NodeBox::k_columns;
                const Quad wy(weight_y[b][k]), gy(slope_y[b][k]);
                const Quad share = Held == Shares::any ? Quad::load(local.share + i) : Quad(0.0);
                const auto reference = reference_of<Held, Quad>(
                    Quad::load(local.ponding + i), Quad::load(local.level + i), Quad::load(local.thickness + i),
                    Quad::load(local.support + i), share, z, push.held);
                const auto [force_x, force_y] =
                    push_on_node<true, Stress, Quad>(push, reference, wx * wy, gx * wy, wx * gy);
                (Quad::load(local.fx + i) + force_x).store(local.fx + i);
                (Quad::load(local.fy + i) + force_y).store(local.fy + i);
            }
        }
    });
}

/// pressure_to_nodes<QuadraticSplineShape, true, Stress>, a row of three nodes at a time (the fourth lane has weight
/// zero), on a copy of the nodes in which each row is contiguous.
template <bool Stress>
void vector_pressure_to_nodes(const ParticleTile& tile, const ParticleSet& particles, double gravity, NodeGrid& nodes) {
    if (tile.begin == tile.end) return;
    const NodeBox box(particles[Field::x], particles[Field::y], tile.begin, tile.end, nodes.scale());
    if (!box.fits()) {  // particles far apart: two runs
        const std::size_t middle = (tile.begin + tile.end) / 2;
        vector_pressure_to_nodes<Stress>({tile.begin, middle, tile.tile}, particles, gravity, nodes);
        vector_pressure_to_nodes<Stress>({middle, tile.end, tile.tile}, particles, gravity, nodes);
        return;
    }
    LevelBox local(box, nodes);
    const auto push = local.shares == Shares::none  ? push_in_box<Stress, Shares::none>
                      : local.shares == Shares::any ? push_in_box<Stress, Shares::any>
                                                    : push_in_box<Stress, Shares::all>;
    push(tile, particles, gravity, nodes, box, local);
    local.add_forces_to(box, nodes);
}

}  // namespace
}  // namespace frana
