// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mpm/nodes_to_particles.h"
#include "mpm/vector/chunk_stencil.h"
#include "mpm/vector/stress_bingham.h"

namespace frana {
namespace {

/// What four particles gather from their nodes; each quad holds one quantity of the four.
template <bool FollowsBed, bool Shifts>
struct ChunkGather {
    Quad cell_depth, share, climb, support;
    Quad depth_x, depth_y, share_x, share_y, least;  // if Shifts: gradients of the first two; least share of any node
    Quad u, v, back_u, back_v;                       // nodal velocity in map view; what the particles take back
    Quad u_x, u_y, v_x, v_y;                         // gradient of the former
    Quad m_xx, m_xy, m_yx, m_yy;                     // first moments of the latter
    Quad bend, change;                               // of the nodal velocity along the axes, see shock_compression
    Quad bed_x, bed_y;                               // if FollowsBed: gradient of the bed, through the splines

    /// Each node is two quads, {u, v, back_u, back_v} and {mass, share, climb, support}. Particle by particle only the
    /// sums of the first along rows and along columns are made, with the splines' weights, and the mean of the second;
    /// all else follows from those seven, four particles at once.
    FRANA_INLINE ChunkGather(Quad px, Quad py, const NodeScale& grid, const NodeMotion* motion, const double* bed) {
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
            const NodeMotion* row = motion + first[k];  // lanes that repeat the first particle do so here too
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
        share = means[1];
        climb = means[2];
        support = means[3];
        if constexpr (FollowsBed) gather_bed(ax, ay, wx, weight_y, grid, bed, first);
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
        const Quad u_low = columns[0][0], u_mean = columns[1][0], u_high = columns[2][0];
        const Quad v_low = rows[0][1], v_mean = rows[1][1], v_high = rows[2][1];
        bend = abs(u_low - 2 * u_mean + u_high) + abs(v_low - 2 * v_mean + v_high);
        change = (abs(u_mean - u_low) + abs(u_high - u_mean)) + (abs(v_mean - v_low) + abs(v_high - v_mean));
    }

