// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "physics/infiltration_green_ampt.h"
#include "physics/rain.h"

namespace frana {
namespace {

constexpr double k_hour = 3600;

// A loam under half a metre of water.
const GreenAmpt k_loam{13e-3 / k_hour, 0.09, 0.3};

// The law itself, in the square of F, which is smooth at the start: d(F^2)/dt = 2 K (F + D (psi + w - F)); Runge and
// Kutta's fourth order.
double by_small_steps(const GreenAmpt& soil, double water, double time, int steps) {
    const auto rate = [&](double square) {
        const double f = std::sqrt(square);
        return 2 * soil.conductivity * (f + soil.deficit * (soil.suction + water - f));
    };
    double square = 0;
    const double dt = time / steps;
    for (int i = 0; i < steps; ++i) {
        // F is as its root: steps that grow as the time, from one in which F is that of suction alone.
        const double a = rate(square), b = rate(square + 0.5 * dt * a), c = rate(square + 0.5 * dt * b),
                     d = rate(square + dt * c);
        square += dt / 6 * (a + 2 * b + 2 * c + d);
    }
    return std::sqrt(square);
}

// A single step of any length gives the law's integral: the sum of 400 000 small ones has an error of 1e-8, of its
// first.
TEST(GreenAmpt, IsTheIntegralOfItsRate) {
    for (const double time : {1.0, 60.0, k_hour, 10 * k_hour}) {
        const double exact = by_small_steps(k_loam, 0.5, time, 400'000);
        EXPECT_NEAR(k_loam(0, 0.5, time), exact, 1e-7 * exact) << time;
    }
}

// Many steps are one: to the rounding of a thousand sums.
TEST(GreenAmpt, DoesNotDependOnItsSteps) {
    for (const double time : {1.0, k_hour, 10 * k_hour}) {
        double water = 0.5, gone = 0;
        for (int i = 0; i < 1000; ++i) {
            const double more = k_loam(gone, water, time / 1000);
            gone += more;
            water -= more;
        }
        EXPECT_NEAR(gone, k_loam(0, 0.5, time), 1e-12 * gone) << time;
    }
}

TEST(GreenAmpt, HasTheLimitsOfItsFormula) {
    // At first by suction and head alone, F^2 = 2 K D (psi + w) t; gravity adds F/3 of it to lowest order.
    const double soon = 1e-3, first = std::sqrt(2 * k_loam.conductivity * 0.3 * 0.59 * soon);
    EXPECT_NEAR(k_loam(0, 0.5, soon), first, 1e-3 * first);
    // Of a soil that is full, K; into tight ground, without water, and beyond what there is, nothing more.
    EXPECT_DOUBLE_EQ((GreenAmpt{1e-5, 0.1, 0}(0, 0.5, 100)), 1e-3);
    EXPECT_DOUBLE_EQ((GreenAmpt{1e-5, 0, 0}(0.2, 1e-4, 100)), 1e-4);
    EXPECT_EQ((GreenAmpt{0, 0.1, 0.3}(0, 0.5, 100)), 0);
    EXPECT_EQ(k_loam(0, 0, 100), 0);
    EXPECT_EQ(k_loam(0, 1e-5, 100), 1e-5);
    // Late the rate falls to K.
    EXPECT_NEAR(k_loam(1e5, 1e3, 100) / 100, k_loam.conductivity, 0.01 * k_loam.conductivity);
}

TEST(Rain, IsLinearBetweenItsPointsAndNoneElsewhere) {
    const Rain rain{{{100, 0}, {200, 2e-5}, {200, 1e-5}, {300, 1e-5}}};
    EXPECT_EQ(rain.depth_by(100), 0);
    EXPECT_DOUBLE_EQ(rain.depth_by(150), 0.25e-3);
    EXPECT_DOUBLE_EQ(rain.depth_by(200), 1e-3);
    EXPECT_DOUBLE_EQ(rain.depth_by(250), 1.5e-3);
    EXPECT_DOUBLE_EQ(rain.depth_by(1e6), 2e-3);
    EXPECT_EQ(Rain{}.depth_by(1e6), 0);
}

}  // namespace
}  // namespace frana
