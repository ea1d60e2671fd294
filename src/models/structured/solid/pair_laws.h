// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

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

/// Cubic spline kernel in the plane (Monaghan & Lattanzio 1985; paper, equation 74 with its first range corrected to
/// 0..1). With q = r / l, l the smoothing length [m]:
///     W = k [ (2 - q)+^3 / 4 - (1 - q)+^3 ],   k = 10 / (7 pi l^2)      [1/m2]
/// Zero from r = 2 l on; its integral over the plane is 1.
class CubicKernel {
  public:
    explicit CubicKernel(double length)
        : length_(length), inverse_(1 / length), scale_(10 / (7 * M_PI * length * length)) {}

    [[nodiscard]] double length() const noexcept { return length_; }
    [[nodiscard]] double reach() const noexcept { return 2 * length_; }

    /// W at distance r [1/m2].
    [[nodiscard]] double value(double r) const noexcept {
        const double q = r * inverse_, outer = q < 2 ? 2 - q : 0, inner = q < 1 ? 1 - q : 0;
        return scale_ * (0.25 * outer * outer * outer - inner * inner * inner);
    }
    /// dW/dr [1/m3]; the gradient with respect to x_i is (x_i - x_j) / r dW/dr.
    [[nodiscard]] double derivative(double r) const noexcept {
        const double q = r * inverse_, outer = q < 2 ? 2 - q : 0, inner = q < 1 ? 1 - q : 0;
        return scale_ * inverse_ * (3 * inner * inner - 0.75 * outer * outer);
    }

  private:
    double length_, inverse_, scale_;
};

/// Parameters of the solids' laws for the sums over neighbours. These are compiled for AVX2 as well, where Eigen would
/// align its types differently from the rest of the program: no header of the sums includes Eigen.
struct PairLaws {
    explicit PairLaws(double smoothing_length) : kernel(smoothing_length) {}

    CubicKernel kernel;
    double spacing = 1;  ///< of particles at the start, dp [m]
    ArtificialViscosity viscosity;
};

}  // namespace frana::structured
