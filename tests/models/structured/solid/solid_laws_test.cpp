// SPDX-License-Identifier: Apache-2.0
// Laws of the structured solids against closed forms and worked numbers.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "models/structured/solid/cubic_stencil.h"
#include "models/structured/solid/material_update.h"
#include "models/structured/solid/solid_laws.h"

namespace frana::structured::test {
namespace {

const double k_degree = M_PI / 180;

Stress stress(double xx, double yy, double zz, double xy) {
    return {symmetric(xx, yy, xy), zz};
}
const Elasticity k_flume{23e6, 4.246e6};

TEST(CubicSpline, AddsUpToOneAndReproducesLines) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> anywhere(3, 50);
    for (int i = 0; i < 1000; ++i) {
        const double s = anywhere(random);
        double w[4], g[4];
        const std::int64_t first = CubicSpline::evaluate(s, w, g);
        double sum = 0, line = 0, slopes = 0, slope_of_line = 0;
        for (int a = 0; a < 4; ++a) {
            const auto node = static_cast<double>(first + a);
            sum += w[a];
            line += w[a] * node;
            slopes += g[a];
            slope_of_line += g[a] * node;
        }
        EXPECT_NEAR(sum, 1, 1e-12);
        EXPECT_NEAR(line, s, 1e-12 * s);
        EXPECT_NEAR(slopes, 0, 1e-12);
        EXPECT_NEAR(slope_of_line, 1, 1e-12 * s);
    }
}

TEST(DruckerPrager, ConstantsOfBothFlumeMaterials) {
    const auto first = DruckerPrager::of(std::tan(28 * k_degree), 26.7e3);
    EXPECT_NEAR(first.slope, 0.151041, 1e-6);
    EXPECT_NEAR(first.strength, 22753.68, 0.01);
    EXPECT_NEAR(first.strength / first.slope, 150646.2, 0.1);
    const auto second = DruckerPrager::of(std::tan(27 * k_degree), 18.3e3);
    EXPECT_NEAR(second.slope, 0.146385, 1e-6);
    EXPECT_NEAR(second.strength, 15772.61, 0.01);
    EXPECT_NEAR(second.strength / second.slope, 107747.3, 0.1);
}

// The solver's stress update, of a column with cohesion and overburden.
struct Update {
    explicit Update(double dilatancy_deg) : laws(1) {
        laws.elastic = k_flume;
        laws.sin_dilatancy = std::sin(dilatancy_deg * k_degree);
        column.mass = column.depth = 5;
        column.cohesion = 26.7e3;
        column.load = 5 * 1700 * 9.81;
        set_thrust(friction, column);
    }
    [[nodiscard]] Returned operator()(const Matrix2d& l, double dt, const Stress& stress) const {
        return next_stress(laws, column, friction, rotation(dt * spin(l)), dt * strain_rate(l), stress);
    }
    /// With the geostatic stress, as the strength sees it.
    [[nodiscard]] Stress total(const Stress& s) const { return {s.plane, s.zz - column.borne}; }
    [[nodiscard]] double yield(const Stress& s) const { return strength().yield(total(s)); }
    [[nodiscard]] DruckerPrager strength() const { return DruckerPrager::of(friction, column.cohesion); }

