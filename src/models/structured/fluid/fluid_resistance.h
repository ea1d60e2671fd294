// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "models/structured/fluid/fluid_state.h"
#include "physics/friction_manning.h"

namespace frana::structured {

/// Lower bound of the fraction of free fluid, a divisor of the enhanced stress (share/doc/structured.md, "Free fluid").
inline constexpr double k_least_free_fraction = 0.05;

/// Whether a scene's fluid has bed resistance.
bool has_resistance(const FluidLaws& laws);
/// Whether a scene's fluid has in-plane viscous or enhanced stress.
bool has_viscosity(const FluidLaws& laws);

/// Kinematic viscosity by solid fraction [m2/s]: nu = a_eta exp(b_eta alpha_s) / rho_u (paper, equation 72;
/// share/doc/structured.md, "Free fluid").
double kinematic_viscosity(const FluidLaws& laws, double solid_fraction) noexcept;

/// Fraction of the pores of a cell's solids that free fluid h_u [m] fills.
inline double filled_pores(const SolidsOnGrid& solid, std::size_t cell, double free) noexcept {
    return free < solid.pores[cell] ? free / solid.pores[cell] : 1;
}

/// Manning's resistance of solids and fluid as one column, which both feel alike [1/m] (ours):
///
///     k rho_u g n^2 / d^(1/3) / (m_c + rho_u h_u),   k = (1 - f_sc) min(1, h_u / h_pores),   d = (h_u + h_c) cos
///
/// the bed's stress over the mass of both. k is the part of the column that moves over the bed as a fluid: not blocks,
/// and loose solids as far as free fluid fills their pores.
/// @param free h_u [m]
/// @param flatness cosine of the bed's slope
inline double column_resistance(const FluidLaws& laws, const SolidsOnGrid& solid, std::size_t cell, double free,
                                double flatness) noexcept {
    const double total = free + solid.depth[cell];
    return manning_resistance(laws.gravity, laws.manning, total * flatness) * laws.density * total *
           (1 - solid.structured[cell]) * filled_pores(solid, cell, free) / (solid.mass[cell] + laws.density * free);
}

/// Bed resistance in one tile over dt, fully implicit, so that it slows, never reverses, and steady flow is exact:
///
///     u (1 + dt (R_n + R_v + R_s)) = u* + dt R_s u_c
///     R_n = g n^2 V / d^(4/3)                       Manning (paper, equation 46): V the speed along the bed,
///                                                   d = h_u cos the thickness normal to it, or by the column;
///                                                   V = |u|, d = h_u on gentle ground
///     R_v = chi nu / h^2                            viscous shear at the bed (equation 56)
///     R_s = nu_A zeta alpha_s (1 - f_sc) / h^2      damping by the solids' profile (equation 45; the sign is
///                                                   ours)
///
/// After the change of momentum by FluidState::force. Writes the momentum of fluid, and FluidState::resistance.
void resist(const NodeRange& range, const FluidLaws& laws, const SolidsOnGrid& solid, double dt, FluidState& state);

/// Force of the in-plane viscous stress in one tile, as the divergence of depth times stress through the faces
/// (ours: the paper's (56) has depth and viscosity outside the derivative), so that momentum is conserved:
///
///     tau_ab = nu_N (du_a/dx_b + du_b/dx_a) - nu_A (dalpha_c/dx_a w_b + dalpha_c/dx_b w_a),   w = u_u - u_c
///
/// nu_N = eta/rho_u, nu_A = A eta/(rho_u alpha_u); paper, equation 30. The depth of a face is the lesser of its two
/// cells'; no stress acts across a wall, an edge or a dry cell. Reads the tile and one cell around; writes
/// FluidState::force.
void shear(const NodeRange& range, const FluidLaws& laws, const SolidsOnGrid& solid, FluidState& state);

}  // namespace frana::structured
