// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace frana::bench {

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

}  // namespace frana::bench
