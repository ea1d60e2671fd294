// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "core/lanes.h"
#include "mpm/curvature.h"
#include "mpm/ground_walls.h"
#include "mpm/node_grid.h"
#include "mpm/shifting.h"
#include "mpm/stable_step.h"
#include "particles/particle_set.h"
#include "physics/strain_rate.h"

namespace frana {

// Formulas for the values that a particle gathers from its nodes. One formula for one particle (double) and for four
// (Quad), always inlined (core/lanes.h).

/// Gain per Courant number of the relaxation of areas (share/doc/numerics.md, "Area relaxation"); 0.2 bounds it.
/// Crowded particles (k_crowded_fraction) shrink faster: otherwise friction and maps would use a depth smaller than
/// that on the ground. Not from a fraction of 1 on, where half of all evenly spread irregular particles are:
/// ritter-irregular would be worse by 1/3.
inline constexpr double k_relaxation_gain = 0.03, k_crowded_gain = 0.2, k_relaxation_limit = 0.2;

/// Gain of the same per compression by a shock in a step; weaker below a compression of 1 / k_shock_threshold, since a
/// gain proportional to the motion alone would set still water with irregular particles in motion.
inline constexpr double k_shock_gain = 3, k_shock_threshold = 30;

/// Fraction of a cell from which particles are piled up, each shallower than the pile by more than
/// k_crowded_fraction: these shrink at the pace of waves even where nothing moves. Otherwise what crowds and stops
/// would press for ever with its own depth instead of that on the ground. From the fraction on where they are not
/// shifted.
inline constexpr double k_piled_fraction = k_shift_none;

/// Least factor by which an area may change in a step; the stable step keeps well clear of it.
inline constexpr double k_least_growth = 0.1;

/// Determinant below which the area's change in a step is no longer taken from the linear map (compressed_growth).
inline constexpr double k_linear_growth = 0.5;

/// Bound of a particle's area, and of its shape's trace, in cells: particles that cannot be split (thin flow) grow no
/// further.
inline constexpr double k_largest_claim = 4;

/// Greatest difference of a particle's affine velocity over a cell at a free front, in celerities sqrt(g h), at support
/// 0; at support s it is this over (1 - s). In a simple wave u + 2 sqrt(g h) is constant, so velocity cannot vary by
/// more than twice the celerity over the cell in which the depth goes to zero; without the bound the foremost particles
/// outrun 2 sqrt(g h) at every split.
inline constexpr double k_front_shear = 0.7;

/// A particle this many times deeper than its cells' mean depth is not compressed further.
inline constexpr double k_max_depth_ratio = 2;

/// Fraction of a cell from which it counts as full when material converges. Rounding must not decide for a lattice that
/// fills its cells exactly.
inline constexpr double k_full_fraction = 1 - 1e-9;

/// Deviation of the velocities on a stencil from linear.
template <class Number>
struct Bend {
    Number bend;    ///< |v0 - 2 v1 + v2| along both axes [m/s]
    Number change;  ///< |v1 - v0| + |v2 - v1| along both axes [m/s]
};

/// @param u, v means of the stencil's columns and of its rows
template <class Number>
[[gnu::always_inline]] inline Bend<Number> bend_of(Number u0, Number u1, Number u2, Number v0, Number v1, Number v2) {
    using std::abs;
    return {abs(u0 - 2 * u1 + u2) + abs(v0 - 2 * v1 + v2),
            (abs(u1 - u0) + abs(u2 - u1)) + (abs(v1 - v0) + abs(v2 - v1))};
}

/// Rate of compression in the artificial viscosity [1/s]: -div v, weighted by bend over change. 1 behind a shock with
/// oscillations, 0 where a flow converges smoothly: there a viscosity would only dissipate energy.
template <class Number>
[[gnu::always_inline]] inline Number shock_compression(Number divergence, const Bend<Number> &b) {
    return select((divergence < 0) & (b.change > 0), -divergence * b.bend / b.change, Number(0.0));
}

/// A velocity gradient, L_ab = dv_a / dx_b [1/s].
template <class Number>
struct Gradient {
    Number xx, xy, yx, yy;
};

/// Bounds the affine velocity at a free front (k_front_shear) by the celerity. Compares squares first, since few
/// particles are at a front.
template <class Number>
[[gnu::always_inline]] inline Gradient<Number> bounded_at_front(const Gradient<Number> &c, Number support, double dx,
                                                                Number bound2) {
    using std::sqrt;
    const Number free = (1 - support) * dx;
    const Number free2 = free * free * (c.xx * c.xx + c.xy * c.xy + c.yx * c.yx + c.yy * c.yy);
    Number fit(1.0);
    if (Lanes<Number>::any(free2 > bound2)) fit = select(free2 > bound2, sqrt(bound2 / free2), Number(1.0));
    return {fit * c.xx, fit * c.xy, fit * c.yx, fit * c.yy};
}

/// Returns the factor of a particle's area in a step from the determinant of the map x -> x + dt v(x). Where material
/// runs into a wall within a step, this map compresses it to nothing or turns it inside out, while a constant rate of
/// compression over the step would leave exp(dt div v). Below k_linear_growth a hyperbola with the same value and slope
/// there takes over, which is never 0.
template <class Number>
[[gnu::always_inline]] inline Number compressed_growth(Number determinant) {
    if (!Lanes<Number>::any(determinant < k_linear_growth)) return determinant;
    return select(determinant < k_linear_growth,
                  k_linear_growth * k_linear_growth / (2 * k_linear_growth - determinant), determinant);
}

/// Where the cells are not full, converging material first fills the gaps: only a full cell becomes deeper, and no
/// particle becomes much deeper than the cells around it, however long it is compressed in a corner.
template <class Number>
[[gnu::always_inline]] inline Number filling_growth(Number growth, Number volume, Number area, Number fraction,
                                                    Number cell_depth, double cell_area) {
    const auto too_deep = volume * fraction * cell_area > k_max_depth_ratio * area * cell_depth;
    return select((growth < 1) & ((fraction < k_full_fraction) | too_deep), Number(1.0), growth);
}

/// Area relaxation, which ties a particle's depth to the mass on the grid: its area grows or shrinks with the fraction
/// of each cell that particles claim, and only shrinks at a free front. A shock leaves particles that overlap: where
/// its state is held on the grid, the relaxation is as fast as the compression (k_shock_gain). A particle too thin to
/// be split claims at most a few cells: beyond that its support would be meaningless.
/// @param grown area after deformation by the flow  @param area before the step
/// @param fraction that is claimed; of a particle that is piled up, the depth on the ground over its own
/// @param pace |v|, and of a particle that is piled up, besides, the celerity of the pile [m/s]  @param courant dt/dx
/// @param squeezed shock_compression times dt, and the share of the state held on the grid
template <class Number>
[[gnu::always_inline]] inline Number relaxed_area(Number grown, Number area, Number fraction, Number support,
                                                  Number pace, double courant, double cell_area, Number squeezed) {
    using std::max;
    using std::min;
    const Number gain = select(fraction > k_crowded_fraction, Number(k_crowded_gain), Number(k_relaxation_gain));
    const Number limit(k_relaxation_limit), largest(k_largest_claim * cell_area);
    const Number shocked = min(Number(1.0), k_shock_threshold * squeezed) * k_shock_gain * squeezed;
    const Number beta = min(limit, gain * pace * courant + shocked);
    const Number relaxed = grown * (1 + beta * (1 / fraction - 1));
    return min(select((fraction > 1) | (support > 0.999), relaxed, grown), max(area, largest));
}

/// The squared extents Q of a particle, a symmetric tensor [m2].
template <class Number>
struct ParticleShape {
    Number xx, xy, yy;
};

/// Returns F Q F^T, the shape after a motion x -> F x. One formula for one particle (double) and for four (Quad).
/// Always inlined: the fast kernels, compiled for another instruction set, must share no function with the rest.
template <class Number>
[[gnu::always_inline]] inline ParticleShape<Number> deformed(const ParticleShape<Number> &q, Number fxx, Number fxy,
                                                             Number fyx, Number fyy) {
    const Number axx = fxx * q.xx + fxy * q.xy, axy = fxx * q.xy + fxy * q.yy;
    const Number ayx = fyx * q.xx + fyy * q.xy, ayy = fyx * q.xy + fyy * q.yy;
    return {axx * fxx + axy * fxy, axx * fyx + axy * fyy, ayx * fyx + ayy * fyy};
}

struct ParticleUpdate {
    double dt = 0;  ///< time of the positions' motion [s]
    double gravity = 0;
    double split_depth = 0;     ///< depth below which a particle is not split [m]
    bool wall = false;          ///< particles are kept inside; otherwise they may leave
    Point origin;               ///< release centroid, for the front distance, local metres
    double shift = 0;           ///< particle shifting: s of shifting.h, 0 in steps without it
    double kept = 0;            ///< share of its own velocity that a particle keeps: NodeUpdate::kept
    double critical = 0;        ///< sqrt(g): critical speed over the root of the depth [m^(1/2)/s]
    bool ground_walls = false;  ///< walls of the ground are within reach of the tile
};

/// Results of a tile's particles in a step; combined tile by tile in their order.
struct ParticleReport {
    FlowSpeeds speeds;
    double diffusivity = 0;    ///< greatest of the in-plane stress [m2/s]
    double front_squared = 0;  ///< farthest from the origin [m2]
    double kinetic = 0;        ///< sum of V v^2 / 2 [m5/s2]
    double volume = 0;         ///< inside [m3]
    double longest = 0;        ///< greatest trace of a shape that could be split [m2]
    std::int64_t outside = 0, non_finite = 0, no_data = 0, clamped = 0, piled = 0;
    WallContact walls{};  ///< of the ground

