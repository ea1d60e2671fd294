// SPDX-License-Identifier: Apache-2.0
// What solids and fluid do to each other, against closed forms and worked numbers.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "models/structured/coupling/basal_pressure.h"
#include "models/structured/coupling/exchange.h"

namespace frana::structured::test {
namespace {

TEST(BasalPressure, Limits) {
    BasalPressure law{9.81, 1000, 0};
    const double h_s = 5, h_fc = 5;
    const double weight = 9.81 * (2400 * h_s + 1000 * h_fc);
    EXPECT_DOUBLE_EQ(law({h_s, h_fc, 1, 0}, 2400), weight);          // whole, B = 0: all of it
    EXPECT_DOUBLE_EQ(law({h_s, 0, 0, 1}, 2400), 9.81 * 1400 * h_s);  // loose, submerged: buoyant weight
    EXPECT_DOUBLE_EQ(law({h_s, 0, 0, 0}, 2400), 9.81 * 2400 * h_s);  // loose, dry: no buoyancy
    law.propagation = 1;
    for (const double structured : {0.0, 0.4, 1.0})  // B = 1: buoyant weight, whatever the structure
        EXPECT_NEAR(law({h_s, h_fc, structured, 1}, 2400), 9.81 * 1400 * h_s, 1e-9);
    EXPECT_EQ(law({h_s, 0, 1, 1}, 800), 0);  // what floats presses on nothing
    EXPECT_EQ(law({}, 2400), 0);
}

TEST(SettlingVelocity, StokesAndZanke) {
    const SettlingFluid water;
    // Worked by hand to three digits; the tolerance is half of the last.
    EXPECT_NEAR(settling_velocity(water, 2400, 1e-4), 0.00763, 5e-6);
    EXPECT_NEAR(settling_velocity(water, 2400, 1.0001e-4), 0.00665, 5e-6);
    EXPECT_NEAR(settling_velocity(water, 2400, 1e-3), 0.1076, 5e-5);
    EXPECT_NEAR(settling_velocity(water, 2400, 1e-2), 0.370, 5e-4);
    EXPECT_NEAR(settling_velocity(water, 2400, 0.1), 1.17, 5e-3);
    EXPECT_EQ(settling_velocity(water, 900, 1e-3), 0);
}

Mixture still_cell() {
    Mixture m;
    m.solids = m.coupled = 0.5;
    m.coupled_density = m.grain_density = 2400;
    m.grain_diameter = 1e-3;
    return m;
}

TEST(Drag, CoefficientsOfTheStillCell) {
    Drag drag;
    const Mixture m = still_cell();
    EXPECT_NEAR(drag.fluid_like(m, 100), 0.23148, 1e-5);
    drag.exponent = 1;
    EXPECT_NEAR(drag.loose(m, 0.1, 100, 0.5, 10), 171.41, 0.01);
    drag.exponent = 2;
    EXPECT_NEAR(drag.loose(m, 0.1, 100, 0.5, 10), 8.5576, 1e-4);
}

TEST(Drag, NothingWithoutEitherPhase) {
    Drag drag;
    Mixture m = still_cell();
    EXPECT_GT(drag(m), 0);
    m.coupled = 0.9999;
    EXPECT_EQ(drag(m), 0);
    m.coupled = 1e-4;
    EXPECT_EQ(drag(m), 0);
    m = still_cell();
    m.coupled_density = 990;
    EXPECT_EQ(drag(m), 0);
}

TEST(Drag, FluidLikeFraction) {
    Drag drag;
    Mixture m = still_cell();
    m.structured = 0.2;
    m.confined = 0.5;
    EXPECT_DOUBLE_EQ(drag.fraction(m), 1);  // 0.4 / 0.25, cut
    m.solids = 0.2;
    EXPECT_DOUBLE_EQ(drag.fraction(m), 0.2 * 0.8 / (0.8 * 0.5));
}

TEST(VirtualMass, SharesAcceleration) {
    // Two by two, against Cramer's rule.
    const double m_c = 1700, m_u = 600, m_v = 900, f_c = 4000, f_u = -1500;
    const double a_c0 = f_c / m_c, a_u0 = f_u / m_u;
    const double f = virtual_mass_force(m_v, m_c, m_u, {a_u0 - a_c0, 0}).x();
    const double determinant = (m_c + m_v) * (m_u + m_v) - m_v * m_v;
    EXPECT_NEAR(a_c0 + f / m_c, (f_c * (m_u + m_v) + f_u * m_v) / determinant, 1e-12);
    EXPECT_NEAR(a_u0 - f / m_u, (f_u * (m_c + m_v) + f_c * m_v) / determinant, 1e-12);

    VirtualMass law;
    EXPECT_DOUBLE_EQ(law(0.5, 0.5, 1e9, 500), 1000.0);  // m_u a_c / a_u C = 500 * 2, at the cap of 2 m_u
    EXPECT_DOUBLE_EQ(law(0.2, 0.8, 1e9, 800), 800 * 0.25 * 0.5 * 1.4 / 0.8);
    EXPECT_LE(law(0.999, 0.001, 1700, 1), 2);  // capped where free fluid runs out
    law.acts = false;
    EXPECT_EQ(law(0.2, 0.8, 1e9, 800), 0);
}

CellPhases random_cell(std::mt19937_64& random) {
    std::uniform_real_distribution<double> any(0, 1);
    const auto velocity = [&] { return Eigen::Vector2d(20 * any(random) - 10, 20 * any(random) - 10); };
    CellPhases cell;
    cell.solids = 5 * any(random);
    cell.confined = 5 * any(random);
    cell.free = 5 * any(random);
    cell.coupled_mass = 2400 * cell.solids + 1000 * cell.confined;
    cell.structured = any(random);
    cell.coupled_velocity = velocity();
    cell.free_velocity = velocity();
    cell.push = velocity();
    cell.free_push = velocity();
    return cell;
}

// The impulse takes relative speed, never turns it round, however long the step.
TEST(Exchange, DragNeverReversesTheRelativeVelocity) {
    std::mt19937_64 random(3);
    CouplingLaws laws;
    laws.virtual_mass.acts = false;
    for (int i = 0; i < 500; ++i) {
        CellPhases cell = random_cell(random);
        cell.push.setZero();
        laws.drag.exponent = 1 + i % 2;
        const double m_u = 1000 * cell.free;
        const Eigen::Vector2d w = cell.free_velocity - cell.coupled_velocity;
        for (const double dt : {1e-4, 1.0, 1e9}) {
            const Eigen::Vector2d impulse = exchange(laws, cell, dt);
            const Eigen::Vector2d left = w - impulse * (1 / cell.coupled_mass + 1 / m_u);
            EXPECT_GE(left.dot(w), -1e-9 * w.squaredNorm());
            EXPECT_LE(left.norm(), (1 + 1e-12) * w.norm());
        }
    }
}

TEST(Exchange, SolidsThatTheBedHoldsDoNotStirWaterAtRest) {
    CouplingLaws laws;
    CellPhases cell;
    cell.solids = 1;
    cell.free = 2;
    cell.coupled_mass = 2400;
    cell.push = {-1, 0.5};
    cell.friction = 0.5 * 1400 * 9.81;
    const Eigen::Vector2d impulse = exchange(laws, cell, 0.1);
    EXPECT_EQ(impulse.x(), 0);
    EXPECT_EQ(impulse.y(), 0);
}

// What drives the fluid, drag and nothing else hold back: drag alone decides its final speed. With the solids' own mass
// in place of the bed's hold, m_v / m_c = 1.2 more weight would be on the drag.
TEST(Exchange, AStreamOverSolidsThatTheBedHoldsEndsAtTheSpeedOfDragAlone) {
    constexpr double dt = 1e-3, weight = 0.98;  // [m/s2]
    const auto speed = [&](bool acts) {
        CouplingLaws laws;
        laws.virtual_mass.acts = acts;
        laws.drag.smoothing_velocity = 1;
        CellPhases cell;
        cell.solids = cell.confined = cell.free = 1;
        cell.structured = 1;
        cell.coupled_mass = 3400;
        cell.friction = 1400 * 9.81;
        for (int i = 0; i < 100'000; ++i) {
            cell.free_push = {weight, 0};
            cell.free_velocity.x() += dt * weight;
            cell.free_velocity -= exchange(laws, cell, dt) / 1000;
        }
        return cell.free_velocity.x();
    };
    const double alone = speed(false);
    EXPECT_GT(alone, 0.1);
    // First order in time: the drag acts on the speed at the end of each step.
    EXPECT_NEAR(speed(true), alone, 2e-3 * alone);
}

// Friction that holds a part of the impulse only: between the answer of held and of free solids, without a jump.
TEST(Exchange, TheAnswerOfSolidsIsContinuousInTheFrictionThatHoldsThem) {
    CouplingLaws laws;
    CellPhases cell;
    cell.solids = cell.confined = cell.free = 1;
    cell.structured = 1;
    cell.coupled_mass = 3400;
    cell.free_velocity = {3, 0};
    cell.free_push = {0.5, 0};
    double before = exchange(laws, cell, 0.1).x();
    const double free = before;
    for (double friction = 50; friction < 20'000; friction += 50) {
        cell.friction = friction;
        const double impulse = exchange(laws, cell, 0.1).x();
        EXPECT_GE(impulse, before * (1 - 1e-12)) << friction;
        EXPECT_LT(impulse - before, 5 + 0.02 * before) << friction;  // 50 Pa in 0.1 s are 5
        before = impulse;
    }
    EXPECT_GT(before, free);
}

TEST(Exchange, NothingInADryCell) {
    CellPhases cell;
    cell.solids = 1;
    cell.coupled_mass = 2400;
    cell.coupled_velocity = {3, 0};
    EXPECT_EQ(exchange({}, cell, 1).x(), 0);
}

}  // namespace
}  // namespace frana::structured::test
