// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace frana::structured {

/// Viscosity between approaching particles (Monaghan; paper, equations 83 and 84, minus sign restored):
///     Pi = (-a c phi + b phi^2) / Sigma,   phi = l v_ij.x_ij / (x_ij^2 + 0.01 l^2)   while v_ij.x_ij < 0, else 0
/// with Sigma the mean areal density [kg/m2]. It is a pressure over density squared and repels. pair_sums.h evaluates
/// it.
struct ArtificialViscosity {
    double linear = 1;     ///< a [-]
    double quadratic = 1;  ///< b [-]
    double sound = 0;      ///< c; of a pair the mean of both, of loose material sqrt(g h) [m/s]
    double length = 1;     ///< l [m]

    static constexpr double k_softening = 0.01;
};

}  // namespace frana::structured
