// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace frana {

/// Rate of strain in the plane, with the terms of the depth-integrated invariant; of one particle (double) or of four
/// (Quad).
template <class Number>
struct StrainRate {
    Number xx, xy, yy;  ///< D = sym grad v [1/s]
    Number u, v;        ///< velocity [m/s]
    Number depth;       ///< [m]
};

/// In-plane stress over density and the viscosity that bounds the time step.
template <class Number>
struct PlaneStress {
    Number xx, xy, yy;   ///< [m2/s2]
    Number diffusivity;  ///< (2 mu + tau_Y / sqrt(I2)) / rho [m2/s]
};

/// No in-plane stress.
struct NoStress {
    static constexpr bool active = false;
    [[nodiscard]] static double wave_factor() noexcept { return 1; }
};

}  // namespace frana
