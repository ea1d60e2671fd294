// SPDX-License-Identifier: Apache-2.0
// Erosion, deposition, detrainment: rates against their closed forms, budgets of mass and momentum to rounding.
#include <gtest/gtest.h>

#include "physics/erosion_mechanical.h"
#include "physics/erosion_shear_stress.h"
#include "physics/laws.h"
#include "simulation/finite_volume_flow.h"
#include "support/cases.h"

namespace frana::test {
namespace {

constexpr double k_exchanged_density = 2000;

double momentum_x(const Flow& flow) {
    double sum = 0;
    const ParticleSet& p = flow.particles();
    for (std::size_t i = 0; i < p.size(); ++i) sum += p[Field::volume][i] * p[Field::u][i];
    return sum;
}

double sum_of(const Raster& raster) {
    double sum = 0;
    for (const double value : raster.values) sum += std::isnan(value) ? 0 : value;
    return sum;
}

Raster depths(const Flow& flow, const char* name) {
    RunResult result;
    flow.add_to(result);
    return result.raster(name);
}

// A sheet 1 m thick at 5 m/s on flat ground, with so little gravity that nothing accelerates it.
Flow drifting_sheet(const Entrainment& entrainment, Scheme scheme = Scheme::standard) {
    const GridSpec grid = bench::plain_grid(120, 20, 1);
    const ParticleSet seeds = bench::fill_lattice(grid, 2, 0.5, [](Point p) {
        return bench::Seed{p.x > 20 && p.x < 60 && p.y > 5 && p.y < 15 ? 1.0 : 0, 5, 0};
    });
    Material material = water();
    material.density = k_exchanged_density;
    Numerics how = numerics(scheme, SlopeCorrection::normal, Boundary::open);
    how.gravity = 1e-12;
    how.curvature = false;  // deposited material would deflect the motion
    return Flow(Raster(grid), seeds, material, how, 2, std::nullopt, {}, entrainment);
}

class Growth : public testing::TestWithParam<Scheme> {};

TEST_P(Growth, IsExponentialInTheDistanceAndConservesMassAndMomentum) {
    Entrainment e;
    e.erosion = "growth";
    e.of<GrowthErosion>().growth_rate = 5e-3;
    e.erodible_depth = 10;
    Flow flow = drifting_sheet(e, GetParam());
    const double volume = flow.volume(), momentum = momentum_x(flow), start = flow.centroid().x;
    flow.advance_to(6);
    const double now = flow.volume();
    EXPECT_NEAR(now, volume + flow.exchanged().eroded, 1e-12 * now);
    EXPECT_NEAR(sum_of(depths(flow, "eroded_depth")), flow.exchanged().eroded, 1e-12 * now);
    EXPECT_NEAR(momentum_x(flow), momentum, 1e-12 * momentum) << "what is taken up is at rest";
    // V = V_0 exp(E S), for the uniform sheet's mean distance; the step is of first order.
    const double exact = volume * std::exp(*e.of<GrowthErosion>().growth_rate * (flow.centroid().x - start));
    EXPECT_GT(exact, 1.05 * volume);
    EXPECT_NEAR(now - volume, exact - volume, 0.02 * (exact - volume));
}

INSTANTIATE_TEST_SUITE_P(Schemes, Growth, testing::Values(Scheme::standard, Scheme::paper));

TEST(Growth, EndsWithTheErodibleLayer) {
    Entrainment e;
    e.erosion = "growth";
    e.of<GrowthErosion>().growth_rate = 0.5;
    e.erodible_depth = 0.03;
    Flow flow = drifting_sheet(e);
    flow.advance_to(4);
    double deepest = 0;
    for (const double depth : depths(flow, "eroded_depth").values)
        deepest = std::max(deepest, std::isnan(depth) ? 0 : depth);
    EXPECT_NEAR(deepest, 0.03, 1e-15);
    EXPECT_NEAR(flow.volume(), 400 + flow.exchanged().eroded, 1e-12 * 400);
}

// A wide slab that slides steadily in a tilted frame: friction equals the driving force, so the stress at the bed is
// rho d g_x.
struct SteadySlab {
    double eroded, deposited, speed;
};
SteadySlab steady_slab(const Entrainment& entrainment, double along, double speed, double time,
                       const MaterialZones& zones = {}) {
    const GridSpec grid = bench::plain_grid(120, 8, 1);
    const ParticleSet seeds = bench::fill_lattice(grid, 2, 0, [&](Point p) {
        return bench::Seed{p.x > 10 && p.x < 110 ? 1.0 : 0, speed, 0};
    });
    Material material = water();
    material.density = k_exchanged_density;
    material.of<CoulombFriction>().friction_coefficient = along / 9;
    Flow flow(Raster(grid), seeds, material, numerics(Scheme::standard, SlopeCorrection::normal, Boundary::wall), 1,
              TiltedGravity{along, 0, 9}, zones, entrainment);
    flow.advance_to(time);
    const Raster eroded = depths(flow, "eroded_depth"), deposited = depths(flow, "deposited_depth");
    SteadySlab slab{0, 0, 0};
    for (std::int64_t c = 55; c < 65; ++c) {
        slab.eroded += std::isnan(eroded.at(4, c)) ? 0 : eroded.at(4, c) / 10;
        slab.deposited += std::isnan(deposited.at(4, c)) ? 0 : deposited.at(4, c) / 10;
    }
    const double sum = 100 * 8 + flow.exchanged().eroded - flow.exchanged().deposited;
    EXPECT_NEAR(flow.volume(), sum, 1e-12 * sum);
    slab.speed = momentum_x(flow) / flow.volume();
    return slab;
}

TEST(ShearStressErosion, ErodesAtItsRateDownToItsPotentialDepth) {
    Entrainment e;
    e.erosion = "shear-stress";
    e.erodible_depth = 5;
    e.of<ShearStressErosion>().critical_shear = 2000;
    // tau = 2000 kg/m3 x 1 m x 2 m/s2 = 4 kPa: 2 kPa above the critical stress.
    EXPECT_NEAR(steady_slab(e, 2, 4, 1).eroded, 0.025, 0.01 * 0.025);
    e.of<ShearStressErosion>().erosion_depth_per_kpa =
        0.01;  // 0.02 m for 2 kPa, and 0.01 m for each kPa added by the growing slab
    const double depth = steady_slab(e, 2, 4, 3).eroded;
    EXPECT_NEAR(depth, 0.02 / (1 - 1e-5 * k_exchanged_density * 2), 0.01 * 0.02);
    e.of<ShearStressErosion>().critical_shear = 4500;
    EXPECT_EQ(steady_slab(e, 2, 4, 1).eroded, 0);
}

TEST(MechanicalErosion, IsTheExcessOfStressOverMomentum) {
    Entrainment e;
    e.erosion = "mechanical";
    e.erodible_depth = 5;
    e.of<MechanicalErosion>().bed_friction_angle = std::atan(0.1) * 180 / M_PI;
    e.of<MechanicalErosion>().bed_cohesion = 500;
    e.of<MechanicalErosion>().bed_pore_pressure_ratio = 0.2;
    // Strength 500 + 0.8 x 18000 x 0.1 = 1940 Pa; the rate increases with the slab and as it slows down: a short time.
    const double rate = (4000 - 1940) / (k_exchanged_density * 4), time = 0.05;
    EXPECT_NEAR(steady_slab(e, 2, 4, time).eroded, rate * time, 0.03 * rate * time);
}

TEST(ErosionLaws, DoNothingAtZeroDepthOrSpeed) {
    const BedContact nothing{0, 0, 0, 0, 0, 0.1}, still{2, 0, 5000, 30000, 0, 0.1};
    EXPECT_EQ(ShearStressErosion{}(nothing), 0);
    EXPECT_EQ(ShearStressErosion{}(still), 0);
    EXPECT_EQ(MechanicalErosion{}(nothing), 0);
    EXPECT_EQ(MechanicalErosion{}(still), 0);
}

TEST(Deposition, SettlesAtItsRateWhereStressIsBelowCapacity) {
    Entrainment e;
    e.deposition = true;
    e.of<ShearStressDeposition>().deposition_rate = 0.02;
    e.of<ShearStressDeposition>().deposition_shear = 5000;
    // At rest on level ground: tau = 0, the full rate.
    EXPECT_NEAR(steady_slab(e, 0, 0, 5).deposited, 0.02 * 5, 1e-9);
    // Sliding: tau = rho d g_x decreases with the slab's thickness, d' = -w (1 - rho d g_x / tau_d).
    const double k = 0.02 * k_exchanged_density * 2 / 5000, limit = 5000 / (k_exchanged_density * 2);
    const double thickness = limit + (1 - limit) * std::exp(k * 4);
    EXPECT_NEAR(steady_slab(e, 2, 4, 4).deposited, 1 - thickness, 0.01 * (1 - thickness));
    e.of<ShearStressDeposition>().deposition_shear = 3500;
    EXPECT_EQ(steady_slab(e, 2, 4, 1).deposited, 0);
}

TEST(Deposition, RemovesItsMomentum) {
    Entrainment e;
    e.deposition = true;
    e.of<ShearStressDeposition>().deposition_rate = 0.05;
    e.of<ShearStressDeposition>().deposition_shear = 1000;
    Flow flow = drifting_sheet(e);
    const double volume = flow.volume(), momentum = momentum_x(flow);
    flow.advance_to(4);
    EXPECT_GT(flow.exchanged().deposited, 0.1 * volume);
    EXPECT_NEAR(flow.volume(), volume - flow.exchanged().deposited, 1e-12 * volume);
    EXPECT_NEAR(momentum_x(flow), momentum - flow.exchanged().momentum_x, 1e-12 * momentum);
    EXPECT_NEAR(sum_of(depths(flow, "deposited_depth")), flow.exchanged().deposited, 1e-12 * volume);
}

TEST(Deposition, IsNeverCompleteSoThatParticlesKeepAVolume) {
    Entrainment e;
    e.deposition = true;
    e.of<ShearStressDeposition>().deposition_rate = 10;
    e.of<ShearStressDeposition>().deposition_shear = 1000;
    Flow flow = drifting_sheet(e);
    flow.advance_to(5);
    const ParticleSet& p = flow.particles();
    for (std::size_t i = 0; i < p.size(); ++i) ASSERT_GT(p[Field::volume][i], 0);
    EXPECT_LT(flow.volume(), 10);
}

TEST(BedExchange, ErodibleDepthByZones) {
    Entrainment e;
    e.erosion = "shear-stress";
    e.erodible_depth = 0;
    MaterialZones zones;
    zones.erodible_depth = Raster(bench::plain_grid(120, 8, 1), k_no_data);
    EXPECT_EQ(steady_slab(e, 2, 4, 1, zones).eroded, 0);
    for (std::int64_t c = 50; c < 70; ++c) zones.erodible_depth->at(4, c) = 0.01;
    EXPECT_NEAR(steady_slab(e, 2, 4, 1, zones).eroded, 0.01, 1e-15);
}

Entrainment forest(double coefficient) {
    Entrainment e;
    e.detrainment = true;
    e.of<ForestDetrainment>().detrainment_coefficient = coefficient;
    return e;
}

// At a steady speed the sheet loses K / (rho s) t of its height: 400 Pa / (2000 kg/m3 x 4 m/s) = 0.05 m/s.
TEST(Detrainment, TakesHeightLinearlyInTimeAtASteadySpeed) {
    for (const double time : {1.0, 2.0, 4.0}) {
        const SteadySlab slab = steady_slab(forest(400), 0, 4, time);
        EXPECT_NEAR(slab.deposited, 0.05 * time, 1e-9);
        EXPECT_EQ(slab.eroded, 0);
    }
}

TEST(Detrainment, IsWhereForestStandsAlone) {
    MaterialZones zones;
    zones.detrainment_coefficient = Raster(bench::plain_grid(120, 8, 1), k_no_data);
    Entrainment e = forest(0);
    EXPECT_EQ(steady_slab(e, 0, 4, 1, zones).deposited, 0);
    for (std::int64_t r = 0; r < 8; ++r)
        for (std::int64_t c = 60; c < 120; ++c) zones.detrainment_coefficient->at(r, c) = 400;
    EXPECT_NEAR(steady_slab(e, 0, 4, 1, zones).deposited, 0.5 * 0.05, 1e-3) << "half of the ten cells";
    e.of<ForestDetrainment>().detrainment_coefficient.reset();
    EXPECT_NEAR(steady_slab(e, 0, 4, 1, zones).deposited, 0.5 * 0.05, 1e-3) << "no other value than the zones'";
}

// The rate is that of the thickness normal to the bed, the speed that along it: on a plane, where friction balances the
// fall, the vertical depth decreases by K / (rho u), u in map view.
template <class Model>
void expect_rate_on_plane(Scheme scheme) {
    const double fall = 0.5, u = 6, time = 2;
    const GridSpec grid = bench::plain_grid(120, 8, 1);
    const Raster bed = bench::sample_raster(grid, [&](Point p) { return fall * (120 - p.x); });
    const ParticleSet seeds = bench::fill_lattice(grid, 2, 0, [&](Point p) {
        return bench::Seed{p.x > 10 && p.x < 110 ? 1.0 : 0, u, 0};
    });
    Material material = water();
    material.density = k_exchanged_density;
    material.of<CoulombFriction>().friction_coefficient = fall;
    Numerics how = numerics(scheme, SlopeCorrection::normal, Boundary::wall);
    how.curvature = false;
    std::unique_ptr<Model> flow;
    if constexpr (std::is_same_v<Model, Flow>)
        flow = std::make_unique<Flow>(bed, seeds, material, how, 1, std::nullopt, MaterialZones{}, forest(600));
    else
        flow = std::make_unique<Model>(bed, std::nullopt, seeds, material, how, 1, MaterialZones{}, forest(600));
    const double start = flow->volume();
    flow->advance_to(time);
    RunResult result;
    flow->add_to(result);
    const double exact = 600 / (k_exchanged_density * u) * time;
    for (std::int64_t c = 60; c < 65; ++c) EXPECT_NEAR(result.raster("deposited_depth").at(4, c), exact, 5e-3 * exact);
    EXPECT_NEAR(flow->volume() + flow->volume_left(), start - result.volume_deposited, 1e-12 * start);
    EXPECT_NEAR(result.volume_detrained, result.volume_deposited, 1e-12 * start);
}

TEST(Detrainment, IsPerAreaOfTheBed) {
    expect_rate_on_plane<Flow>(Scheme::standard);
    expect_rate_on_plane<FiniteVolumeFlow>(Scheme::finite_volume);
}

TEST(Detrainment, RemovesItsMomentumAndLeavesTheSpeed) {
    Flow flow = drifting_sheet(forest(1000));
    const double volume = flow.volume(), momentum = momentum_x(flow);
    flow.advance_to(4);
    EXPECT_GT(flow.exchanged().deposited, 0.3 * volume);
    EXPECT_NEAR(flow.volume(), volume - flow.exchanged().deposited, 1e-12 * volume);
    EXPECT_NEAR(momentum_x(flow), momentum - flow.exchanged().momentum_x, 1e-12 * momentum);
    EXPECT_NEAR(momentum_x(flow) / flow.volume(), 5, 1e-9);
}

// What forest holds is not eroded again, though the law of erosion may take what deposition has left.
TEST(Detrainment, ActsBesideErosionAndIsKept) {
    Entrainment e = forest(1000);
    e.erosion = "growth";
    e.of<GrowthErosion>().growth_rate = 5e-3;
    e.erodible_depth = 0;
    Flow none = drifting_sheet(e);
    none.advance_to(2);
    EXPECT_EQ(none.exchanged().eroded, 0);
    EXPECT_GT(none.exchanged().deposited, 1);
    e.erodible_depth = 5;
    Flow flow = drifting_sheet(e);
    const double volume = flow.volume(), momentum = momentum_x(flow);
    flow.advance_to(2);
    const ExchangeReport& both = flow.exchanged();
    EXPECT_GT(both.eroded, 1);
    EXPECT_GT(both.deposited, 1);
    EXPECT_NEAR(flow.volume(), volume + both.eroded - both.deposited, 1e-12 * volume);
    EXPECT_NEAR(momentum_x(flow), momentum - both.momentum_x, 1e-12 * momentum);
}

// Towards speed zero the rate has no bound; particles keep a volume. What does not move stays.
TEST(Detrainment, HoldsWhatCreepsAndLeavesWhatLies) {
    Flow flow = drifting_sheet(forest(1e4));
    flow.advance_to(5);
    const ParticleSet& p = flow.particles();
    for (std::size_t i = 0; i < p.size(); ++i) ASSERT_GT(p[Field::volume][i], 0);
    EXPECT_LT(flow.volume(), 10);
    EXPECT_EQ(steady_slab(forest(1e4), 0, 0, 1).deposited, 0);
}

}  // namespace
}  // namespace frana::test
