// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "particles/particle_set.h"
#include "physics/yield_ratio.h"

namespace frana {

/// Rate of strain in the plane, with what the depth-integrated invariant needs.
struct StrainRate {
    double xx, xy, yy;  ///< D = sym grad v [1/s]
    double u, v;        ///< velocity [m/s]
    double depth;       ///< [m]
};

/// In-plane stress over density and the viscosity that bounds the time step.
struct PlaneStress {
    double xx = 0, xy = 0, yy = 0;  ///< [m2/s2]
    double diffusivity = 0;         ///< (2 mu + tau_Y / sqrt(I2)) / rho [m2/s]
};

/// No in-plane stress: nothing is stored or computed.
struct NoStress {
    static constexpr bool active = false;
    static constexpr FieldMask fields{};
    PlaneStress operator()(const StrainRate&) const noexcept { return {}; }
};

/// Depth-integrated Bingham stress (paper, equation 3 with the square root it lacks; Quecedo et al. 2004):
///
///     sigma = ( 2 mu + tau_Y / sqrt(I2 + r^2) ) D,      I2 = 1/2 Dbar : Dbar
///
/// Dbar: D, D33 = -(D11 + D22), and vertical shear 3 / (2 + zeta) v / h (equations 5-6). r is the shear rate
/// under which the yield part is softened into a very viscous one; share/doc/model.md shows that results do
/// not depend on it over two decades. Limits: at rest sigma = 0; at depth 0 the shear is infinite and the
/// yield part vanishes.
struct BinghamStress {
    static constexpr bool active = true;
    static constexpr FieldMask fields = k_stress_fields;

    double viscosity_over_density = 0;  ///< mu / rho [m2/s]
    double yield_over_density = 0;      ///< tau_Y / rho [m2/s2]
    double regularisation = 0.01;       ///< r [1/s]
    bool exact_ratio = true;            ///< zeta from the cubic; false: from the paper's quadratic

    [[nodiscard]] PlaneStress operator()(const StrainRate& rate) const noexcept {
        double factor = 2 * viscosity_over_density;
        if (yield_over_density > 0) {
            double shear_x = 0, shear_y = 0;  // du/dz, dv/dz
            if (rate.depth > 0) {
                const double speed = std::sqrt(rate.u * rate.u + rate.v * rate.v);
                const double a = 6 * viscosity_over_density * speed / (yield_over_density * rate.depth);
                const double zeta = exact_ratio ? ExactYieldRatio{}(a) : QuadraticYieldRatio{}(a);
                const double k = 3 / ((2 + zeta) * rate.depth);
                shear_x = k * rate.u;
                shear_y = k * rate.v;
            }
            const double zz = -(rate.xx + rate.yy);
            const double invariant = 0.5 * (rate.xx * rate.xx + rate.yy * rate.yy + zz * zz) + rate.xy * rate.xy +
                                     0.25 * (shear_x * shear_x + shear_y * shear_y);
            factor += yield_over_density / std::sqrt(invariant + regularisation * regularisation);
        }
        return {factor * rate.xx, factor * rate.xy, factor * rate.yy, factor};
    }
};

}  // namespace frana
