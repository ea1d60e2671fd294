// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "physics/friction_voellmy.h"

namespace frana {
namespace {

TEST(VoellmyFriction, StopsAndNeverReverses) {
    const VoellmyFriction friction{0.5, 1 / 200.0};
    EXPECT_EQ(friction.speed_after(1e-3, 1e-3, 0.1, 9.81, 9.81, 1), 0);
    for (const double thickness : {1e-9, 1e-3, 1.0, 50.0}) {
        for (const double speed : {0.0, 1e-12, 0.5, 10.0, 1e3}) {
            const double after = friction.speed_after(speed, speed, 0.1, 9.81, 9.81, thickness);
            EXPECT_GE(after, 0);
            EXPECT_LE(after, speed);
        }
    }
}

TEST(VoellmyFriction, IsFiniteAtZeroDepth) {
    const VoellmyFriction friction{0.5, 1 / 200.0};
    EXPECT_EQ(friction.speed_after(10, 10, 0.1, 9.81, 9.81, 0), 0);
}

// dv/dt = a (1 - v^2 / v_t^2) from rest: v = v_t tanh(a t / v_t); from 2 v_t: v = v_t coth(a t / v_t + acoth 2). Half
// the step has a quarter of the error: 3.5 to 4.5, since the next order is a tenth of it.
TEST(VoellmyFriction, IsOfSecondOrder) {
    const VoellmyFriction friction{0.2, 1 / 1000.0};
    const double push = 5, normal = 8.5, g = 9.81, d = 1.7, time = 4;
    const double a = push - 0.2 * normal, terminal = std::sqrt(a * 1000 * d / g);
    for (const double start : {0.0, 2.0}) {
        const double exact = start > 0 ? terminal / std::tanh(a * time / terminal + std::atanh(0.5))
                                       : terminal * std::tanh(a * time / terminal);
        const auto error = [&](int steps) {
            const double dt = time / steps;
            double v = start * terminal;
            for (int i = 0; i < steps; ++i) v = friction.speed_after(v, v + dt * push, dt, normal, g, d);
            return std::abs(v - exact);
        };
        EXPECT_GT(error(10) / error(20), 3.5) << start;
        EXPECT_LT(error(10) / error(20), 4.5) << start;
        EXPECT_LT(error(10), 2e-3 * exact) << start;  // backward Euler: 1.2 and 2.0 %
    }
}

// However long the step: at the terminal speed to rounding, and from rest or from far above no farther than beyond it.
TEST(VoellmyFriction, KeepsAndReachesTheTerminalSpeed) {
    const VoellmyFriction friction{0.2, 1 / 1000.0};
    const double push = 5, normal = 8.5, g = 9.81;
    for (const double d : {1e-9, 1e-3, 1.0, 50.0}) {
        const double terminal = std::sqrt((push - 0.2 * normal) * 1000 * d / g);
        for (const double dt : {0.01, 1.0, 1e3}) {
            const auto after = [&](double v) { return friction.speed_after(v, v + dt * push, dt, normal, g, d); };
            EXPECT_NEAR(after(terminal), terminal, 1e-10 * terminal) << d << ' ' << dt;
            EXPECT_LE(after(0), terminal * (1 + 1e-10)) << d << ' ' << dt;
            EXPECT_GE(after(100 * terminal), terminal * (1 - 1e-10)) << d << ' ' << dt;
        }
        EXPECT_NEAR(friction.speed_after(0, 1e3 * push, 1e3, normal, g, d), terminal, 0.05 * terminal) << d;
    }
}

TEST(VoellmyFriction, WithoutTurbulenceIsCoulomb) {
    const VoellmyFriction friction{0.3, 0};
    EXPECT_NEAR(friction.speed_after(20, 20, 0.1, 9.81, 9.81, 1), 20 - 0.1 * 0.3 * 9.81, 1e-13);
}

}  // namespace
}  // namespace frana
