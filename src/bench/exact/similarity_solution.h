// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bench/exact/exact_state.h"
#include "core/grid_spec.h"

namespace frana::bench {

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
