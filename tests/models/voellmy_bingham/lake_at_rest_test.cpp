// SPDX-License-Identifier: Apache-2.0
// Lake at rest, equations (42)-(43) and Table 1 of the paper: h + Z = 10 m on [0,10]^2, 50 x 50 cells, 4 particles per
// cell, walls, 1 s. The still-water depth is not specified: the scheme computes its own level. The limit is rounding:
// 1e-12, a hundred times the spacing of doubles at 10 m times some hundred steps.
#include <gtest/gtest.h>

#include "physics/laws.h"
#include "support/cases.h"

namespace frana::test {
namespace {

struct Lake {
    const char* name;
    double (*bed)(double x, double y);
};

double bump(double x, double y) {
    return 5 * std::exp(-0.4 * ((x - 5) * (x - 5) + (y - 5) * (y - 5)));
}
double step(double x, double y) {
    return x >= 4 && x <= 8 && y >= 4 && y <= 8 ? 4 : 0;
}
double island(double x, double y) {
    return 13 * std::exp(-0.4 * ((x - 5) * (x - 5) + (y - 5) * (y - 5)));
}
double rough(double x, double y) {
    return 3 + 2 * std::sin(31 * x) * std::cos(37 * y);
}

constexpr Lake k_lakes[] = {{"Z1", bump}, {"Z2", step}, {"island", island}, {"rough", rough}};

class LakeAtRestOver : public testing::TestWithParam<std::tuple<int, double, bool, SlopeCorrection>> {};

TEST_P(LakeAtRestOver, RemainsStill) {
    const auto [which, jitter, friction, slope] = GetParam();
    const Lake& lake = k_lakes[which];
    const GridSpec grid = bench::plain_grid(50, 50, 0.2);
    const Raster bed = bench::sample_raster(grid, [&](Point p) { return lake.bed(p.x, p.y); });
    const auto elevation = spline_bed(bed, Boundary::wall);
    const ParticleSet seeds =
        bench::fill_lattice(grid, 2, jitter, [&](Point p) { return bench::Seed{10 - elevation(p)}; });
    Material material = water();
    if (friction) {  // the paper's set
        material.density = 1200;
        material.of<CoulombFriction>().friction_coefficient = std::tan(20 * M_PI / 180);
        material.of<TurbulentFriction>().turbulence = 200;
        material.of<BinghamStress>().viscosity = 2e3;
        material.of<BinghamStress>().yield_stress = 30;
    }
    Flow flow(bed, seeds, material, numerics(Scheme::standard, slope, Boundary::wall), 1);
    const Flow::NodalFields before = flow.nodal_fields();
    flow.advance_to(1);
    const Flow::NodalFields after = flow.nodal_fields();
    double depth = 0, momentum = 0;
    for (std::size_t i = 0; i < after.depth.values.size(); ++i) {
        depth = std::max(depth, std::abs(after.depth.values[i] - before.depth.values[i]));
        momentum = std::max({momentum, std::abs(after.momentum_x.values[i]), std::abs(after.momentum_y.values[i])});
    }
    EXPECT_LT(depth, 1e-12) << lake.name;
    EXPECT_LT(momentum, 1e-12) << lake.name;
    EXPECT_GT(flow.steps(), friction ? 500 : 20);
}

// Hills and valleys that curve within a few cells: a node distinguishes a shore from a free front by the fraction of
// its cells' area under water, which the plane through its neighbours gives to some percent of a cell. Not all lakes
// remain still: where the ground is rougher than that, some shores are treated as fronts.
TEST(LakeAtRest, RemainsStillAtMostIrregularShorelines) {
    int still = 0;
    for (int k = 0; k < 40; ++k) {
        const GridSpec grid = bench::plain_grid(24, 24, 20);
        const Raster bed = bench::sample_raster(grid, [&](Point p) {
            const double turn = 0.7 * k;
            const double x = std::cos(turn) * p.x - std::sin(turn) * p.y,
                         y = std::sin(turn) * p.x + std::cos(turn) * p.y;
            return 30 * std::sin(x / 70 + k) + 30 * std::sin(y / 50 + 2 * k);
        });
        const auto elevation = spline_bed(bed, Boundary::wall);
        const ParticleSet seeds =
            bench::fill_lattice(grid, 2, 0, [&](Point p) { return bench::Seed{5 - elevation(p)}; });
        Flow flow(bed, seeds, water(), numerics(Scheme::standard, SlopeCorrection::normal, Boundary::wall), 1);
        flow.advance_to(1);
        still += greatest_speed(flow) < 1e-11;  // 60 m of water, some ten steps
    }
    EXPECT_GE(still, 36);  // 31 when the flooded area was assumed to be known exactly
}

// The purpose of the reference level: without it the same lake starts to move.
TEST(LakeAtRest, MovesWithoutTheReferenceLevel) {
    const GridSpec grid = bench::plain_grid(50, 50, 0.2);
    const Raster bed = bench::sample_raster(grid, [](Point p) { return bump(p.x, p.y); });
    const auto elevation = spline_bed(bed, Boundary::wall);
    const ParticleSet seeds = bench::fill_lattice(grid, 2, 0, [&](Point p) { return bench::Seed{10 - elevation(p)}; });
    Numerics n = numerics(Scheme::standard, SlopeCorrection::none, Boundary::wall);
    n.well_balanced = false;
    Flow flow(bed, seeds, water(), n, 1);
    flow.advance_to(1);
    EXPECT_GT(greatest_speed(flow), 1e-6);
    EXPECT_LT(greatest_speed(flow), 1);
}

const auto k_slopes = testing::Values(SlopeCorrection::none, SlopeCorrection::normal);
INSTANTIATE_TEST_SUITE_P(Water, LakeAtRestOver,
                         testing::Combine(testing::Range(0, 4), testing::Values(0.0, 0.8), testing::Values(false),
                                          k_slopes));
INSTANTIATE_TEST_SUITE_P(Mud, LakeAtRestOver,
                         testing::Combine(testing::Range(0, 4), testing::Values(0.8), testing::Values(true), k_slopes));

}  // namespace
}  // namespace frana::test