    void merge(const ParticleReport &r) noexcept {
        speeds.merge(r.speeds);
        diffusivity = std::max(diffusivity, r.diffusivity);
        front_squared = std::max(front_squared, r.front_squared);
        kinetic += r.kinetic;
        volume += r.volume;
        longest = std::max(longest, r.longest);
        outside += r.outside;
        non_finite += r.non_finite;
        no_data += r.no_data;
        clamped += r.clamped;
        piled += r.piled;
        walls.merge(r.walls);
    }
};

/// The values that one particle (double) or four (Quad) gather from their nodes.
template <class Number>
struct Gathered {
    Number cell_depth, fraction, support;  // as in NodeMotion
    Number depth_x, depth_y, fraction_x, fraction_y,
        least;                      // for shifting: gradients of the first two; least fraction of any node
    Number u, v, back_u, back_v;    // nodal velocity in map view; what the particles take over
    Number u_x, u_y, v_x, v_y;      // gradient of the former
    Number m_xx, m_xy, m_yx, m_yy;  // first moments of the latter (hat functions: its gradient)
    Bend<Number> bend;              // of the nodal velocity
};

/// Keeps a particle out of a wall's cell: it moves along the wall as far as either axis allows. It so stays a whole
/// cell away from the nodes behind a wall one cell thick.
[[gnu::always_inline]] inline void slide_along_walls(const NodeGrid &nodes, double x, double y, double &px,
                                                     double &py) noexcept {
    const NodeScale grid = nodes.scale();
    const auto wall = [&](double a, double b) {
        return nodes.bounds().contains(a, b) && nodes.is_wall(grid.node_of(a, b));
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

/// Returns whether a particle of [begin, end) may meet a solid node if it moves by a cell at most in each direction.
/// Most tiles are far from any, however many the map has.
[[gnu::always_inline]] inline bool solid_near(const NodeGrid &nodes, const ParticleSet &particles, std::size_t begin,
                                              std::size_t end) noexcept {
    if (!nodes.any_solid() || begin == end) return false;
    const double *const x = particles[Field::x], *const y = particles[Field::y];
    double west = x[begin], east = x[begin], south = y[begin], north = y[begin];
    for (std::size_t p = begin; p < end; ++p) {
        west = x[p] < west ? x[p] : west;
        east = x[p] > east ? x[p] : east;
        south = y[p] < south ? y[p] : south;
        north = y[p] > north ? y[p] : north;
    }
    const NodeScale grid = nodes.scale();
    const auto node = [&](double at, std::int64_t origin, std::int64_t count) __attribute__((always_inline)) {
        const std::int64_t n = static_cast<std::int64_t>(__builtin_floor(at * grid.inverse_dx)) + origin;
        return n < 0 ? 0 : n >= count ? count - 1 : n;
    };
    const std::int64_t stride = nodes.stride(), rows = nodes.padded_rows();
    const std::int64_t i0 = node(west - grid.dx, grid.origin_x, stride),
                       i1 = node(east + grid.dx, grid.origin_x, stride);
    const std::int64_t j0 = node(south - grid.dx, grid.origin_y, rows), j1 = node(north + grid.dx, grid.origin_y, rows);
    const std::uint8_t *const solid = nodes.solid();
    std::uint8_t any = 0;
    for (std::int64_t j = j0; j <= j1; ++j)
        for (std::int64_t i = i0; i <= i1; ++i) any |= solid[j * stride + i];
    return any != 0;
}

/// The part of nodes_to_particles (mpm/nodes_to_particles.h) after the gather, for one particle or for four. Affine: of
/// the transfer. Shifts: whether ParticleUpdate::shift may be other than 0.
template <class Number, bool Affine, class Stress, bool Relaxed, bool Shifts>
struct ParticleSweep {
    using L = Lanes<Number>;
    using Mask = typename L::Mask;

    const ParticleUpdate &k;
    const Stress &stress;
    const NodeGrid &nodes;
    ParticleSet &particles;
    const double d;  ///< inverse of the shape functions' second moment [1/m2]; hat functions: 1

    const bool solid_near;  ///< solid_near() of the particles

    const NodeScale grid = nodes.scale();
    const Bounds edges = nodes.bounds();
    const double *const volume = particles[Field::volume];
    double *const area = particles[Field::area];
    double *const x = particles[Field::x], *const y = particles[Field::y];
    double *const u = particles[Field::u], *const v = particles[Field::v];
    double *const c_xx = particles[Field::c_xx], *const c_xy = particles[Field::c_xy];
    double *const c_yx = particles[Field::c_yx], *const c_yy = particles[Field::c_yy];
    double *const s_xx = particles[Field::s_xx], *const s_xy = particles[Field::s_xy];
    double *const s_yy = particles[Field::s_yy], *const compression = particles[Field::compression];
    double *const q_xx = particles[Field::q_xx], *const q_xy = particles[Field::q_xy];
    double *const q_yy = particles[Field::q_yy];

    Number wave_speed = 0.0, carried_speed = 0.0, greatest_speed = 0.0, diffusivity = 0.0, front_squared = 0.0,
           longest = 0.0;
    Number kinetic = 0.0, inside_volume = 0.0;
    typename L::Count clamped{}, non_finite{}, outside{}, piled_up{};
    std::int64_t no_data = 0;
    WallContact walls{};

    struct Velocity {
        Number u, v;
    };

    /// Takes the velocity of the nodes and its gradient.
    template <class Count>
    [[gnu::always_inline]] Velocity take_velocity(std::size_t p, Count n, Number mass, Number old_area, Number support,
                                                  const Gathered<Number> &g) {
        using std::sqrt;
        Number back_u = g.back_u, back_v = g.back_v;
        Gradient<Number> c{d * g.m_xx, d * g.m_xy, d * g.m_yx, d * g.m_yy};
        if (k.kept != 0) {
            const auto add = [&](const double *from, Number &to) __attribute__((always_inline)) {
                to += k.kept * L::load(from + p, n);
            };
            add(u, back_u);
            add(v, back_v);
            if constexpr (Affine) {
                add(c_xx, c.xx);
                add(c_xy, c.xy);
                add(c_yx, c.yx);
                add(c_yy, c.yy);
            }
        }
        if constexpr (Affine) {
            if constexpr (Relaxed) {
                // In terms of velocities in map view.
                const Number speed2 = g.u * g.u + g.v * g.v, back2 = back_u * back_u + back_v * back_v;
                const Number bound2 = (k_front_shear * k_front_shear * k.gravity) * mass / old_area *
                                      select(speed2 > 0, back2 / speed2, Number(1.0));
                c = bounded_at_front(c, support, grid.dx, bound2);
            }
            L::store(c.xx, c_xx + p, n);
            L::store(c.xy, c_xy + p, n);
            L::store(c.yx, c_yx + p, n);
            L::store(c.yy, c_yy + p, n);
        }
        L::store(back_u, u + p, n);
        L::store(back_v, v + p, n);
        return {back_u, back_v};
    }

    /// Deforms the particle with the flow; returns its area.
    template <class Count>
    [[gnu::always_inline]] Number deform(std::size_t p, Count n, Number mass, Number old_area, Number speed,
                                         const Gathered<Number> &g) {
        using std::max;
        using std::min;
        using std::sqrt;
        const Mask real = L::first(n);
        const double cell_area = grid.dx * grid.dx, courant = k.dt * grid.inverse_dx;
        const Number support = min(Number(1.0), g.support), held = max(Number(0.0), g.support - 1);
        // Equation (38) in two dimensions: the area follows the map x -> x + dt v(x), whose determinant this is.
        const Number div = g.u_x + g.v_y;
        Number squeezed = 0.0;
        if constexpr (Relaxed) {
            const Number rate = shock_compression(div, g.bend);
            L::store(rate, compression + p, n);
            squeezed = held * k.dt * rate;
        }
        const Number determinant = 1 + k.dt * div + k.dt * k.dt * (g.u_x * g.v_y - g.u_y * g.v_x);
        Number growth = determinant;
        if constexpr (Relaxed)
            growth = filling_growth(compressed_growth(growth), mass, old_area, g.fraction, g.cell_depth, cell_area);
        const Mask sound = growth > k_least_growth;
        L::add(clamped, L::none(sound) & real);
        growth = select(sound, growth, Number(k_least_growth));
        Number new_area = old_area * growth;
        if constexpr (Relaxed && Affine) {  // F = I + dt grad v
            const ParticleShape<Number> old{L::load(q_xx + p, n), L::load(q_xy + p, n), L::load(q_yy + p, n)};
            const auto [xx, xy, yy] =
                deformed<Number>(old, 1 + k.dt * g.u_x, k.dt * g.u_y, k.dt * g.v_x, 1 + k.dt * g.v_y);
            const Number trace = xx + yy;
            longest = select(real & (mass > k.split_depth * old_area), max(longest, trace), longest);
            const double largest = k_largest_claim * cell_area;
            Number fit(1.0);
            if (L::any(trace > largest)) fit = min(fit, largest / trace);
            L::store(fit * xx, q_xx + p, n);
            L::store(fit * xy, q_xy + p, n);
            L::store(fit * yy, q_yy + p, n);
        }
        if constexpr (Relaxed) {
            Number pace = speed, fraction = g.fraction;
            const Mask piled =
                (fraction > k_piled_fraction) & (g.cell_depth * old_area > (k_crowded_fraction * cell_area) * mass);
            if (L::any(piled)) {
                pace = select(piled, speed + sqrt(k.gravity * g.cell_depth / cell_area), pace);
                fraction = select(piled, g.cell_depth * old_area / (mass * cell_area), fraction);
                L::add(piled_up, real & piled);
            }
            new_area = relaxed_area<Number>(new_area, old_area, fraction, support, pace, courant, cell_area, squeezed);
        }
        return new_area;
    }

    /// Keeps a place on the ground and off walls; returns whether there are walls or gaps near.
    template <class Count>
    [[gnu::always_inline]] bool keep_off_walls(Count n, Number old_x, Number old_y, Number &px, Number &py) const {
        using std::abs;
        using std::max;
        using std::min;
        if (k.wall) {
            const double margin = 1e-9 * grid.dx;
            px = min(max(px, Number(edges.west + margin)), Number(edges.east - margin));
            py = min(max(py, Number(edges.south + margin)), Number(edges.north - margin));
        }
        const bool meets_solid =
            solid_near || (nodes.any_solid() && L::any((abs(px - old_x) > grid.dx) | (abs(py - old_y) > grid.dx)));
        if (meets_solid) {
            for (std::size_t i = 0; i < n; ++i) {
                const auto l = static_cast<int>(i);
                double along_x = L::at(px, l), along_y = L::at(py, l);
                slide_along_walls(nodes, L::at(old_x, l), L::at(old_y, l), along_x, along_y);
                L::set(px, l, along_x);
                L::set(py, l, along_y);
            }
        }
        return meets_solid;
    }

    /// What walls of the ground leave of the motion, of the velocity and of its gradient. The flow is as deep as its
    /// cell: particles may overlap.
    template <class Count>
    [[gnu::always_inline]] void meet_ground_walls(std::size_t p, Count n, Number old_x, Number old_y, Number &px,
                                                  Number &py) {
        for (std::size_t i = 0; i < n; ++i) {
            const auto l = static_cast<int>(i);
            const Point from{L::at(old_x, l), L::at(old_y, l)};
            Point to{L::at(px, l), L::at(py, l)};
            const double depth = nodes.mass(grid.node_of(from.x, from.y)) * grid.inverse_dx * grid.inverse_dx;
            const Kept kept = keep_at_walls(nodes, depth, k.dt * k.critical, from, to);
            L::set(px, l, to.x);
            L::set(py, l, to.y);
            for (double *const of_x : {u, c_xx, c_xy})
                if (kept.x < 1) of_x[p + i] *= kept.x;
            for (double *const of_y : {v, c_yx, c_yy})
                if (kept.y < 1) of_y[p + i] *= kept.y;
            walls.merge({volume[p + i] * kept.part.met, volume[p + i] * kept.part.passed});
        }
    }

    /// Particles p to p + n - 1.
    template <class Count>
    [[gnu::always_inline]] void operator()(std::size_t p, Count n, Number old_x, Number old_y,
                                           const Gathered<Number> &g) {
        using std::abs;
        using std::max;
        using std::min;
        using std::sqrt;
        const Mask real = L::first(n);
        const Number mass = L::load(volume + p, n), old_area = L::load(area + p, n);
        const Number support = min(Number(1.0), g.support);
        const auto [back_u, back_v] = take_velocity(p, n, mass, old_area, support, g);
        const Number speed2 = g.u * g.u + g.v * g.v, speed = sqrt(speed2);
        Number new_area = deform(p, n, mass, old_area, speed, g);
        const Number depth = mass / new_area;
        if constexpr (Stress::active) {
            const auto t = stress(StrainRate<Number>{g.u_x, 0.5 * (g.u_y + g.v_x), g.v_y, g.u, g.v, depth});
            L::store(t.xx, s_xx + p, n);
            L::store(t.xy, s_xy + p, n);
            L::store(t.yy, s_yy + p, n);
            diffusivity = max(diffusivity, t.diffusivity);
        }
        Number px = old_x + k.dt * g.u, py = old_y + k.dt * g.v;
        if constexpr (Shifts) {
            const Shift<Number> shift =
                shift_of<Number>(k.shift, speed * (k.dt * grid.inverse_dx), support, g.least, g.fraction, g.fraction_x,
                                 g.fraction_y, g.cell_depth, g.depth_x, g.depth_y, grid.dx);
            px += shift.x;
            py += shift.y;
            new_area = new_area * shift.growth;
        }
        L::store(new_area, area + p, n);
        if constexpr (Affine) {
            if (k.ground_walls) meet_ground_walls(p, n, old_x, old_y, px, py);
        }
        const bool meets_solid = keep_off_walls(n, old_x, old_y, px, py);
        // Non-finite particles keep their position; the run stops after this step.
        const Number celerity = sqrt(k.gravity * depth), wave = speed + celerity;
        const Mask finite = (wave < 1e9) & (abs(px) < 1e12) & (abs(py) < 1e12);
        L::store(select(finite, px, old_x), x + p, n);
        L::store(select(finite, py, old_y), y + p, n);
        const Mask inside =
            finite & real & (px >= edges.west) & (px < edges.east) & (py >= edges.south) & (py < edges.north);
        L::add(non_finite, L::none(finite) & real);
        L::add(outside, finite & L::none(inside) & real);
        if (meets_solid) {
            for (std::size_t i = 0; i < n; ++i) {
                const auto l = static_cast<int>(i);
                if (L::at(inside, l) && nodes.is_gap(grid.node_of(L::at(px, l), L::at(py, l)))) ++no_data;
            }
        }
        const Number ox = px - k.origin.x, oy = py - k.origin.y;
        wave_speed = select(inside, max(wave_speed, wave), wave_speed);
        carried_speed = select(inside, max(carried_speed, k_carried * speed + celerity), carried_speed);
        greatest_speed = select(inside, max(greatest_speed, speed), greatest_speed);
        front_squared = select(inside, max(front_squared, ox * ox + oy * oy), front_squared);
        kinetic += select(inside, 0.5 * mass * (back_u * back_u + back_v * back_v), Number(0.0));
        inside_volume += select(inside, mass, Number(0.0));
    }

    [[nodiscard, gnu::always_inline]] ParticleReport report() const {
        ParticleReport r;
        r.speeds = {L::greatest(wave_speed), L::greatest(carried_speed), L::greatest(greatest_speed)};
        r.diffusivity = L::greatest(diffusivity);
        r.front_squared = L::greatest(front_squared);
        r.kinetic = L::sum(kinetic);
        r.volume = L::sum(inside_volume);
        r.longest = L::greatest(longest);
        r.outside = L::total(outside);
        r.non_finite = L::total(non_finite);
        r.no_data = no_data;
        r.clamped = L::total(clamped);
        r.piled = L::total(piled_up);
        r.walls = walls;
        return r;
    }
};

}  // namespace frana
