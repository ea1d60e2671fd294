// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "core/default_values.h"
#include "physics/law.h"
#include "physics/strain_rate.h"
#include "physics/yield_ratio.h"

namespace frana {

/// Depth-integrated Bingham stress (paper, equation 3 with the square root it lacks; Quecedo et al. 2004):
///
///     sigma = ( 2 mu + tau_Y / sqrt(I2 + r^2) ) D,      I2 = 1/2 Dbar : Dbar
///
/// Dbar: D, D33 = -(D11 + D22), and vertical shear 3 / (2 + zeta) v / h (equations 5-6). r is the shear rate
/// below which the yield part is replaced by a very viscous one; share/doc/model.md shows that results do not depend on
/// it over two decades. Limits: at rest sigma = 0; at depth 0 the shear is infinite and the yield part vanishes.
struct BinghamStress {
    static constexpr bool active = true;
    static constexpr const char* word = "bingham";
    struct Values {
        double viscosity = 0, yield_stress = 0;

        /// With neither viscosity nor yield stress there is no stress.
        [[nodiscard]] bool has_bingham_stress() const noexcept { return viscosity > 0 || yield_stress > 0; }
    };
    static auto keys() {
        return std::tuple{law_key(&Values::viscosity, "material.viscosity", worded("viscosity"), "Pa s", {0, 1e8},
                                  "Bingham viscosity."),
                          law_key(&Values::yield_stress, "material.yield-stress", worded("yield stress"), "Pa",
                                  {0, 1e7}, "Yield stress.")};
    }
    static Law row() {
        return {.sentence = worded("in-plane viscosity"), .yield_sentence = worded("in-plane yield stress")};
    }
    static bool acts(const auto& m) { return m.has_bingham_stress(); }
    static BinghamStress build(const auto& m, double) { return {m.viscosity / m.density, m.yield_stress / m.density}; }
    [[nodiscard]] static double wave_factor() noexcept { return 1; }

    double viscosity_over_density = 0;               ///< mu / rho [m2/s]
    double yield_over_density = 0;                   ///< tau_Y / rho [m2/s2]
    double regularisation = k_yield_regularisation;  ///< r [1/s]

    template <class Number>
    [[nodiscard, gnu::always_inline]] PlaneStress<Number> operator()(const StrainRate<Number>& rate) const noexcept {
        using std::sqrt;
        Number factor(2 * viscosity_over_density);
        if (yield_over_density > 0) {
            const Number speed = sqrt(rate.u * rate.u + rate.v * rate.v);
            const Number a = 6 * viscosity_over_density * speed / (yield_over_density * rate.depth);
            const Number zeta = ExactYieldRatio{}(a);
            const Number k = select(rate.depth > 0, 3 / ((2 + zeta) * rate.depth), Number(0.0));
            const Number shear_x = k * rate.u, shear_y = k * rate.v;  // du/dz, dv/dz
            const Number zz = -(rate.xx + rate.yy);
            const Number invariant = 0.5 * (rate.xx * rate.xx + rate.yy * rate.yy + zz * zz) + rate.xy * rate.xy +
                                     0.25 * (shear_x * shear_x + shear_y * shear_y);
            factor += yield_over_density / sqrt(invariant + regularisation * regularisation);
        }
        return {factor * rate.xx, factor * rate.xy, factor * rate.yy, factor};
    }
};

}  // namespace frana
