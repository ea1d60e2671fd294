// SPDX-License-Identifier: Apache-2.0
// Formulas for the values that a particle gathers from its nodes. One formula for one particle (double) and for four
// (Quad), always inlined (core/lanes.h).
#pragma once

#include <algorithm>
#include <cmath>

#include "core/lanes.h"

namespace frana {

/// Gain per Courant number of the relaxation of areas (share/doc/numerics.md, "Area relaxation"); 0.2 bounds it.
/// Crowded particles (k_crowded_fraction) shrink faster: otherwise friction and maps would use a depth smaller than
/// that on the ground. Not from a fraction of 1 on, where half of all evenly spread irregular particles are:
/// ritter-irregular would be worse by 1/3.
inline constexpr double k_relaxation_gain = 0.03, k_crowded_gain = 0.2, k_relaxation_limit = 0.2;

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
inline constexpr double k_tower = 2;

/// Fraction of a cell from which it counts as full when material converges. Rounding must not decide for a lattice that
/// fills its cells exactly.
inline constexpr double k_full_fraction = 1 - 1e-9;

/// Greatest relative correction of a particle's speed by gravity's work in a step.
inline constexpr double k_work_limit = 0.5;

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
[[gnu::always_inline]] inline Number shock_compression(Number divergence, const Bend<Number>& b) {
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
[[gnu::always_inline]] inline Gradient<Number> bounded_at_front(const Gradient<Number>& c, Number support, double dx,
                                                                Number bound2) {
    using std::sqrt;
    const Number free = (1 - support) * dx;
    const Number free2 = free * free * (c.xx * c.xx + c.xy * c.xy + c.yx * c.yx + c.yy * c.yy);
    Number fit(1.0);
    if (Lanes<Number>::any(free2 > bound2)) fit = select(free2 > bound2, sqrt(bound2 / free2), Number(1.0));
    return {fit * c.xx, fit * c.xy, fit * c.yx, fit * c.yy};
}

/// Relative change of a particle's velocity by gravity's work (nodes_to_particles.h).
/// @param most twice the energy to which the work is related [m2/s2]
template <class Number>
[[gnu::always_inline]] inline Number change_by_work(Number work, Number most) {
    using std::max;
    using std::min;
    const Number least(-k_work_limit), greatest(k_work_limit);
    return min(max(select(most > 0, work / most, Number(0.0)), least), greatest);
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
    const auto tower = volume * fraction * cell_area > k_tower * area * cell_depth;
    return select((growth < 1) & ((fraction < k_full_fraction) | tower), Number(1.0), growth);
}

/// Area relaxation, which ties a particle's depth to the mass on the grid: its area grows or shrinks with the fraction
/// of each cell that particles claim, and only shrinks at a free front. A particle too thin to be split claims at most
/// a few cells: beyond that its support would be meaningless.
/// @param grown area after deformation by the flow  @param area before the step  @param courant |v| dt/dx
template <class Number>
[[gnu::always_inline]] inline Number relaxed_area(Number grown, Number area, Number fraction, Number support,
                                                  Number speed, double courant, double cell_area) {
    using std::max;
    using std::min;
    const Number gain = select(fraction > k_crowded_fraction, Number(k_crowded_gain), Number(k_relaxation_gain));
    const Number limit(k_relaxation_limit), largest(k_largest_claim * cell_area);
    const Number beta = min(limit, gain * speed * courant);
    const Number relaxed = grown * (1 + beta * (1 / fraction - 1));
    return min(select((fraction > 1) | (support > 0.999), relaxed, grown), max(area, largest));
}

}  // namespace frana
