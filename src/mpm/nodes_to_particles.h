// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "mpm/curvature.h"
#include "mpm/node_grid.h"
#include "mpm/particle_shape.h"
#include "mpm/shape.h"
#include "mpm/shifting.h"
#include "particles/particle_set.h"
#include "particles/tile_order.h"
#include "physics/stress_bingham.h"

namespace frana {

/// Gain per Courant number of the relaxation of areas (share/doc/numerics.md, "Area relaxation"); 0.2 bounds it.
/// Particles that crowd (k_crowded_share) shrink faster: friction and maps would see a layer thinner than the ground
/// does. Not from a share of 1 on, where half of all evenly spread irregular particles are: ritter-irregular would be
/// worse by 1/3.
inline constexpr double k_relaxation_gain = 0.03, k_crowded_gain = 0.2, k_relaxation_limit = 0.2;

/// Least factor by which an area may change in a step; the stable step keeps well clear of it.
inline constexpr double k_least_growth = 0.1;

/// Bound of a particle's area, and of its shape's trace, in cells: what cannot be split (films) grows no
/// further.
inline constexpr double k_largest_claim = 4;

/// Greatest difference of a particle's affine velocity over a cell at a free front, in celerities sqrt(g h), where no
/// support is left; with support s it is this over (1 - s). In a simple wave u + 2 sqrt(g h) is constant, so velocity
/// cannot vary by more than twice the celerity over the cell in which the depth goes to zero; without the bound the
/// foremost particles outrun 2 sqrt(g h) at every split.
inline constexpr double k_front_shear = 0.7;

/// A particle this many times deeper than its cells' mean depth is not compressed further.
inline constexpr double k_tower = 2;

/// Share of a cell from which it counts as full when material converges. Rounding must not decide about a lattice that
/// fills its cells exactly.
inline constexpr double k_full_share = 1 - 1e-9;

/// How velocity comes back from the nodes (paper, equations 33-34).
struct PicTransfer {
    static constexpr bool affine = false, increment = false;
};
struct FlipTransfer {
    static constexpr bool affine = false, increment = true;
};
struct ApicTransfer {
    static constexpr bool affine = true, increment = false;
};

struct ParticleUpdate {
    double dt = 0;  ///< for which the positions move [s]
    double gravity = 0;
    double film = 0;    ///< depth under which a particle is not split [m]
    bool wall = false;  ///< particles are kept inside; otherwise they may leave
    Point origin;       ///< release centroid, for the front distance, local metres
    double pull = 0;    ///< gravity times the time for which forces acted [m/s]; for what follows the bed
    double shift = 0;   ///< particle shifting: s of shifting.h, 0 in steps without it
};

/// What a tile's particles showed in a step; combined tile by tile in their order.
struct ParticleReport {
    double wave_speed = 0;     ///< greatest |v| + sqrt(g h) [m/s]
    double speed = 0;          ///< greatest |v| [m/s]
    double diffusivity = 0;    ///< greatest of the in-plane stress [m2/s]
    double front_squared = 0;  ///< farthest from the origin [m2]
    double kinetic = 0;        ///< sum of V v^2 / 2 [m5/s2]
    double volume = 0;         ///< inside [m3]
    double longest = 0;        ///< greatest trace of a shape that could be split [m2]
    std::int64_t outside = 0, non_finite = 0, no_data = 0, clamped = 0;

