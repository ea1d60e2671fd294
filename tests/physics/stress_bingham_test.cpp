// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "physics/stress_bingham.h"
#include "support/cases.h"

namespace frana::test {
namespace {

TEST(YieldRatio, ExactRootSatisfiesTheCubic) {
    for (const double a : {0.0, 1e-12, 1e-8, 1e-4, 0.01, 0.1, 0.5, 0.999, 1.0, 3.0, 10.0, 1e3, 1e8, 1e14}) {
        const double zeta = ExactYieldRatio{}(a);
        EXPECT_GE(zeta, 0);
        EXPECT_LE(zeta, 1);
        // Relative to the terms; at a -> 0 the root is double, so the residual's square root counts.
        EXPECT_NEAR((zeta * zeta * zeta - (3 + a) * zeta + 2) / (3 + a), 0, 1e-14) << a;
    }
    EXPECT_EQ(ExactYieldRatio{}(0.0), 1);
    EXPECT_NEAR(ExactYieldRatio{}(1e10) * 1e10 / 2, 1, 1e-9);  // 2 / (3 + a)
}

TEST(BinghamStress, NewtonianPartIsTwiceTheViscosityTimesD) {
    const BinghamStress stress{0.5, 0, 0.01};
    const PlaneStress<double> s = stress(StrainRate<double>{1.0, 0.25, -0.5, 3, 4, 2});
    EXPECT_DOUBLE_EQ(s.xx, 1.0);
    EXPECT_DOUBLE_EQ(s.xy, 0.25);
    EXPECT_DOUBLE_EQ(s.yy, -0.5);
    EXPECT_DOUBLE_EQ(s.diffusivity, 1.0);
}

// Pure in-plane shear far above the regularisation: |sigma_xy| = mu gamma + tau_Y, gamma = 2 D_xy.
TEST(BinghamStress, YieldPartHasTheYieldStressAsItsMagnitude) {
    const double yield = 3, rate = 2;
    const BinghamStress stress{1e-9, yield, 1e-6};
    const PlaneStress<double> s = stress(StrainRate<double>{0, rate / 2, 0, 0, 0, 1});
    // I2 = D_xy^2 = (gamma / 2)^2, so tau_Y / sqrt(I2) D_xy = tau_Y.
    EXPECT_NEAR(s.xy, yield, 1e-6 * yield);
}

TEST(BinghamStress, IsFiniteAtRestAndAtZeroDepth) {
    const BinghamStress stress{0.5, 3, 0.01};
    const PlaneStress<double> rest = stress(StrainRate<double>{0, 0, 0, 0, 0, 1});
    EXPECT_EQ(rest.xx, 0);
    EXPECT_TRUE(std::isfinite(rest.diffusivity));
    const PlaneStress<double> dry = stress(StrainRate<double>{1, 1, 1, 1, 1, 0});
    EXPECT_TRUE(std::isfinite(dry.xx));
}

}  // namespace
}  // namespace frana::test