  private:
    FRANA_INLINE void gather_bed(const ChunkAxis& ax, const ChunkAxis& ay, const Quad (&wx)[3],
                                 const double (&weight_y)[3][4], const NodeScale& grid, const double* bed,
                                 const std::size_t (&first)[4]) {
        alignas(32) double along_y[3][4];
        Quad slope[3];
        ay.slopes(grid.inverse_dx, slope);
        for (int b = 0; b < 3; ++b) slope[b].store(along_y[b]);
        Quad across[4], along[4];  // sums along the columns, with the splines' weights and with their slopes
        for (std::size_t k = 0; k < 4; ++k) {
            const double* const ground = bed + first[k];  // rows of four lanes: the last is left out below
            const Quad south = Quad::load(ground), middle = Quad::load(ground + grid.stride),
                       north = Quad::load(ground + 2 * grid.stride);
            across[k] = weight_y[0][k] * south + weight_y[1][k] * middle + weight_y[2][k] * north;
            along[k] = along_y[0][k] * south + along_y[1][k] * middle + along_y[2][k] * north;
        }
        transpose(across[0], across[1], across[2], across[3]);
        transpose(along[0], along[1], along[2], along[3]);
        ax.slopes(grid.inverse_dx, slope);
        bed_x = slope[0] * across[0] + slope[1] * across[1] + slope[2] * across[2];
        bed_y = wx[0] * along[0] + wx[1] * along[1] + wx[2] * along[2];
    }
    /// Gradients of depth and share, and the least share of any node: a sweep of its own over the second quads, since
    /// few steps shift.
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
        share_x = slopes[1];
        depth_y = slopes[2];
        share_y = slopes[3];
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

/// nodes_to_particles<QuadraticSplineShape, ApicTransfer, Stress, true, FollowsBed>, four particles at a time.
/// Shifts: whether ParticleUpdate::shift is not 0.
template <bool FollowsBed, bool Shifts, class Stress>
ParticleReport vector_nodes_to_particles(const ParticleTile& tile, const ParticleUpdate& k, const Stress& stress,
                                         const NodeGrid& nodes, ParticleSet& particles) {
    double *const x = particles[Field::x], *const y = particles[Field::y];
    double *const u = particles[Field::u], *const v = particles[Field::v];
    const double* const volume = particles[Field::volume];
    double* const area = particles[Field::area];
    double *const c_xx = particles[Field::c_xx], *const c_xy = particles[Field::c_xy];
    double *const c_yx = particles[Field::c_yx], *const c_yy = particles[Field::c_yy];
    double* const compression = particles[Field::compression];
    double *const s_xx = particles[Field::s_xx], *const s_xy = particles[Field::s_xy];
    double* const s_yy = particles[Field::s_yy];
    double *const q_xx = particles[Field::q_xx], *const q_xy = particles[Field::q_xy];
    double* const q_yy = particles[Field::q_yy];
    const NodeScale grid = nodes.scale();
    const double courant = k.dt * grid.inverse_dx, cell_area = grid.dx * grid.dx;
    const double largest_claim = k_largest_claim * cell_area;
    const Bounds edges = nodes.bounds();
    const double margin = 1e-9 * grid.dx;
    const NodeMotion* const motion = nodes.motion();
    ParticleReport report;
    Quad wave_speed = 0.0, greatest_speed = 0.0, diffusivity = 0.0, front_squared = 0.0, longest = 0.0;
    Quad kinetic = 0.0, inside_volume = 0.0;
    Quad::Mask clamped{}, non_finite{}, outside{};  // counted downwards: true is -1

    for_chunks(tile.begin, tile.end, [&](std::size_t p, auto n) FRANA_INLINE_LAMBDA {
        const Quad::Mask real = first_lanes(n);
        const Quad old_x = load_some(x + p, n), old_y = load_some(y + p, n);
        const Quad mass = load_some(volume + p, n), old_area = load_some(area + p, n);
        const ChunkGather<FollowsBed, Shifts> g(old_x, old_y, grid, motion, nodes.bed.data());

        const double d = 4 * grid.inverse_dx * grid.inverse_dx;  // inverse of the spline's second moment
        {
            const Quad xx = d * g.m_xx, xy = d * g.m_xy, yx = d * g.m_yx, yy = d * g.m_yy;
            // At a free front no more than the celerity allows; squares, since few particles are at one.
            const Quad free = (1 - g.support) * grid.dx;
            const Quad free2 = free * free * (xx * xx + xy * xy + yx * yx + yy * yy);
            Quad bound2 = (k_front_shear * k_front_shear * k.gravity) * mass / old_area;
            if constexpr (FollowsBed) {
                const Quad in_map = g.u * g.u + g.v * g.v;
                bound2 = select(in_map > 0, bound2 * (g.back_u * g.back_u + g.back_v * g.back_v) / in_map, bound2);
            }
            Quad fit = 1.0;
            if (any(free2 > bound2)) fit = select(free2 > bound2, sqrt(bound2 / free2), 1.0);
            store_some(fit * xx, c_xx + p, n);
            store_some(fit * xy, c_xy + p, n);
            store_some(fit * yx, c_yx + p, n);
            store_some(fit * yy, c_yy + p, n);
        }
        Quad back_u = g.back_u, back_v = g.back_v;
        if constexpr (FollowsBed) {
            const Quad slope_x = g.bed_x, slope_y = g.bed_y;
            // BedFrame::in_map of what forces changed of the velocity along the bed.
            const Quad root = sqrt(1 + slope_x * slope_x + slope_y * slope_y);
            const Quad rate_x = d * (g.m_xx * g.u + g.m_xy * g.v), rate_y = d * (g.m_yx * g.u + g.m_yy * g.v);
            const Quad lift = (rate_x * slope_x + rate_y * slope_y) / (root * (root + 1));
            const double half = 0.5 * k.dt;
            const Quad mean_u = g.u - half * (g.u_x * g.u + g.u_y * g.v - (rate_x - lift * slope_x)),
                       mean_v = g.v - half * (g.v_x * g.u + g.v_y * g.v - (rate_y - lift * slope_y));
            const Quad work = k.pull * g.support * (g.climb - (mean_u * slope_x + mean_v * slope_y));
            const Quad most = back_u * back_u + back_v * back_v + k.gravity * mass / old_area;
            const Quad change = min(max(select(most > 0, work / most, 0.0), -k_work_limit), k_work_limit);
            back_u += change * back_u;
            back_v += change * back_v;
        }
        store_some(back_u, u + p, n);
        store_some(back_v, v + p, n);

        const Quad div = g.u_x + g.v_y;
        store_some(select((div < 0) & (g.change > 0), -div * g.bend / g.change, 0.0), compression + p, n);
        const Quad determinant = 1 + k.dt * div + k.dt * k.dt * (g.u_x * g.v_y - g.u_y * g.v_x);
        const Quad::Mask sound = determinant > k_least_growth;
        clamped += ~sound & real;
        Quad growth = select(sound, determinant, k_least_growth);
        const Quad::Mask tower = mass * g.share * cell_area > k_tower * old_area * g.cell_depth;
        growth = select((growth < 1) & ((g.share < k_full_share) | tower), 1.0, growth);
        Quad new_area = old_area * growth;
        {  // F = I + dt grad v
            const ParticleShape<Quad> old{load_some(q_xx + p, n), load_some(q_xy + p, n), load_some(q_yy + p, n)};
            const auto [xx, xy, yy] =
                deformed<Quad>(old, 1 + k.dt * g.u_x, k.dt * g.u_y, k.dt * g.v_x, 1 + k.dt * g.v_y);
            const Quad trace = xx + yy;
            longest = select(real & (mass > k.film * old_area), max(longest, trace), longest);
            Quad fit = 1.0;
            if (any(trace > largest_claim)) fit = min(1.0, largest_claim / trace);
            store_some(fit * xx, q_xx + p, n);
            store_some(fit * xy, q_xy + p, n);
            store_some(fit * yy, q_yy + p, n);
        }
        const Quad speed2 = g.u * g.u + g.v * g.v, speed = sqrt(speed2);
        const Quad gain = select(g.share > k_crowded_share, k_crowded_gain, k_relaxation_gain);
        const Quad beta = min(k_relaxation_limit, gain * speed * courant);
        const Quad relaxed = new_area * (1 + beta * (1 / g.share - 1));
        new_area = select((g.share > 1) | (g.support > 0.999), relaxed, new_area);
        new_area = min(new_area, max(old_area, largest_claim));
        const Quad depth = mass / new_area;
        if constexpr (Stress::active) {
            const QuadStress t = bingham_stress(stress, g.u_x, 0.5 * (g.u_y + g.v_x), g.v_y, g.u, g.v, depth);
            store_some(t.xx, s_xx + p, n);
            store_some(t.xy, s_xy + p, n);
            store_some(t.yy, s_yy + p, n);
            diffusivity = max(diffusivity, t.diffusivity);
        }
        Quad px = old_x + k.dt * g.u, py = old_y + k.dt * g.v;
        if constexpr (Shifts) {
            const Shift<Quad> shift = shift_of(k.shift, speed * courant, g.support, g.least, g.share, g.share_x,
                                               g.share_y, g.cell_depth, g.depth_x, g.depth_y, grid.dx);
            px += shift.x;
            py += shift.y;
            new_area = new_area * shift.growth;
        }
        store_some(new_area, area + p, n);
        if (k.wall) {
            px = min(max(px, edges.west + margin), edges.east - margin);
            py = min(max(py, edges.south + margin), edges.north - margin);
        }
        if (nodes.any_solid()) {
            for (std::size_t i = 0; i < n; ++i) {
                const auto l = static_cast<int>(i);
                double along_x = px[l], along_y = py[l];
                slide_along_walls(nodes, old_x[l], old_y[l], along_x, along_y);
                px.v[l] = along_x;
                py.v[l] = along_y;
            }
        }
        const Quad wave = speed + sqrt(k.gravity * depth);
        const Quad::Mask finite = (wave < 1e9) & (abs(px) < 1e12) & (abs(py) < 1e12);
        store_some(select(finite, px, old_x), x + p, n);
        store_some(select(finite, py, old_y), y + p, n);
        const Quad::Mask inside =
            finite & real & (px >= edges.west) & (px < edges.east) & (py >= edges.south) & (py < edges.north);
        non_finite += ~finite & real;
        outside += finite & ~inside & real;
        if (nodes.any_solid()) {
            for (std::size_t i = 0; i < n; ++i) {
                const auto l = static_cast<int>(i);
                if (inside[l] && nodes.is_gap(grid.node_of(px[l], py[l]))) ++report.no_data;
            }
        }
        const Quad ox = px - k.origin.x, oy = py - k.origin.y;
        wave_speed = select(inside, max(wave_speed, wave), wave_speed);
        greatest_speed = select(inside, max(greatest_speed, speed), greatest_speed);
        front_squared = select(inside, max(front_squared, ox * ox + oy * oy), front_squared);
        kinetic += select(inside, 0.5 * mass * (back_u * back_u + back_v * back_v), 0.0);
        inside_volume += select(inside, mass, 0.0);
    });
    report.clamped = count(clamped);
    report.non_finite = count(non_finite);
    report.outside = count(outside);
    report.wave_speed = greatest(wave_speed);
    report.speed = greatest(greatest_speed);
    report.diffusivity = greatest(diffusivity);
    report.front_squared = greatest(front_squared);
    report.longest = greatest(longest);
    report.kinetic = sum(kinetic);
    report.volume = sum(inside_volume);
    return report;
}

}  // namespace
}  // namespace frana
