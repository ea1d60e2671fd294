// SPDX-License-Identifier: Apache-2.0
// The exact solutions of the accuracy bench must themselves be right: equations, budgets, limits.
#include <gtest/gtest.h>

#include <cmath>

#include "bench/exact/solutions.h"

namespace frana::bench {
namespace {

TEST(RadialReference, ConservesTheVolume) {
    const double start = 0.5 * (10 * 60 * 60 + 2 * (250 * 250 - 60 * 60.0));
    const RadialReference wet(60, 10, 2, 250, 4, 500);
    EXPECT_NEAR(wet.volume(), start, 1e-12 * start);  // finite volumes: rounding of 500 sums
    const RadialReference dry(60, 10, 0, 250, 4, 500);
    // Where a cell's depth would become negative it is set to zero; that must remain negligible.
    EXPECT_NEAR(dry.volume(), 0.5 * 10 * 60 * 60, 1e-6 * start);
}

TEST(RadialReference, LeavesALakeAtRest) {
    const RadialReference lake(60, 3, 3, 100, 5, 300);
    EXPECT_NEAR(lake.at(50).depth, 3, 1e-12);
    EXPECT_NEAR(lake.at(50).velocity, 0, 1e-12);
}

TEST(RadialReference, IsADamBreakBeforeTheCurvatureHasAnEffect) {
    // After 0.2 s the waves have travelled 4 m of 60: the circle is straight to one part in fifteen.
    const double t = 0.2;
    const DamBreak straight(10, 2);
    const RadialReference wet(60, 10, 2, 120, t, 12000);
    EXPECT_NEAR(wet.at(60).depth, straight.at(0, t).depth, 0.02 * straight.at(0, t).depth);
    EXPECT_NEAR(wet.reach(3) - 60, straight.front(t), 0.03 * straight.front(t));
}

// Mean difference of depth from a fine solution [m].
double distance_from(const RadialReference& fine, int cells) {
    const RadialReference coarse(60, 10, 2, 200, 6, cells);
    double sum = 0;
    for (int i = 0; i < 200; ++i) sum += std::abs(coarse.at(i + 0.5).depth - fine.at(i + 0.5).depth);
    return sum / 200;
}

TEST(RadialReference, Converges) {
    const RadialReference fine(60, 10, 2, 200, 6, 3200);
    const double coarse = distance_from(fine, 200), middle = distance_from(fine, 400);
    EXPECT_LT(middle, 0.62 * coarse);  // a shock: first order, 0.7 at least
    EXPECT_LT(middle, 0.02);
}

// f'' and g'' of the header's equations against differences of the solution in time.
TEST(SimilaritySolution, SatisfiesItsEquations) {
    const double t = 3, dt = 1e-2, height = 4, radius = 80;
    const auto at = [&](double time) { return SimilaritySolution(35, 25, height, radius, time); };
    const SimilaritySolution before = at(t - dt), now = at(t), after = at(t + dt);
    const double normal = 9.81 * std::cos(35 * k_degree), friction = normal * std::tan(25 * k_degree);
    const double drive = 9.81 * std::sin(35 * k_degree) - friction, spread = 2 * normal * height / (radius * radius);
    const double f = now.along(), g = now.across();
    const double g_rate = (after.across() - before.across()) / (2 * dt);
    // Second differences: dt^2 / 12 of the fourth derivative, and rounding over dt^2.
    EXPECT_NEAR((after.along() - 2 * f + before.along()) / (dt * dt), spread / (f * f * g), 1e-6);
    EXPECT_NEAR((after.across() - 2 * g + before.across()) / (dt * dt),
                spread / (f * g * g) - friction * g_rate / (drive * t), 1e-6);
    EXPECT_NEAR(now.middle(), 0.5 * drive * t * t, 1e-12 * now.middle());
}

TEST(SimilaritySolution, ConservesTheVolumeAndSpreadsMoreAlongThanAcross) {
    const SimilaritySolution cap(35, 25, 4, 80, 5);
    double volume = 0;
    constexpr double k_step = 0.5;
    for (double x = -120; x < 160; x += k_step)
        for (double y = -120; y < 120; y += k_step) volume += cap.at({x, y}).depth * k_step * k_step;
    const double exact = 0.5 * M_PI * 4 * 80 * 80;
    EXPECT_NEAR(volume, exact, 1e-4 * exact);  // sums over half-metre squares of a paraboloid
    EXPECT_GT(cap.along(), cap.across());
    EXPECT_GT(cap.across(), 1);
}

TEST(SimilaritySolution, IsRoundWithoutFriction) {
    const SimilaritySolution cap(35, 0, 4, 80, 5);
    EXPECT_NEAR(cap.along(), cap.across(), 1e-9);
}

}  // namespace
}  // namespace frana::bench
