// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "models/structured/solid/spline_lattice.h"
#include "particles/particle_set.h"

namespace frana::structured {

/// Sums of the solids at a node of the stress: momenta of two sets of particles, loose and bonded, and one force.
struct StressSums {
    struct Momentum {
        double mass = 0, px = 0, py = 0;  ///< [kg], [kg m/s]
    };
    Momentum of[2];
    double fx = 0, fy = 0;  ///< [N]
};

/// What a particle gathers before it moves: accelerations, the nodes' velocity, and the affine part of that after dt.
struct NodeMotion {
    double ax = 0, ay = 0, u = 0, v = 0;            ///< [m/s2], [m/s]
    double c_xx = 0, c_xy = 0, c_yx = 0, c_yy = 0;  ///< [1/s]
};

/// The solids' stress on nodes, as the first model's: with the splines N of a lattice of side d,
///     v_i = sum m N_i (u + C (x_i - x)) / sum m N_i,   L = sum v_i grad N_i,   f_i = -sum V sigma grad N_i,
///     a = sum N_i f_i / M_i,   C = 3 / d^2 sum N_i (v_i + dt a_i) (x_i - x)^T      (M_i the mass of all)
/// (Jiang et al. 2015, ACM Trans. Graph. 34, 51: d^2 / 3 is the cubic spline's second moment). Forces sum to zero, so
/// momentum is kept to rounding; v is exact where velocities are linear. Velocities are those of a particle's own set:
/// what has broken off and flows away strains no face, and pushes it all the same.
class StressNodes : public SplineLattice<StressSums> {
  public:
    using SplineLattice::SplineLattice;

    /// Adds momentum. Reads x, y, u, v, c_*.
    void add_momentum(const ParticleSet& particles, std::size_t p, double mass, bool bonded) {
        const double u = particles[Field::u][p], v = particles[Field::v][p], d = side();
        const double c_xx = d * particles[Field::c_xx][p], c_xy = d * particles[Field::c_xy][p];
        const double c_yx = d * particles[Field::c_yx][p], c_yy = d * particles[Field::c_yy][p];
        const Stencil s = at(particles[Field::x][p], particles[Field::y][p]);
        const double u0 = u + c_xx * s.to_x + c_xy * s.to_y, v0 = v + c_yx * s.to_x + c_yy * s.to_y;
        s.for_each([&](Node& node, int a, int b) {
            StressSums::Momentum& sum = fresh(node).of[bonded ? 1 : 0];
            const double m = s.wx[a] * s.wy[b] * mass;
            sum.mass += m;
            sum.px += m * (u0 + a * c_xx + b * c_xy);
            sum.py += m * (v0 + a * c_yx + b * c_yy);
        });
    }
    /// L_ab = dv_a / dx_b [1/s] of a particle's set; after all momenta.
    [[nodiscard]] Eigen::Matrix2d velocity_gradient(const Stencil& s, bool bonded) const noexcept {
        double xx = 0, xy = 0, yx = 0, yy = 0;
        s.for_each([&](const Node& node, int a, int b) {
            const StressSums::Momentum& sum = node.of[bonded ? 1 : 0];
            const double inverse = inverse_mass(sum.mass), u = inverse * sum.px, v = inverse * sum.py;
            const double gx = s.sx[a] * s.wy[b], gy = s.wx[a] * s.sy[b];
            xx += gx * u;
            xy += gy * u;
            yx += gx * v;
            yy += gy * v;
        });
        Eigen::Matrix2d l;
        l << xx, xy, yx, yy;
        return l / side();
    }
    /// Adds the force of a stress times volume [N m].
    static void add_force(const Stencil& s, const Eigen::Matrix2d& stress, double side) noexcept {
        const double xx = -stress(0, 0) / side, yy = -stress(1, 1) / side, xy = -stress(0, 1) / side;
        s.for_each([&](Node& node, int a, int b) {
            const double gx = s.sx[a] * s.wy[b], gy = s.wx[a] * s.sy[b];
            node.fx += xx * gx + xy * gy;
            node.fy += xy * gx + yy * gy;
        });
    }
    /// After all forces.
    [[nodiscard]] NodeMotion motion(const Stencil& s, double dt, bool bonded) const noexcept {
        NodeMotion m;
        s.for_each([&](const Node& node, int a, int b) {
            const StressSums::Momentum& sum = node.of[bonded ? 1 : 0];
            const double w = s.wx[a] * s.wy[b];
            const double inverse = inverse_mass(sum.mass);
            const double per_mass = inverse_mass(node.of[0].mass + node.of[1].mass);
            const double u = inverse * sum.px, v = inverse * sum.py, ax = per_mass * node.fx, ay = per_mass * node.fy;
            m.ax += w * ax;
            m.ay += w * ay;
            m.u += w * u;
            m.v += w * v;
            const double to_x = w * (s.to_x + a), to_y = w * (s.to_y + b), next_u = u + dt * ax, next_v = v + dt * ay;
            m.c_xx += to_x * next_u;
            m.c_xy += to_y * next_u;
            m.c_yx += to_x * next_v;
            m.c_yy += to_y * next_v;
        });
        for (double* c : {&m.c_xx, &m.c_xy, &m.c_yx, &m.c_yy}) *c *= 3 / side();
        return m;
    }

  private:
    // 0 for a node that only a particle on the lattice's line touches: its weight there is 0.
    static double inverse_mass(double mass) noexcept {
        constexpr double k_least = 1e-200;  // [kg]; its inverse times any momentum is finite
        return mass > k_least ? 1 / mass : 0;
    }
};

}  // namespace frana::structured
