// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/quad.h"
#include "physics/stress_bingham.h"

namespace frana {
namespace {

struct QuadStress {
    Quad xx, xy, yy, diffusivity;
};

/// ExactYieldRatio for four values of a.
FRANA_INLINE Quad exact_yield_ratio(Quad a) {
    const Quad p = 3 + a;
    const Quad inverse = 1 / p;
    Quad zeta =
        select(a < 1, 1 - sqrt(a * (1.0 / 3)) + a * (1.0 / 9), 2 * inverse * (1 + 4 * inverse * inverse * inverse));
    for (int i = 0; i < 3; ++i) {
        const Quad slope = 3 * zeta * zeta - p;
        zeta = select(slope > -1e-12, zeta, zeta - (zeta * zeta * zeta - p * zeta + 2) / slope);
    }
    return min(max(zeta, 0.0), 1.0);
}

/// QuadraticYieldRatio for four values of a.
FRANA_INLINE Quad quadratic_yield_ratio(Quad a) {
    const Quad b = 57 + 16 * a;
    return 65 / (b + sqrt(b * b - 48 * 65));
}

/// BinghamStress for four particles.
FRANA_INLINE QuadStress bingham_stress(const BinghamStress& law, Quad xx, Quad xy, Quad yy, Quad u, Quad v,
                                       Quad depth) {
    Quad factor(2 * law.viscosity_over_density);
    if (law.yield_over_density > 0) {
        const Quad speed = sqrt(u * u + v * v);
        const Quad a = 6 * law.viscosity_over_density * speed / (law.yield_over_density * depth);
        const Quad zeta = law.exact_ratio ? exact_yield_ratio(a) : quadratic_yield_ratio(a);
        const Quad k = select(depth > 0, 3 / ((2 + zeta) * depth), 0.0);
        const Quad shear_x = k * u, shear_y = k * v, zz = -(xx + yy);
        const Quad invariant =
            0.5 * (xx * xx + yy * yy + zz * zz) + xy * xy + 0.25 * (shear_x * shear_x + shear_y * shear_y);
        factor += law.yield_over_density / sqrt(invariant + law.regularisation * law.regularisation);
    }
    return {factor * xx, factor * xy, factor * yy, factor};
}

}  // namespace
}  // namespace frana
