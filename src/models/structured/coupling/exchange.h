// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>

#include "models/structured/coupling/coupling_laws.h"

namespace frana::structured {

/// Solids and free fluid of one cell, per unit area in map view.
struct CellPhases {
    double solids = 0, confined = 0, free = 0;  ///< h_s, h_fc, h_u [m]
    double coupled_mass = 0;                    ///< m_c [kg/m2]
    double structured = 0;                      ///< f_sc
    double grain_diameter = 1e-3;               ///< d [m]
    double friction = 0;                        ///< greatest shear stress of the bed on the solids [Pa]
    Eigen::Vector2d coupled_velocity{0, 0};     ///< u_c before the step [m/s]
    Eigen::Vector2d free_velocity{0, 0};        ///< u_u after pressure, stress and resistance of the fluid [m/s]
    Eigen::Vector2d push{0, 0};                 ///< acceleration of the solids by all but friction and drag [m/s2]
    Eigen::Vector2d free_push{0, 0};            ///< acceleration of the fluid by all except drag:
                                                ///< pressure, stress, resistance [m/s2]
};

/// Impulse per unit area that the solids gain and the fluid loses over dt by virtual mass and drag [kg/(m s)], if the
/// solids would be at `next` [m/s] without it and answer it with the mass `answering` [kg/m2] (infinite: they do not).
inline Eigen::Vector2d impulse_on(const CouplingLaws& laws, const CellPhases& cell, const Eigen::Vector2d& next,
                                  double answering, double dt) noexcept {
    using Eigen::Vector2d;
    const double fluid_density = laws.drag.fluid.density;
    const double coupled = cell.solids + cell.confined, depth = coupled + cell.free;
    const double m_c = cell.coupled_mass, m_u = fluid_density * cell.free;
    const double grain_density = (m_c - fluid_density * cell.confined) / cell.solids;
    const double alpha_c = coupled / depth, alpha_u = cell.free / depth;

    const double m_v = laws.virtual_mass(alpha_c, alpha_u, m_c, m_u, fluid_density / grain_density);
    Vector2d impulse = Vector2d::Zero();
    if (m_v > 0) {
        const Vector2d apart = cell.free_push - (next - cell.coupled_velocity) / dt;
        impulse = dt * virtual_mass_force(m_v, answering, m_u, apart);
    }
    if (!laws.drags) return impulse;
    const Vector2d u_c = next + impulse / answering, u_u = cell.free_velocity - impulse / m_u;
    Mixture m;
    m.solids = cell.solids / depth;
    m.coupled = alpha_c;
    m.structured = cell.structured;
    m.confined = cell.confined / (cell.confined + cell.free);
    m.coupled_density = m_c / coupled;
    m.grain_density = grain_density;
    m.grain_diameter = cell.grain_diameter;
    m.block_size = laws.block_size > 0 ? laws.block_size : depth;
    const Vector2d flux = alpha_c * u_c + alpha_u * u_u;
    m.flux = std::hypot(flux.x(), flux.y());
    const Vector2d w = u_u - u_c;
    // The virtual mass couples the two phases during the drag: their momenta change by m_r w only, and the bare masses
    // carry the fraction that corresponds to a change of w.
    const double bare = m_u / (1 + m_u / answering), reduced = bare + m_v;
    const double lambda = depth * laws.drag(m) / reduced;
    const double lost = bare * (1 - drag_decay(laws.drag.exponent, lambda, std::hypot(w.x(), w.y()), dt));
    return impulse + lost * w;
}

/// Impulse per unit area that the solids gain and the fluid loses over dt by virtual mass and drag [kg/(m s)].
///
/// The virtual mass acts on the accelerations that both phases would have otherwise, including bed friction on the
/// solids and bed resistance on the fluid. The drag is then solved exactly for the relative velocity w, with the
/// reduced mass m_r = m_c m_u / (m_c + m_u) + m_v:  lambda = h C / m_r  (drag_decay).
///
/// Solids that the bed holds answer an impulse only as far as friction has nothing left against it: with the mass
/// m_c J / (J - S) for an impulse J over the friction's reserve S, and with an infinite one below. So the virtual mass
/// has no effect where neither phase accelerates: solids at rest do not disturb a fluid at rest, and a steady stream
/// over them has the speed at which drag and resistance balance its weight.
inline Eigen::Vector2d exchange(const CouplingLaws& laws, const CellPhases& cell, double dt) noexcept {
    using Eigen::Vector2d;
    constexpr int k_rounds = 3;  // each halves what the answering mass is wrong by, or more
    if (!(cell.coupled_mass > 0 && cell.free > laws.dry)) return Vector2d::Zero();
    Vector2d next = cell.coupled_velocity + dt * cell.push;
    const double speed = std::hypot(next.x(), next.y()), loss = dt * cell.friction / cell.coupled_mass;
    if (speed > loss) {
        next *= 1 - loss / speed;
        return impulse_on(laws, cell, next, cell.coupled_mass, dt);
    }
    next = Vector2d::Zero();
    const double reserve = cell.coupled_mass * (loss - speed);
    Vector2d impulse = impulse_on(laws, cell, next, std::numeric_limits<double>::infinity(), dt);
    for (int i = 0; i < k_rounds; ++i) {
        const double size = std::hypot(impulse.x(), impulse.y());
        if (size <= reserve) break;
        impulse = impulse_on(laws, cell, next, cell.coupled_mass * size / (size - reserve), dt);
    }
    return impulse;
}

}  // namespace frana::structured
