// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "mpm/curvature.h"
#include "mpm/node_grid.h"
#include "mpm/shape.h"
#include "particles/particle_set.h"
#include "particles/tile_order.h"

namespace frana {

/// Linear artificial viscosity under compression, as a fraction of rho h sqrt(g h) dx (share/doc/numerics.md,
/// "Compression").
inline constexpr double k_shock_viscosity = 0.5;

/// Contribution of one particle (double) or of four lanes (Quad) to its nodes. The formulas are always inlined: the
/// fast kernels, compiled for another instruction set, must share no function with the rest.
template <class Number>
struct ParticlePush {
    Number pressure;          ///< over its area, over density [m4/s2]
    Number half_weight;       ///< g A / 2 [m3/s2]
    Number depth;             ///< h [m]
    Number slope_x, slope_y;  ///< g A grad Z [m3/s2]
    Number xx, xy, yy;        ///< V sigma, if there is stress [m5/s2]
    Number held;              ///< depth of the state held on the grid [m]
};

/// NodeLevel::share of a set of nodes: all 0, any, all 1.
enum class Shares { none, any, all };

/// What is subtracted from a particle's h^2 and h in its force on a node.
template <class Number>
struct Reference {
    Number square, depth;
};

/// Returns 1/2 g A h^2, plus the artificial viscosity under compression.
template <class Number>
[[gnu::always_inline]] inline Number shocked_pressure(Number half_weight, Number depth, Number volume,
                                                      Number compression, double gravity, double dx) {
    using std::sqrt;
    return half_weight * depth * depth + k_shock_viscosity * volume * sqrt(gravity * depth) * compression * dx;
}

/// Returns the reference of a node over a bed at z: its still level or its mean depth, by NodeLevel::ponding, and by
/// NodeLevel::share the state held on the grid instead.
/// @param following (1 - ponding) depth  @param held of the particle
template <Shares Held, class Number>
[[gnu::always_inline]] inline Reference<Number> reference_of(Number ponding, Number level, Number following,
                                                             Number support, Number share, Number z, Number held) {
    using std::max;
    if constexpr (Held == Shares::all) return {held * held, support * following + ponding * held};
    const Number own = ponding * max(Number(0.0), level - z) + following;
    if constexpr (Held == Shares::none) return {support * own * own, support * own};
    const Number rest = (1 - share) * support;
    return {rest * own * own + share * held * held, rest * own + share * (support * following + ponding * held)};
}

/// Returns a particle's force on a node, over density; relative to the node's reference if Referenced.
template <bool Referenced, bool Stress, class Number>
[[gnu::always_inline]] inline MapVector<Number> push_on_node(const ParticlePush<Number>& p,
                                                             const Reference<Number>& reference, Number weight,
                                                             Number grad_x, Number grad_y) {
    Number pressure = p.pressure, pull = p.depth * weight;
    if constexpr (Referenced) {
        pressure = p.pressure - p.half_weight * reference.square;
        pull = (p.depth - reference.depth) * weight;
    }
    if constexpr (!Stress) return {pressure * grad_x - p.slope_x * pull, pressure * grad_y - p.slope_y * pull};
    return {(pressure - p.xx) * grad_x - p.xy * grad_y - p.slope_x * pull,
            (pressure - p.yy) * grad_y - p.xy * grad_x - p.slope_y * pull};
}

/// Adds hydrostatic pressure, bed slope and in-plane stress to the nodes' forces over density. Plain form (paper,
/// equation 28): F_i = sum A [ 1/2 g h^2 grad N_i - g h grad Z N_i ] - sum V sigma grad N_i. Referenced form
/// (share/doc/numerics.md, "Reference level"; NodeLevel): h^2 and h are relative to the node's own still level or mean
/// depth, which integrates to zero in the continuum, or to the state held on the grid, whose force hold_on_grid adds;
/// so that a uniform state exerts exactly no force for any arrangement of particles; update_nodes adds the weight of a
/// reference that follows the bed. Reads x, y, volume, area, s_* if Stress, compression if Referenced; reads NodeLevel;
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
        const double weight = gravity * area[p];
        ParticlePush<double> push{
            0, 0.5 * gravity * area[p], volume[p] / area[p], weight * z.dx, weight * z.dy, 0, 0, 0, 0};
        push.pressure = push.half_weight * push.depth * push.depth;
        if constexpr (Referenced)
            push.pressure = shocked_pressure(push.half_weight, push.depth, volume[p], compression[p], gravity, dx);
        if constexpr (Stress) {
            push.xx = volume[p] * s_xx[p];
            push.xy = volume[p] * s_xy[p];
            push.yy = volume[p] * s_yy[p];
        }
        if constexpr (Referenced) {
            for (int b = 0; b < Shape::width; ++b)
                for (int a = 0; a < Shape::width; ++a)
                    push.held += s.wx[a] * s.wy[b] * levels[s.first + static_cast<std::size_t>(b * stride + a)].held;
        }
        for (int b = 0; b < Shape::width; ++b) {
            const std::size_t first = s.first + static_cast<std::size_t>(b * stride);
            for (int a = 0; a < Shape::width; ++a) {
                const std::size_t i = first + static_cast<std::size_t>(a);
                Reference<double> reference{0, 0};
                if constexpr (Referenced) {
                    const NodeLevel& level = levels[i];
                    reference =
                        reference_of<Shares::any, double>(level.ponding, level.level, (1 - level.ponding) * level.depth,
                                                          level.support, level.share, z.value, push.held);
                }
                const auto [fx, fy] = push_on_node<Referenced, Stress, double>(push, reference, s.wx[a] * s.wy[b],
                                                                               s.gx[a] * s.wy[b], s.wx[a] * s.gy[b]);
                forces[i].fx += fx;
                forces[i].fy += fy;
            }
        }
    }
}

}  // namespace frana
