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

TEST(YieldRatio, QuadraticIsWithinThePublishedError) {
    double greatest = 0;
    for (double a = 0; a < 100; a += 0.01) {
        const double zeta = QuadraticYieldRatio{}(a);
        greatest = std::max(greatest, std::abs(zeta - ExactYieldRatio{}(a)));
        ASSERT_NEAR(48 * zeta * zeta - (114 + 32 * a) * zeta + 65, 0, 1e-9 * (65 + 32 * a));
    }
    // The closed form gives 0.951 against 1 at a -> 0; nowhere else is it worse.
    EXPECT_LT(greatest, 0.05);
    EXPECT_NEAR(QuadraticYieldRatio{}(0.0), 0.951, 1e-3);
}

TEST(BinghamStress, NewtonianPartIsTwiceTheViscosityTimesD) {
    const BinghamStress stress{0.5, 0, 0.01, true};
    const PlaneStress<double> s = stress(StrainRate<double>{1.0, 0.25, -0.5, 3, 4, 2});
    EXPECT_DOUBLE_EQ(s.xx, 1.0);
    EXPECT_DOUBLE_EQ(s.xy, 0.25);
    EXPECT_DOUBLE_EQ(s.yy, -0.5);
    EXPECT_DOUBLE_EQ(s.diffusivity, 1.0);
}

// Pure in-plane shear far above the regularisation: |sigma_xy| = mu gamma + tau_Y, gamma = 2 D_xy.
TEST(BinghamStress, YieldPartHasTheYieldStressAsItsMagnitude) {
    const double yield = 3, rate = 2;
    const BinghamStress stress{1e-9, yield, 1e-6, true};
    const PlaneStress<double> s = stress(StrainRate<double>{0, rate / 2, 0, 0, 0, 1});
    // I2 = D_xy^2 = (gamma / 2)^2, so tau_Y / sqrt(I2) D_xy = tau_Y.
    EXPECT_NEAR(s.xy, yield, 1e-6 * yield);
}

TEST(BinghamStress, IsFiniteAtRestAndAtZeroDepth) {
    const BinghamStress stress{0.5, 3, 0.01, true};
    const PlaneStress<double> rest = stress(StrainRate<double>{0, 0, 0, 0, 0, 1});
    EXPECT_EQ(rest.xx, 0);
    EXPECT_TRUE(std::isfinite(rest.diffusivity));
    const PlaneStress<double> dry = stress(StrainRate<double>{1, 1, 1, 1, 1, 0});
    EXPECT_TRUE(std::isfinite(dry.xx));
}

// A yield-stress slump on a plane: the run-out must not depend on the regularisation over two decades.
TEST(BinghamStress, ResultDoesNotDependOnTheRegularisation) {
    const auto front = [](double regularisation) {
        const GridSpec grid = bench::plain_grid(100, 6, 1);
        const Raster bed = bench::sample_raster(grid, [](Point p) { return 0.2 * (100 - p.x); });
        const ParticleSet seeds =
            bench::fill_lattice(grid, 2, 0, [](Point p) { return bench::Seed{p.x > 10 && p.x < 30 ? 4.0 : 0.0}; });
        Material material = dry_friction(8);
        material.density = 1500;
        material.viscosity = 200;
        material.yield_stress = 2000;
        material.yield_regularisation = regularisation;
        Flow flow(bed, seeds, material, numerics(Scheme::standard, SlopeCorrection::normal, Boundary::wall), 1);
        flow.advance_to(4);
        return flow.centroid().x - 20;
    };
    const double middle = front(0.01);
    // One percent of the displacement: far less than the uncertainty of any yield stress.
    EXPECT_NEAR(front(0.1), middle, 0.01 * middle);
    EXPECT_NEAR(front(0.001), middle, 0.01 * middle);
    EXPECT_GT(middle, 2);
}

}  // namespace
}  // namespace frana::test
