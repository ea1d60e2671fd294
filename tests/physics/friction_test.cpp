// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "physics/friction_voellmy.h"

namespace frana {
namespace {

TEST(VoellmyFriction, StopsAndNeverReverses) {
    const VoellmyFriction friction{0.5, 1 / 200.0};
    EXPECT_EQ(friction.speed_after(1e-3, 0.1, 9.81, 9.81, 1), 0);
    for (const double thickness : {1e-9, 1e-3, 1.0, 50.0}) {
        for (const double speed : {0.0, 1e-12, 0.5, 10.0, 1e3}) {
            const double after = friction.speed_after(speed, 0.1, 9.81, 9.81, thickness);
            EXPECT_GE(after, 0);
            EXPECT_LE(after, speed);
        }
    }
}

TEST(VoellmyFriction, IsFiniteAtZeroDepth) {
    const VoellmyFriction friction{0.5, 1 / 200.0};
    EXPECT_EQ(friction.speed_after(10, 0.1, 9.81, 9.81, 0), 0);
}

// Backward Euler: s1 + dt (g mu + g s1^2 / (xi d)) = s0 to rounding.
TEST(VoellmyFriction, SolvesTheImplicitEquation) {
    const VoellmyFriction friction{0.3, 1 / 500.0};
    const double s0 = 20, dt = 0.05, g = 9.81, normal = 8.5, d = 1.7;
    const double s1 = friction.speed_after(s0, dt, normal, g, d);
    EXPECT_NEAR(s1 + dt * (0.3 * normal + g * s1 * s1 / (500 * d)), s0, 1e-12);
}

TEST(VoellmyFriction, WithoutTurbulenceIsCoulomb) {
    const VoellmyFriction friction{0.3, 0};
    EXPECT_NEAR(friction.speed_after(20, 0.1, 9.81, 9.81, 1), 20 - 0.1 * 0.3 * 9.81, 1e-13);
}

}  // namespace
}  // namespace frana