    void merge(const ParticleReport& r) noexcept {
        wave_speed = std::max(wave_speed, r.wave_speed);
        speed = std::max(speed, r.speed);
        diffusivity = std::max(diffusivity, r.diffusivity);
        front_squared = std::max(front_squared, r.front_squared);
        kinetic += r.kinetic;
        volume += r.volume;
        longest = std::max(longest, r.longest);
        outside += r.outside;
        non_finite += r.non_finite;
        no_data += r.no_data;
        clamped += r.clamped;
    }
};

/// Rate of compression that the artificial viscosity acts on [1/s]: -div v, weighted by how far the velocities on the
/// stencil are from linear, |v0 - 2 v1 + v2| / (|v1 - v0| + |v2 - v1|) along both axes. 1 behind a shock that rings, 0
/// where a flow converges smoothly: there a viscosity would only cost energy.
template <class Shape>
double shock_compression(const Stencil<Shape>& s, const NodeMotion* motion, std::int64_t stride, double divergence) {
    if (!(divergence < 0)) return 0;
    static_assert(Shape::width == 3);
    double u[3] = {0, 0, 0}, v[3] = {0, 0, 0};
    for (int b = 0; b < 3; ++b) {
        const NodeMotion* row = motion + s.first + b * stride;
        for (int a = 0; a < 3; ++a) {
            u[a] += s.wy[b] * row[a].u;
            v[b] += s.wx[a] * row[a].v;
        }
    }
    const double bend = std::abs(u[0] - 2 * u[1] + u[2]) + std::abs(v[0] - 2 * v[1] + v[2]);
    const double change = std::abs(u[1] - u[0]) + std::abs(u[2] - u[1]) + std::abs(v[1] - v[0]) + std::abs(v[2] - v[1]);
    return change > 0 ? -divergence * bend / change : 0;
}

/// A particle does not enter a wall's cell: it goes as far along the wall as either axis allows. Its cell then keeps it
/// a whole cell away from the nodes behind a wall one cell thick. Always inlined: the fast sweeps, compiled for another
/// instruction set, must share no function with the rest.
[[gnu::always_inline]] inline void slide_along_walls(const NodeGrid& nodes, double x, double y, double& px,
                                                     double& py) noexcept {
    const NodeScale grid = nodes.scale();
    const auto wall = [&](double a, double b) {
        return nodes.bounds().holds(a, b) && nodes.is_wall(grid.node_of(a, b));
    };
    if (!wall(px, py)) return;
    if (!wall(px, y)) {
        py = y;
    } else if (!wall(x, py)) {
        px = x;
    } else {
        px = x;
        py = y;
    }
}

/// Greatest share by which gravity's work sets the speed of a particle right in a step.
inline constexpr double k_work_limit = 0.5;

/// New velocity, position, depth and stress of a tile's particles (paper, equations 33-38).
/// Reads NodeMotion; reads and writes x, y, u, v, area; writes c_* (affine), compression
/// (Relaxed), s_* (Stress). Relaxed adds the area relaxation, which ties h_p to the mass on the grid: A grows
/// or shrinks with what the particles claim of each cell, and only shrinks at a free front. Relaxed and
/// affine together also carry the particle's shape q_*, which decides about splitting, and shift the particle
/// (shifting.h). A particle that leaves through an open boundary stays in the arrays until the next sort and is
/// counted `outside`.
///
/// FollowsBed: u, v are the velocity along the bed (BedFrame), which the nodes give back in fx, fy; positions move with
/// the nodes' velocity in map view. Gravity's work at the nodes, whose slopes are differences over two cells, is not
/// what the particle's way up or down the bed takes: the speed is set right by
///
///     work = pull support (sum N_i v_i . grad Z_i - m . grad Z),   m = v - dt/2 ((grad v) v - M^-1 (grad w) v)
///
/// with grad Z of the splines' bed where the particle was when gravity acted, and m the mean of the map velocities with
/// which it came there and went on, but for what forces changed of them: on a plane m = v, and nothing is set right.
/// M^-1 w is BedFrame::in_map. What moves slower than sqrt(g h) is driven by pressure as much as by gravity, which this
/// does not balance: there the correction fades with w^2 / (w^2 + g h), so that what is still stays so.
template <class Shape, class Transfer, class Stress, bool Relaxed, bool FollowsBed = false>
ParticleReport nodes_to_particles(const ParticleTile& tile, const ParticleUpdate& k, const Stress& stress,
                                  const NodeGrid& nodes, ParticleSet& particles) {
    double* const x = particles[Field::x];
    double* const y = particles[Field::y];
    double* const u = particles[Field::u];
    double* const v = particles[Field::v];
    const double* const volume = particles[Field::volume];
    double* const area = particles[Field::area];
    double* const c_xx = particles[Field::c_xx];
    double* const c_xy = particles[Field::c_xy];
    double* const c_yx = particles[Field::c_yx];
    double* const c_yy = particles[Field::c_yy];
    double* const compression = particles[Field::compression];
    double* const s_xx = particles[Field::s_xx];
    double* const s_xy = particles[Field::s_xy];
    double* const s_yy = particles[Field::s_yy];
    double* const q_xx = particles[Field::q_xx];
    double* const q_xy = particles[Field::q_xy];
    double* const q_yy = particles[Field::q_yy];
    const NodeScale grid = nodes.scale();
    const double dx = grid.dx, inverse_dx = grid.inverse_dx, courant = k.dt * inverse_dx;
    const double cell_area = dx * dx;
    const Bounds edges = nodes.bounds();
    const double margin = 1e-9 * dx;
    const std::int64_t stride = grid.stride;
    const NodeMotion* const motion = nodes.motion();
    ParticleReport report;

    for (std::size_t p = tile.begin; p < tile.end; ++p) {
        const Stencil<Shape> s(x[p], y[p], grid);
        double un = 0, vn = 0, wu = 0, wv = 0, share = 0, support = 0, cell_depth = 0, climb = 0;
        double u_x = 0, u_y = 0, v_x = 0, v_y = 0;      // gradient of the nodal velocity
        double m_xx = 0, m_xy = 0, m_yx = 0, m_yy = 0;  // for the affine part: first moments, gradient with hats
        [[maybe_unused]] double least = 1, share_x = 0, share_y = 0, depth_x = 0, depth_y = 0;  // for shifting
        for (int b = 0; b < Shape::width; ++b) {
            const NodeMotion* row = motion + s.first + b * stride;
            const double to_y = s.to_first_y + b * dx;
            for (int a = 0; a < Shape::width; ++a) {
                const double w = s.wx[a] * s.wy[b], gx = s.gx[a] * s.wy[b], gy = s.wx[a] * s.gy[b];
                const double nu = row[a].u, nv = row[a].v;
                un += w * nu;
                vn += w * nv;
                wu += w * row[a].back_u;
                wv += w * row[a].back_v;
                u_x += gx * nu;
                u_y += gy * nu;
                v_x += gx * nv;
                v_y += gy * nv;
                if constexpr ((Transfer::affine || FollowsBed) && Shape::width == 3) {
                    const double to_x = s.to_first_x + a * dx;
                    m_xx += w * row[a].back_u * to_x;
                    m_xy += w * row[a].back_u * to_y;
                    m_yx += w * row[a].back_v * to_x;
                    m_yy += w * row[a].back_v * to_y;
                } else if constexpr (Transfer::affine) {
                    m_xx += gx * row[a].back_u;
                    m_xy += gy * row[a].back_u;
                    m_yx += gx * row[a].back_v;
                    m_yy += gy * row[a].back_v;
                }
                if constexpr (FollowsBed) climb += w * row[a].climb;
                if constexpr (Relaxed) {
                    share += w * row[a].fraction;
                    cell_depth += w * row[a].mass;
                    support += w * row[a].support;
                    if constexpr (Transfer::affine) {
                        share_x += gx * row[a].fraction;
                        share_y += gy * row[a].fraction;
                        depth_x += gx * row[a].mass;
                        depth_y += gy * row[a].mass;
                        least = std::min(least, row[a].fraction);
                    }
                }
            }
        }
        const double celerity = std::sqrt(k.gravity * volume[p] / area[p]);
        // Of the splines the inverse of the second moment; hat functions: the affine part is the gradient itself (Jiang
        // et al. 2015).
        [[maybe_unused]] const double d = Shape::width == 3 ? 4 * inverse_dx * inverse_dx : 1;
        if constexpr (Transfer::affine) {
            c_xx[p] = d * m_xx;
            c_xy[p] = d * m_xy;
            c_yx[p] = d * m_yx;
            c_yy[p] = d * m_yy;
            if constexpr (Relaxed) {
                const double across =
                    dx * std::sqrt(c_xx[p] * c_xx[p] + c_xy[p] * c_xy[p] + c_yx[p] * c_yx[p] + c_yy[p] * c_yy[p]);
                double bound = k_front_shear * celerity;  // of velocities in map view
                if constexpr (FollowsBed) {
                    const double in_map = un * un + vn * vn;
                    if (in_map > 0) bound *= std::sqrt((wu * wu + wv * wv) / in_map);
                }
                if ((1 - support) * across > bound) {
                    const double fit = bound / ((1 - support) * across);
                    c_xx[p] *= fit;
                    c_xy[p] *= fit;
                    c_yx[p] *= fit;
                    c_yy[p] *= fit;
                }
            }
        }
        u[p] = Transfer::increment ? u[p] + wu : wu;
        v[p] = Transfer::increment ? v[p] + wv : wv;
        if constexpr (FollowsBed && Relaxed) {
            const Interpolated z = interpolate(s, nodes.bed.data(), stride);
            const double half = 0.5 * k.dt;
            const Point driven =
                BedFrame::of({z.dx, z.dy}).in_map(d * (m_xx * un + m_xy * vn), d * (m_yx * un + m_yy * vn));
            const double mean_u = un - half * (u_x * un + u_y * vn - driven.x);
            const double mean_v = vn - half * (v_x * un + v_y * vn - driven.y);
            const double work = k.pull * support * (climb - (mean_u * z.dx + mean_v * z.dy));
            const double most = u[p] * u[p] + v[p] * v[p] + celerity * celerity;
            const double change = std::clamp(most > 0 ? work / most : 0, -k_work_limit, k_work_limit);
            u[p] += change * u[p];
            v[p] += change * v[p];
        }
        // Equation (38) in two dimensions: the area follows the map x -> x + dt v(x), whose determinant this
        // is.
        const double div = u_x + v_y;
        double growth = 1 + k.dt * div + k.dt * k.dt * (u_x * v_y - u_y * v_x);
        if (!(growth > k_least_growth)) {
            growth = k_least_growth;
            ++report.clamped;
        }
        // Where the cells are not full, converging material first fills the gaps: only a full cell gets deeper, and no
        // particle gets much deeper than the cells round it, however long it is pressed into a corner.
        if constexpr (Relaxed) {
            const bool tower = volume[p] * share * cell_area > k_tower * area[p] * cell_depth;
            if (growth < 1 && (share < k_full_share || tower)) growth = 1;
        }
        double new_area = area[p] * growth;
        if constexpr (Relaxed && Transfer::affine) {  // F = I + dt grad v
            const auto [xx, xy, yy] =
                deformed<double>({q_xx[p], q_xy[p], q_yy[p]}, 1 + k.dt * u_x, k.dt * u_y, k.dt * v_x, 1 + k.dt * v_y);
            if (volume[p] > k.film * area[p]) report.longest = std::max(report.longest, xx + yy);
            const double fit = std::min(1.0, k_largest_claim * cell_area / (xx + yy));
            q_xx[p] = fit * xx;
            q_xy[p] = fit * xy;
            q_yy[p] = fit * yy;
        }
        const double speed2 = un * un + vn * vn, speed = std::sqrt(speed2);
        if constexpr (Relaxed) {
            compression[p] = shock_compression(s, motion, stride, div);
            const double gain = share > k_crowded_share ? k_crowded_gain : k_relaxation_gain;
            const double beta = std::min(k_relaxation_limit, gain * speed * courant);
            if (share > 1 || support > 0.999) new_area *= 1 + beta * (1 / share - 1);
        }
        // A film too thin to be split claims no more than a few cells: beyond that its support would be a
        // fiction.
        if constexpr (Relaxed) new_area = std::min(new_area, std::max(area[p], k_largest_claim * cell_area));
        area[p] = new_area;
        const double depth = volume[p] / new_area;
        if constexpr (Stress::active) {
            const PlaneStress t = stress({u_x, 0.5 * (u_y + v_x), v_y, un, vn, depth});
            s_xx[p] = t.xx;
            s_xy[p] = t.xy;
            s_yy[p] = t.yy;
            report.diffusivity = std::max(report.diffusivity, t.diffusivity);
        }
        double px = x[p] + k.dt * un, py = y[p] + k.dt * vn;
        if constexpr (Relaxed && Transfer::affine) {
            const Shift<double> shift = shift_of(k.shift, speed * courant, support, least, share, share_x, share_y,
                                                 cell_depth, depth_x, depth_y, dx);
            px += shift.x;
            py += shift.y;
            area[p] *= shift.growth;
        }
        if (k.wall) {
            px = std::clamp(px, edges.west + margin, edges.east - margin);
            py = std::clamp(py, edges.south + margin, edges.north - margin);
        }
        if (nodes.any_solid()) slide_along_walls(nodes, x[p], y[p], px, py);
        const double wave = speed + std::sqrt(k.gravity * depth);
        if (!(wave < 1e9) || !(std::abs(px) < 1e12) || !(std::abs(py) < 1e12)) {
            ++report.non_finite;
            continue;  // the particle stays where it was; the run stops after this step
        }
        x[p] = px;
        y[p] = py;
        if (!edges.holds(px, py)) {
            ++report.outside;
            continue;
        }
        if (nodes.any_solid() && nodes.is_gap(grid.node_of(px, py))) ++report.no_data;
        report.wave_speed = std::max(report.wave_speed, wave);
        report.speed = std::max(report.speed, speed);
        const double ox = px - k.origin.x, oy = py - k.origin.y;
        report.front_squared = std::max(report.front_squared, ox * ox + oy * oy);
        report.kinetic += 0.5 * volume[p] * (u[p] * u[p] + v[p] * v[p]);
        report.volume += volume[p];
    }
    return report;
}

}  // namespace frana
