// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/grid_spec.h"

namespace frana::bench {

inline constexpr double k_gravity = 9.81;  ///< of every case [m/s2]
inline constexpr double k_degree = 0.017453292519943295;

/// Depth and momentum of an exact solution at a node.
struct ExactState {
    double depth = 0, qx = 0, qy = 0;
};

/// Depth and velocity of an exact solution at one place and time.
struct WaterState {
    double depth = 0;     ///< [m]
    double velocity = 0;  ///< [m/s]
};

/// Exact frictionless dam break on a flat bed, dam at x = 0, water at rest with `left` > `right` >= 0 metres.
///
/// right = 0: Ritter (1892), a parabola from -c t to +2 c t with c = sqrt(g left).
/// right > 0: Stoker (1957): rarefaction, a state (h_m, u_m) between, and a shock of speed S with
///     u_m = 2 (sqrt(g left) - sqrt(g h_m)),   u_m = (h_m - right) sqrt(g (h_m + right) / (2 h_m right)),
/// whose h_m is found by bisection.
class DamBreak {
  public:
    DamBreak(double left, double right, double gravity = 9.81);

    /// @param x from the dam [m]  @param t time [s], > 0
    [[nodiscard]] WaterState at(double x, double t) const;
    /// Position of the front or shock [m].
    [[nodiscard]] double front(double t) const { return front_speed_ * t; }

  private:
    double left_, right_, gravity_;
    double middle_ = 0, middle_velocity_ = 0, front_speed_ = 0;
};

/// Collapse of a cylinder of water, computed on a fine radial grid, independent of the particle method.
///     (r h)_t + (r h u)_r = 0,   (r h u)_t + (r (h u^2 + g h^2 / 2))_r = g h^2 / 2
/// Finite volumes, piecewise linear in h and u (van Leer's limiter), HLL flux with the wave speeds of a dry
/// front, Heun's method in time; LeVeque 2002, chapters 6, 13 and 17. A wall at r = 0 and at the outer end.
class RadialReference {
  public:
    /// @param radius of the cylinder [m]  @param inside, outside depths [m]  @param extent outer wall [m]
    /// @param time [s]  @param cells over the extent
    RadialReference(double radius, double inside, double outside, double extent, double time, int cells);

    /// Returns depth and outward velocity at a distance from the middle.
    [[nodiscard]] WaterState at(double r) const;
    /// Returns the distance of the outermost place deeper than `depth` [m].
    [[nodiscard]] double reach(double depth) const;
    /// Volume over 2 pi [m3]; for the test of conservation.
    [[nodiscard]] double volume() const;

  private:
    struct Cell {
        double h = 0, q = 0;
    };
    void rate(const std::vector<Cell>& state, std::vector<Cell>& change) const;
    [[nodiscard]] double fastest() const;

    double dr_;
    std::vector<Cell> cells_;
};

/// Similarity solution of a parabolic cap of granular material sliding down a plane: Savage and Hutter, J. Fluid Mech.
/// 199 (1989); in two dimensions Hutter, Siegel, Savage, Nohguchi, Acta Mechanica 100 (1993), with one earth pressure
/// coefficient K for both directions. In the slope's coordinates
///     h = H / (f g) (1 - (X / (R f))^2 - (Y / (R g))^2),   X = x - a t^2 / 2,  a = g (sin - cos tan delta),
///     u = a t + X f'/f,   v = Y g'/g,
///     f'' = 2 K G H / (R^2 f^2 g),   g'' = 2 K G H / (R^2 f g^2) - F g' / (a t),   G = g cos, F = G tan
///     delta.
/// The last term is friction turned sideways by v/u, to first order; the neglected terms are of the order of (v/u)^2 F
/// / 2, a few percent of a at the cap's sides, so an error below about 0.005 cannot be expected. The equations are
/// integrated by the classical Runge-Kutta method from the start's series.
class SimilaritySolution {
  public:
    SimilaritySolution(double slope_deg, double friction_deg, double height, double radius, double time,
                       double earth_pressure = 1);

    /// Returns thickness and momentum at a place in slope coordinates; the cap's initial middle is the origin.
    [[nodiscard]] ExactState at(Point place) const;
    [[nodiscard]] double along() const noexcept { return f_; }        ///< f
    [[nodiscard]] double across() const noexcept { return g_; }       ///< g
    [[nodiscard]] double middle() const noexcept { return middle_; }  ///< a t^2 / 2 [m]

  private:
    double height_, radius_, middle_, speed_;
    double f_ = 1, g_ = 1, f_rate_ = 0, g_rate_ = 0;
};

}  // namespace frana::bench
