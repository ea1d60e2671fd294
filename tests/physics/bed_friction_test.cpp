// SPDX-License-Identifier: Apache-2.0
// Each law of bed friction alone: against its closed form, at rest, at zero depth, without support.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "physics/friction_bingham.h"
#include "physics/friction_chezy.h"
#include "physics/friction_cohesion.h"
#include "physics/friction_coulomb.h"
#include "physics/friction_herschel_bulkley.h"
#include "physics/friction_manning.h"
#include "physics/friction_modified_voellmy.h"
#include "physics/friction_obrien_julien.h"
#include "physics/friction_pouliquen_forterre.h"
#include "physics/friction_ramms_yield.h"
#include "physics/friction_turbulence.h"
#include "physics/friction_voellmy.h"
#include "physics/pore_pressure.h"

namespace frana {
namespace {

constexpr double k_density = 1800, k_thickness = 1.7, k_normal = 8.5, k_gravity = 9.81;

template <class Law>
BedState bed_under(const Law& law, double thickness = k_thickness, double normal = k_normal, double pore_pressure = 0) {
    BedState bed{thickness, normal, 0, 0, 0, 0, pore_pressure};
    law(bed, 0);
    return bed;
}

// Returns R(s1) of backward Euler, from s0 = s1 + dt R.
template <class Excess>
double resistance_met(const BedState& bed, const Excess& excess, double s0, double dt, double* s1) {
    *s1 = excess.speed_after(bed, 0, s0 - dt * bed.yield, dt);
    return (s0 - *s1) / dt;
}

TEST(CoulombFriction, IsTheTangentTimesTheEffectiveNormalStress) {
    const CoulombFriction law{{0.4}, 300 / k_density};
    EXPECT_DOUBLE_EQ(bed_under(law, k_thickness, k_normal, 0.3).yield,
                     0.4 * (0.7 * k_normal + 300 / (k_density * k_thickness)));
    EXPECT_EQ(bed_under(CoulombFriction{{0.4}}, 1, 0).yield, 0) << "no support, no friction";
}

TEST(CoulombFriction, ReadsItsValueFromTheNode) {
    const std::vector<double> values{0.1, 0.5};
    const CoulombFriction law{{0.3, values.data()}};
    BedState bed{1, 10, 0, 0, 0, 0, 0};
    law(bed, 1);
    EXPECT_DOUBLE_EQ(bed.yield, 5);
}

TEST(TurbulentFriction, IsVoellmysSecondPartAndChezysLaw) {
    const double xi = 400;
    EXPECT_DOUBLE_EQ(bed_under(TurbulentFriction{k_gravity, {xi}}).square, k_gravity / (xi * k_thickness));
    EXPECT_DOUBLE_EQ(bed_under(TurbulentFriction{k_gravity, {xi}}).square,
                     bed_under(ChezyFriction{k_gravity, 20}).square);
    EXPECT_EQ(bed_under(TurbulentFriction{k_gravity, {std::numeric_limits<double>::infinity()}}).square, 0);
}

// The sum of Coulomb's and the turbulent part equals the law used for scenes with Voellmy alone.
TEST(TurbulentFriction, WithCoulombIsTheUniformVoellmyLaw) {
    const VoellmyFriction uniform{0.2, 1 / 400.0};
    BedState bed = bed_under(CoulombFriction{{0.2}});
    TurbulentFriction{k_gravity, {400}}(bed, 0);
    for (const double s0 : {0.01, 0.5, 3.0, 60.0}) {
        EXPECT_NEAR(speed_after_friction(bed, 0, NoExcess{}, s0, 1.1 * s0, 0.05),
                    uniform.speed_after(s0, 1.1 * s0, 0.05, k_normal, k_gravity, k_thickness), 1e-14 * s0);
    }
}

TEST(ManningFriction, GivesManningsSpeed) {
    // Uniform flow: g S = R at s = d^(2/3) S^(1/2) / n.
    const double n = 0.06, slope = 0.1, speed = std::pow(k_thickness, 2.0 / 3) * std::sqrt(slope) / n;
    EXPECT_NEAR(bed_under(ManningFriction{k_gravity, n}).square * speed * speed, k_gravity * slope, 1e-12);
}

TEST(CohesiveFriction, HoldsMaterialOfTheCriticalDepth) {
    EXPECT_DOUBLE_EQ(bed_under(CohesiveFriction{k_density, {1500}}).yield * k_density * k_thickness, 1500);
}

TEST(RammsYield, IncreasesFromFrictionOf45DegreesToItsLimit) {
    const double mu = 0.3, n0 = 800;
    const RammsYield law{k_density, n0, {mu}};
    const double normal = k_density * k_normal * k_thickness;
    EXPECT_NEAR(bed_under(law).yield * k_density * k_thickness, (1 - mu) * n0 * (1 - std::exp(-normal / n0)), 1e-9);
    EXPECT_NEAR(bed_under(law, 1e-9).yield, (1 - mu) * k_normal, 1e-6);
    EXPECT_NEAR(bed_under(law, 50).yield * k_density * 50, (1 - mu) * n0, 1e-9);
    EXPECT_EQ(bed_under(law, 1, 0).yield, 0);
}

TEST(OBrienJulienFriction, IsTheFrictionSlopeTimesGravity) {
    const OBrienJulienFriction law{k_gravity, k_density, 120, 30, 2000, 0.05};
    const BedState bed = bed_under(law);
    const double s = 3.1, d = k_thickness, gamma = k_density * k_gravity;
    const double slope =
        120 / (gamma * d) + 2000 * 30 * s / (8 * gamma * d * d) + 0.05 * 0.05 * s * s / std::pow(d, 4.0 / 3);
    EXPECT_NEAR(bed.yield + bed.linear * s + bed.square * s * s, k_gravity * slope, 1e-12);
}

TEST(ModifiedVoellmyFriction, IsOneOfTheTwoPartsOnEitherSideOfItsSpeed) {
    const ModifiedVoellmyExcess law{k_gravity, {0.3}, {500}, 4};
    const double crossover = 4 * std::cbrt(k_thickness), dt = 1e-6;
    const BedState bed = bed_under(law);
    EXPECT_DOUBLE_EQ(bed.yield, 0.3 * k_normal);
    EXPECT_DOUBLE_EQ(bed_under(law, 1, 10, 0.25).yield, 0.75 * 0.3 * 10);
    double after = 0;
    for (const double s : {0.1, 0.99 * crossover})
        EXPECT_NEAR(resistance_met(bed, law, s, dt, &after), 0.3 * k_normal, 1e-6) << s;
    for (const double s : {1.01 * crossover, 60.0})
        EXPECT_NEAR(resistance_met(bed, law, s, dt, &after), k_gravity * s * s / (500 * k_thickness), 1e-3) << s;
    EXPECT_EQ(speed_after_friction(bed, 0, law, 0.01, 0.01, 1), 0) << "stops within a step";
    BedState dry = bed_under(law, 0);
    EXPECT_EQ(speed_after_friction(dry, 0, law, 3, 3, 0.1), 0);
    const BedState film = bed_under(law, 1e-9);
    EXPECT_LT(speed_after_friction(film, 0, law, 30, 30, 0.1), 0.01) << "thin flow is slow at once";
    EXPECT_EQ(bed_under(law, 1, 0).yield, 0) << "no support, no friction";
}

// A block that reaches flat ground with a speed v_0 slows down as exp(-g x / (xi d)) to v_c and then by friction:
//
//     x = (xi d / g) ln(v_0 / v_c) + v_c^2 / (2 mu g),   v_c = v_1 d^(1/3)
//
// With v_0 of a fall through a height h, thickness 8 times as large (512 times the volume in the same shape) takes it
// 5.7 times as far; the sum of both parts, whose run-out is (xi d / 2 g) ln(1 + v_0^2 / (mu xi d)), 2.8 times, since
// its friction stops thick flow as well as thin: what a fitted mu then has to make up for.
TEST(ModifiedVoellmyFriction, RunsOutFartherTheThickerWithTheSameParameters) {
    const double mu = 0.2, xi = 500, v1 = 4, start = std::sqrt(2 * k_gravity * 300), dt = 0.01;
    const ModifiedVoellmyExcess law{k_gravity, {mu}, {xi}, v1};
    const auto way = [&](const auto& excess, const BedState& bed) {
        double s = start, x = 0;
        while (s > 0) {
            const double next = speed_after_friction(bed, 0, excess, s, s, dt);
            x += 0.5 * (s + next) * dt;
            s = next;
        }
        return x;
    };
    std::vector<double> ways, sums;
    for (const double d : {5.0, 40.0}) {
        const double crossover = v1 * std::cbrt(d), exact = xi * d / k_gravity * std::log(start / crossover) +
                                                            crossover * crossover / (2 * mu * k_gravity);
        ways.push_back(way(law, bed_under(law, d, k_gravity)));
        EXPECT_NEAR(ways.back(), exact, 0.002 * exact) << d;
        BedState sum = bed_under(CoulombFriction{{mu}}, d, k_gravity);
        TurbulentFriction{k_gravity, {xi}}(sum, 0);
        sums.push_back(way(NoExcess{}, sum));
        const double both = xi * d / (2 * k_gravity) * std::log(1 + start * start / (mu * xi * d));
        EXPECT_NEAR(sums.back(), both, 0.002 * both) << d;
    }
    const double grown = ways[1] / ways[0], grown_sum = sums[1] / sums[0];
    EXPECT_NEAR(grown, 5.67, 0.05);
    EXPECT_NEAR(grown_sum, 2.84, 0.05);
}

// Under a push f the speed after `time` in that many steps.
template <class Excess>
double speed_in_steps(const BedState& bed, const Excess& excess, double push, double start, double time, int steps) {
    double s = start;
    const double dt = time / steps;
    for (int i = 0; i < steps; ++i) s = speed_after_friction(bed, 0, excess, s, s + dt * push, dt);
    return s;
}

// The error of the coarser step over that of its half, against a step sixteen times finer: 4 for second order.
template <class Excess>
void expect_second_order(const BedState& bed, const Excess& excess, double push, double start, double time) {
    const double fine = speed_in_steps(bed, excess, push, start, time, 640);
    const double coarse = std::abs(speed_in_steps(bed, excess, push, start, time, 20) - fine),
                 half = std::abs(speed_in_steps(bed, excess, push, start, time, 40) - fine);
    EXPECT_GT(coarse / half, 3.3) << start;
    EXPECT_LT(coarse / half, 4.8) << start;
}

// ds/dt = f - y - l s - q s^2 from 0 to 30 m/s.
TEST(PolynomialFriction, IsOfSecondOrder) {
    const BedState bed{1, 9, 0.7, 0.3, 0.02, 0, 0};
    for (const double start : {0.0, 2.0, 30.0}) expect_second_order(bed, NoExcess{}, 6, start, 2);
    EXPECT_EQ(speed_after_friction(bed, 0, NoExcess{}, 0.069, 0.069, 0.1), 0);
    const double terminal = (-0.3 + std::sqrt(0.3 * 0.3 + 4 * 0.02 * 5.3)) / (2 * 0.02);
    for (const double dt : {0.01, 1.0, 1e3})
        EXPECT_NEAR(speed_after_friction(bed, 0, NoExcess{}, terminal, terminal + 6 * dt, dt), terminal, 1e-10);
}

// Fluids in steady simple shear: the profile of du/dz = ((tau_B (1 - z/d) - tau_Y) / K)^(1/m), integrated
// twice over the depth by Simpson's rule, is the mean speed.
double mean_speed_by_quadrature(double bed_stress, double yield, double consistency, double index, double depth) {
    const int n = 20000;
    const double sheared = depth * (1 - yield / bed_stress), dz = sheared / n;
    // mean = 1/d int_0^d u dz = 1/d int_0^d (d - z) u'(z) dz
    double sum = 0;
    for (int i = 0; i <= n; ++i) {
        const double z = i * dz, excess = std::max(0.0, bed_stress * (1 - z / depth) - yield);
        sum += (i == 0 || i == n ? 1 : i % 2 ? 4 : 2) * (depth - z) * std::pow(excess / consistency, 1 / index);
    }
    return sum * dz / 3 / depth;
}

TEST(HerschelBulkley, MeanSpeedIsTheIntegralOfTheProfile) {
    for (const double index : {0.4, 0.8, 1.0, 1.5}) {
        const HerschelBulkleyExcess law{k_density, 200, 60, index};
        const double exact = mean_speed_by_quadrature(650, 200, 60, index, k_thickness);
        // Simpson's rule at the end of the sheared zone, where the profile's slope varies as a power.
        EXPECT_NEAR(law.speed(450, k_thickness).value, exact, 1e-6 * exact) << index;
    }
}

TEST(HerschelBulkley, WithIndexOneIsTheCubicOfBingham) {
    const double yield = 300, viscosity = 40;
    const HerschelBulkleyExcess law{k_density, yield, viscosity, 1};
    const BedState bed = bed_under(law);
    for (const double s0 : {0.2, 1.0, 5.0, 40.0}) {
        double s = 0;
        const double met = resistance_met(bed, law, s0, 0.02, &s) * k_density * k_thickness;
        ASSERT_GT(s, 0);
        const double zeta = ExactYieldRatio{}(6 * viscosity * s / (yield * k_thickness));
        // (s0 - s) / dt loses digits if friction is small.
        EXPECT_NEAR(met, yield / zeta, 1e-10 * s0 / 0.02 * k_density * k_thickness + 1e-9 * met) << s0;
    }
}

TEST(HerschelBulkley, WithoutYieldIsNewtonsFilm) {
    const HerschelBulkleyExcess law{k_density, 0, 25, 1};
    EXPECT_NEAR(law.speed(500, k_thickness).value, 500 * k_thickness / (3 * 25), 1e-12);
}

TEST(PouliquenForterre, IncreasesFromSlowToFastFriction) {
    PouliquenForterreExcess law{{0.38}, 0.64};
    law.length = 0.8;
    const BedState bed = bed_under(law);
    EXPECT_DOUBLE_EQ(bed.yield, 0.38 * k_normal);
    for (const double s0 : {0.5, 4.0, 200.0}) {
        double s = 0;
        const double met = resistance_met(bed, law, s0, 0.02, &s);
        const double froude = s / std::sqrt(k_normal * k_thickness);
        const double mu = 0.38 + (0.64 - 0.38) / (1 + 0.136 * k_thickness / (0.8 * froude));
        EXPECT_NEAR(met, mu * k_normal, 1e-11 * s0 / 0.02);
    }
    // Thin: all fast friction.
    const BedState thin = bed_under(law, 1e-6);
    double s = 0;
    EXPECT_NEAR(resistance_met(thin, law, 4, 0.02, &s), 0.64 * k_normal, 1e-5);
}

TEST(PlaceOfValue, IsFoundFromGuessesThatAreOffByOrdersOfMagnitude) {
    for (const double power : {0.5, 1.0, 3.0, 10.0}) {
        for (const double root : {1e-6, 0.3, 7e4}) {
            for (const double guess : {1e-4, 0.5, 1.0, 2.0, 1e5}) {
                int calls = 0;
                const double found = place_of_value(
                    [&](double x) -> ValueAndSlope {
                        ++calls;
                        const double there = std::pow(x / root, power), plus = 0.2 * x / root;
                        return {there + plus, (power * there + plus) / x};
                    },
                    1.2, 1e9 * root, guess * root);
                EXPECT_NEAR(found, root, 1e-14 * root) << power << ' ' << guess;
                EXPECT_LE(calls, guess > 0.1 && guess < 10 ? 6 : 12) << power << ' ' << guess;
            }
        }
    }
    EXPECT_EQ(place_of_value([](double x) { return ValueAndSlope{x, 1}; }, 5, 3, 1), 3);
}

TEST(BedFriction, SlopesOfSpeedsAreDerivatives) {
    const auto compare = [](const auto& law) {
        for (const double x : {2.0, 90.0, 4000.0}) {
            const double step = 1e-5 * x;
            const double rise = law.speed(x + step, k_thickness).value - law.speed(x - step, k_thickness).value;
            const double slope = law.speed(x, k_thickness).slope;
            EXPECT_NEAR(rise / (2 * step), slope, 1e-8 * slope) << x;  // of second order in the step
        }
    };
    for (const double index : {0.4, 1.0, 1.5}) compare(HerschelBulkleyExcess{k_density, 200, 60, index});
}

template <class Law>
class AnyExcess : public testing::Test {};
using Excesses = testing::Types<HerschelBulkleyExcess, PouliquenForterreExcess>;
TYPED_TEST_SUITE(AnyExcess, Excesses);

TYPED_TEST(AnyExcess, StopsAndNeverReversesAndIsFinite) {
    const TypeParam law{};
    for (const double d : {1e-9, 1e-3, 1.0, 50.0}) {
        BedState bed = bed_under(law, d);
        bed.linear = 0.1;
        bed.square = 0.01 / d;
        for (const double s0 : {0.0, 1e-12, 1e-3, 0.5, 10.0, 1e3}) {
            for (const double dt : {1e-4, 0.1, 10.0}) {
                const double s = speed_after_friction(bed, 0, law, s0, s0, dt);
                EXPECT_GE(s, 0) << d << ' ' << s0 << ' ' << dt;
                EXPECT_LE(s, s0) << d << ' ' << s0 << ' ' << dt;
                if (dt * bed.yield >= s0) {
                    EXPECT_EQ(s, 0);
                }
            }
        }
    }
    BedState dry{0, 9, 0, 0, 0, 0, 0};
    EXPECT_EQ(speed_after_friction(dry, 0, law, 5, 5, 0.1), 0);
}

TYPED_TEST(AnyExcess, IsOfSecondOrderAndKeepsTheTerminalSpeed) {
    const TypeParam law{};
    BedState bed = bed_under(law);
    bed.square = 0.01;
    const double push = bed.yield + 4;
    for (const double start : {1.0, 10.0}) expect_second_order(bed, law, push, start, 2);
    const double terminal = speed_in_steps(bed, law, push, 1, 1e4, 1000);
    for (const double dt : {0.01, 1.0, 100.0})
        EXPECT_NEAR(speed_after_friction(bed, 0, law, terminal, terminal + dt * push, dt), terminal, 1e-8 * terminal);
}

PorePressure dissipating(double ratio, double time) {
    PorePressure pore{{ratio}};
    pore.dissipation_time = time;
    return pore;
}

TEST(PorePressure, DissipatesExponentially) {
    EXPECT_NEAR(dissipating(0.6, 20).after({0.6}, 1, 0, k_gravity, 20 * std::log(2)).ratio, 0.3, 1e-15);
    const double never = std::numeric_limits<double>::infinity();
    EXPECT_EQ(dissipating(0.6, never).after({0.6}, 1, 5, k_gravity, 1e6).ratio, 0.6);
    PorePressure pore = dissipating(0.9, 20);
    pore.hydrostatic = 0.5;
    EXPECT_NEAR(pore.after({0.9}, 1, 0, k_gravity, 20 * std::log(2)).ratio, 0.7, 1e-15);
    EXPECT_NEAR(pore.after({0}, 1, 0, k_gravity, 20 * std::log(2)).ratio, 0.25, 1e-15) << "from below";
    pore.diffusivity = 1e-3;
    for (const double dry : {0.0, 1e-300}) EXPECT_EQ(pore.after({0.9}, dry, 3, k_gravity, 0.01).ratio, 0.5);
}

// A layer of uniform excess pressure that drains at its surface, at the base: Terzaghi's series. From time factor 0.5
// on its second term is exp(-2 pi^2 0.5) / 3 = 1.7e-5 of the first.
TEST(PorePressure, DissipatesAsTerzaghisSeriesEnds) {
    const double depth = 3, diffusivity = 0.02;
    const auto series = [&](double time) {
        double sum = 0;
        for (int k = 0; k < 20; ++k) {
            const double odd = 2 * k + 1;
            sum += (k % 2 == 0 ? 1 : -1) / odd * std::exp(-std::pow(odd * M_PI / (2 * depth), 2) * diffusivity * time);
        }
        return 4 / M_PI * sum;
    };
    PorePressure pore{{0.9}};
    pore.diffusivity = diffusivity;
    const double from = 0.5 * depth * depth / diffusivity, to = 1.5 * from;
    EXPECT_NEAR(pore.after({1}, depth, 0, k_gravity, to - from).ratio, series(to) / series(from), 2e-5);
}

PorePressure dilating(double diffusivity) {
    PorePressure pore{{0.5, 0.6}, 0.5};
    pore.diffusivity = diffusivity;
    pore.critical_fraction = 0.56;
    pore.compressibility = 1e-6;
    pore.density = 2000;
    return pore;
}

// Without drainage the solids stay: dr/dt = -3 s (m - m_c) / (alpha d sigma).
TEST(PorePressure, DenseMaterialLosesAndLooseGainsItInUndrainedShear) {
    const PorePressure pore = dilating(0);
    const double per_second = 3 * 0.1 * 0.02 / (1e-6 * 2 * 2000 * k_gravity * 2);
    for (const double m : {0.58, 0.54}) {
        const auto after = pore.after({0.5, m}, 2, 0.1, k_gravity, 3);
        EXPECT_NEAR(after.ratio, 0.5 - (m - 0.56) / 0.02 * 3 * per_second, 1e-12);
        EXPECT_EQ(after.solid_fraction, m);
    }
    EXPECT_EQ(pore.after({0.5, 0.7}, 2, 10, k_gravity, 100).ratio, 0);
    EXPECT_EQ(pore.after({0.5, 0.4}, 2, 10, k_gravity, 100).ratio, 1);
}

// While the solids hardly change, dr/dt = -(r - r_h) / T - S. They change by 2 s t m / d, 3.4e-5, of m - m_c.
TEST(PorePressure, TendsToTheValueOfSlowSteadyShear) {
    PorePressure pore = dilating(0);
    pore.dissipation_time = 10;
    pore.compressibility = 3e-11;
    const double shear = 3 * 1e-6 * 0.01 / (3e-11 * 2000 * k_gravity);
    const double exact = 0.5 - shear * 10 * (1 - std::exp(-3.0));
    ASSERT_LT(exact, 0.1);
    EXPECT_NEAR(pore.after({0.5, 0.57}, 1, 1e-6, k_gravity, 30).ratio, exact, 1e-4 * (0.5 - exact));
}

// Against the classical Runge-Kutta method with 1e5 steps, for slow dilation (overdamped) and fast shear (oscillating):
// of first order, since the factor m is that before the step, which matters little.
TEST(PorePressure, FollowsItsEquationsWithDilatancy) {
    for (const double speed : {1e-3, 0.3}) {
        const PorePressure pore = dilating(0.02);
        const double d = 1, sigma = pore.density * k_gravity * d, time = 20;
        const double rate = M_PI * M_PI / 4 * pore.diffusivity;
        const auto slope = [&](PorePressure::State at) {
            return PorePressure::State{
                -rate * (at.ratio - 0.5) - 3 * speed * (at.solid_fraction - 0.56) / (pore.compressibility * d * sigma),
                2.0 / 3 * pore.compressibility * at.solid_fraction * sigma * (at.ratio - 0.5) * rate};
        };
        const auto moved = [](PorePressure::State at, PorePressure::State by, double dt) {
            return PorePressure::State{at.ratio + dt * by.ratio, at.solid_fraction + dt * by.solid_fraction};
        };
        const PorePressure::State start{0.5, speed > 0.1 ? 0.5601 : 0.562};
        PorePressure::State exact = start;
        const int n = 100000;
        for (int i = 0; i < n; ++i) {
            const double dt = time / n;
            const auto a = slope(exact), b = slope(moved(exact, a, dt / 2)), c = slope(moved(exact, b, dt / 2)),
                       e = slope(moved(exact, c, dt));
            exact = moved(moved(moved(moved(exact, a, dt / 6), b, dt / 3), c, dt / 3), e, dt / 6);
        }
        ASSERT_GT(std::abs(exact.ratio - 0.5), 1e-4);
        const auto error = [&](int steps) {
            PorePressure::State at = start;
            for (int i = 0; i < steps; ++i) at = pore.after(at, d, speed, k_gravity, time / steps);
            return std::abs(at.ratio - exact.ratio);
        };
        EXPECT_LT(error(20), 1e-4 * std::abs(exact.ratio - 0.5));
        EXPECT_NEAR(error(20) / error(40), 2, 0.1);
    }
}

// Sheared for long it drains to hydrostatic pressure at the critical fraction, from either side.
TEST(PorePressure, EndsInTheCriticalState) {
    const PorePressure pore = dilating(0.01);
    for (const double m : {0.54, 0.6}) {
        PorePressure::State at{0.5, m};
        for (int i = 0; i < 20000; ++i) at = pore.after(at, 0.5, 1, k_gravity, 0.1);
        EXPECT_NEAR(at.ratio, 0.5, 1e-9);
        EXPECT_NEAR(at.solid_fraction, 0.56, 1e-9);
    }
}

}  // namespace
}  // namespace frana