    SolidLaws laws;
    ParticleLoad column;
    double friction = std::tan(28 * k_degree);
};

// Whatever the strain, the update ends inside the yield surface or on it; the vertical stress stays the overburden's.
TEST(StressUpdate, EndsOnTheYieldSurfaceUnderTheGivenLoad) {
    std::mt19937_64 random(2);
    std::uniform_real_distribution<double> any(-1, 1);
    int yielded = 0;
    for (const double dilatancy : {0.0, 2.0, 5.0}) {
        const Update update(dilatancy);
        for (int i = 0; i < 500; ++i) {
            const Matrix2d l{{any(random), any(random)}, {any(random), any(random)}};
            const double dt = std::pow(10, -5 + 5 * std::abs(any(random)));  // strains of 1e-5 to 1
            const auto [s, flowed] =
                update(l, dt, stress(20e3 * any(random), 20e3 * any(random), 0, 10e3 * any(random)));
            yielded += flowed;
            EXPECT_EQ(s.zz, 0);
            if (flowed)
                EXPECT_NEAR(update.yield(s), 0, 1e-9 * update.strength().strength);
            else
                EXPECT_LE(update.yield(s), 1e-9 * update.strength().strength);
        }
    }
    EXPECT_GT(yielded, 500);
}

// The rate of a stress that flows on the surface is the one that consistency asks for (df/dt = 0 with the plastic
// strain along the potential's gradient), at the given vertical stress: the update's limit for short steps.
TEST(StressUpdate, FlowsAsConsistencyAsks) {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> any(-1, 1);
    int flowing = 0;
    for (const double dilatancy : {0.0, 3.0}) {
        const Update update(dilatancy);
        const DruckerPrager law = update.strength();
        const double in_plane = k_flume.bulk + k_flume.shear / 3;
        for (int i = 0; i < 200; ++i) {
            const Stress s = update(Matrix2d{{any(random), any(random)}, {any(random), any(random)}}, 1e-2, {}).stress;
            if (std::abs(update.yield(s)) > 1e-9 * law.strength) continue;
            const Matrix2d l = symmetric(any(random), any(random), any(random));
            // Gradients of f and g by central differences, in (xx, yy, xy).
            const auto slope = [&](double of_i1, int k) {
                constexpr double e = 1;
                const Matrix2d step = e * symmetric(k == 0, k == 1, k == 2);
                const Stress here = update.total(s), high{here.plane + step, here.zz}, low{here.plane - step, here.zz};
                const auto at = [&](const Stress& t) { return std::sqrt(t.j2()) + of_i1 * t.i1(); };
                return (at(high) - at(low)) / (2 * e);
            };
            const auto stiff = [&](double xx, double yy, double xy) {  // engineering shear in, stress out
                const double mean = in_plane * (xx + yy), half = k_flume.shear * (xx - yy);
                return stress(mean + half, mean - half, 0, k_flume.shear * xy);
            };
            const double fx = slope(law.slope, 0), fy = slope(law.slope, 1), fs = slope(law.slope, 2);
            const double of_g = 3 * update.laws.sin_dilatancy;
            const Stress trial = stiff(l(0, 0), l(1, 1), 2 * l(0, 1)),
                         back = stiff(slope(of_g, 0), slope(of_g, 1), slope(of_g, 2));
            const double multiplier = (fx * trial.xx() + fy * trial.yy() + fs * trial.xy()) /
                                      (fx * back.xx() + fy * back.yy() + fs * back.xy());
            if (!(multiplier > 0)) continue;
            ++flowing;
            constexpr double dt = 1e-7;
            const Stress next = update(l, dt, s).stress;
            const double size =
                k_flume.bulk * 1e-3;  // of the rates, some 1e7 Pa/s; the step's own error is its thousandth
            EXPECT_NEAR((next.xx() - s.xx()) / dt, trial.xx() - multiplier * back.xx(), size);
            EXPECT_NEAR((next.yy() - s.yy()) / dt, trial.yy() - multiplier * back.yy(), size);
            EXPECT_NEAR((next.xy() - s.xy()) / dt, trial.xy() - multiplier * back.xy(), size);
        }
    }
    EXPECT_GT(flowing, 50);
}

// A strain path that yields, in ever shorter steps: first order, with dilatancy and without, and a change by dilatancy
// that does not depend on the step.
TEST(StressUpdate, ConvergesWithFirstOrder) {
    const auto path = [](double dilatancy, int steps) {
        const Update update(dilatancy);
        Stress s;
        for (int i = 0; i < steps; ++i) {
            const double t = (i + 0.5) / steps;  // shear that turns into compression from one side
            s = update(Matrix2d{{-0.01 * t, 0.004 * t}, {0.02 * (1 - t), 0}}, 1.0 / steps, s).stress;
        }
        return s;
    };
    for (const double dilatancy : {0.0, 3.0}) {
        const Stress exact = path(dilatancy, 20000);
        const auto error = [&](int steps) {
            const Stress off = path(dilatancy, steps) - exact;
            return std::sqrt(off.j2()) + std::abs(off.i1());
        };
        EXPECT_GT(std::log2(error(50) / error(100)), 0.9);
        EXPECT_GT(std::log2(error(100) / error(200)), 0.9);
    }
    const double change = path(3, 20000).i1() - path(0, 20000).i1();
    EXPECT_LT(change, -1e3);  // dilatant material that cannot widen presses
    EXPECT_NEAR(path(3, 200).i1() - path(0, 200).i1(), change, 0.05 * std::abs(change));
}

// At rest nothing yields, whatever strength, friction and load; and that takes not a bit off anything.
TEST(StressUpdate, TheGeostaticStateIsInsideForEveryCohesion) {
    SolidLaws laws(1);
    laws.elastic = k_flume;
    for (const double degrees : {5.0, 28.0, 45.0, 59.0}) {
        for (const double cohesion : {0.0, 1e-6, 1.0, 1e3, 2e4, 1e6}) {
            for (const double depth : {1e-3, 0.7, 8.0, 300.0}) {
                ParticleLoad column;
                const double friction = std::tan(degrees * k_degree);
                column.depth = depth;
                column.cohesion = cohesion;
                column.load = 1700 * 9.81 * depth;
                set_thrust(friction, column);
                const auto [s, yielded] = next_stress(laws, column, friction, rotation(0), Matrix2d::Zero(), {});
                EXPECT_FALSE(yielded) << degrees << " degrees, " << cohesion << " Pa, " << depth << " m";
                EXPECT_EQ(s.xx(), 0);
                EXPECT_EQ(s.yy(), 0);
            }
        }
    }
}

TEST(Rotation, AFullTurnGivesTheStressBack) {
    constexpr int n = 1000;
    Matrix2d s = symmetric(1, 0, 0);
    for (int i = 0; i < n; ++i) s = rotated(s, rotation(2 * M_PI / n));
    // n turns of rounding errors
    EXPECT_LT((s - symmetric(1, 0, 0)).cwiseAbs().maxCoeff(), 1e-10);
    EXPECT_NEAR(s.squaredNorm(), 1, 1e-10);
    EXPECT_NEAR(rotated(symmetric(1, 0, 0), rotation(M_PI / 2))(1, 1), 1, 1e-15);
    // The series for small angles and the functions give the same.
    const Matrix2d any = symmetric(3, 1, 0.5), small = rotated(any, rotation(0.01999)),
                   large = rotated(rotated(any, rotation(0.2)), rotation(-0.18001));
    EXPECT_LT((small - large).cwiseAbs().maxCoeff(), 1e-14);
}

TEST(Elasticity, ModuliOfTheFlumeMaterials) {
    const auto first = Elasticity::from_young_and_bulk(12e6, 23e6);
    EXPECT_NEAR(first.shear, 4.246e6, 1e3);
    EXPECT_NEAR(first.wave_speed(1700), 129.845, 1e-3);  // sqrt((23 + 4/3 * 4.24615) / 1700 * 1e6)
    EXPECT_NEAR(Elasticity::from_young_and_bulk(21.6e6, 13.8e6).wave_speed(1700), 122.3, 0.05);
    // Uniaxial strain: sigma_xx = K + 4 G / 3, sigma_yy = sigma_zz = K - 2 G / 3.
    const Stress s = first.increment(symmetric(1e-3, 0, 0));
    EXPECT_NEAR(s.xx(), 1e-3 * (first.bulk + 4 * first.shear / 3), 1e-6);
    EXPECT_NEAR(s.zz, 1e-3 * (first.bulk - 2 * first.shear / 3), 1e-6);
}

TEST(Fragmentation, CohesionIsLostInLineWithDistortion) {
    const Fragmentation law{0.05};
    EXPECT_EQ(law.cohesion_ratio(0), 1);
    EXPECT_DOUBLE_EQ(law.cohesion_ratio(0.025), 0.75);
    EXPECT_EQ(law.cohesion_ratio(0.1), 0);
    EXPECT_EQ(law.cohesion_ratio(0.2), 0);
    // Simple shear of rate 2 e: sqrt(2/3 * 2 e^2).
    EXPECT_DOUBLE_EQ(law.increment(symmetric(0, 0, 1)), std::sqrt(4.0 / 3));
}

}  // namespace
}  // namespace frana::structured::test
