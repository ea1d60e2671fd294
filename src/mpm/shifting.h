// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "mpm/node_grid.h"

namespace frana {

/// Particle shifting: a particle in a filled part of the flow drifts from crowded to sparse particles,
///
///     x <- x - s dx^2 grad phi,   phi the fraction of the cell that particles claim,
///
/// so that a flow's particles become as even as a lattice. Its depth follows the nodes' own depth M / phi: A <- A (1 -
/// dx . grad h / h). Its volume and velocity are unchanged, so that volume, momentum and kinetic energy are conserved
/// to the last bit; potential energy is not. (After Lind et al. 2012, J. Comput. Phys. 231, 1499.)
///
/// Bounds: none without motion, so that still water stays at rest; none where a cell of its stencil is far from full,
/// since grad phi is there that of the flow's edge; none where particles overlap strongly, since it would press them
/// out of their pile.
inline constexpr double k_shift = 0.2;  ///< s, in one step of k_shift_steps
inline constexpr int k_shift_steps = 4;
inline constexpr double k_shift_courant = 30;     ///< s is reduced where |v| dt/dx times this is less than 1
inline constexpr double k_shift_farthest = 0.1;   ///< along either axis, reduced likewise [cells]
inline constexpr double k_shift_deepening = 0.2;  ///< greatest relative change of depth by one shift
inline constexpr double k_shift_from = 0.7,
                        k_shift_full = 0.9;  ///< least fraction of a stencil's nodes: no shift, full shift
inline constexpr double k_shift_until = k_crowded_fraction, k_shift_none = 1.2;  ///< fraction: full shift, no shift

/// Returns how far particles may shift along an axis in a step [cells].
inline double shift_reach(double courant) {
    return k_shift_farthest * std::min(1.0, k_shift_courant * courant);
}

/// Displacement of a particle, and the factor by which its area changes.
template <class Number>
struct Shift {
    Number x, y, growth;
};

/// One formula for one particle (double) and for four (Quad). Always inlined: the fast kernels, compiled for another
/// instruction set, must share no function with the rest.
/// @param s see above  @param courant |v| dt/dx  @param support NodeLevel::support
/// @param least fraction of any node of the stencil
/// @param fraction, fraction_x, fraction_y phi and its gradient  @param mass, mass_x, mass_y the same of the nodes'
/// volume
template <class Number>
[[gnu::always_inline]] inline Shift<Number> shift_of(double s, Number courant, Number support, Number least,
                                                     Number fraction, Number fraction_x, Number fraction_y, Number mass,
                                                     Number mass_x, Number mass_y, double dx) {
    using std::max;
    using std::min;
    const Number none(0.0), all(1.0), deepening(k_shift_deepening), pace = min(all, k_shift_courant * courant);
    const Number farthest = (k_shift_farthest * dx) * pace;
    const Number filled = max(none, min(all, (least - k_shift_from) * (1 / (k_shift_full - k_shift_from))));
    const Number apart = max(none, min(all, (k_shift_none - fraction) * (1 / (k_shift_none - k_shift_until))));
    const Number inner = max(none, 100 * support - 99);  // 1 away from free fronts
    const Number gain = (-s * dx * dx) * (filled * apart * inner * pace);
    const Number x = max(-farthest, min(farthest, gain * fraction_x)),
                 y = max(-farthest, min(farthest, gain * fraction_y));
    const Number deeper = (x * mass_x + y * mass_y) / mass - (x * fraction_x + y * fraction_y) / fraction;
    return {x, y, 1 - max(-deepening, min(deepening, deeper))};
}

}  // namespace frana
