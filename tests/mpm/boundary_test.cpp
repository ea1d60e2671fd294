// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "support/cases.h"

namespace frana::test {
namespace {

Flow slope_flow(Boundary boundary) {
    const GridSpec grid = bench::plain_grid(40, 30, 1);
    const Raster bed = bench::sample_raster(grid, [](Point p) { return 0.5 * (40 - p.x) + 0.1 * p.y; });
    const ParticleSet seeds = bench::fill_lattice(
        grid, 2, 0.3, [](Point p) { return bench::Seed{2 - 0.3 * std::hypot(p.x - 20, p.y - 15)}; });
    return Flow(bed, seeds, dry_friction(5), numerics(Scheme::standard, SlopeCorrection::normal, boundary), 1);
}

TEST(OpenBoundary, MaterialLeavesAndIsAccountedFor) {
    Flow flow = slope_flow(Boundary::open);
    const double before = flow.volume();
    flow.advance_to(20);
    EXPECT_GT(flow.volume_left(), 0.9 * before);
    EXPECT_NEAR(flow.volume() + flow.volume_left(), before, 1e-12 * before);
}

TEST(WallBoundary, KeepsEverythingAndSpeedsRemainBounded) {
    Flow flow = slope_flow(Boundary::wall);
    const double before = flow.volume();
    double deepest = 0, fastest = 0;
    while (flow.time() < 20) {
        const auto report = flow.advance(20 - flow.time());
        deepest = std::max(deepest, report.nodes.max_depth);
        fastest = std::max(fastest, report.nodes.max_speed);
        ASSERT_EQ(report.particles.non_finite, 0);
        ASSERT_EQ(report.particles.clamped, 0);
    }
    EXPECT_EQ(flow.volume_left(), 0);
    EXPECT_NEAR(flow.volume(), before, 1e-12 * before);
    // Free fall over the whole drop plus a dam break's front.
    EXPECT_LT(fastest, std::sqrt(2 * 9.81 * 25) + 2 * std::sqrt(9.81 * 2));
    EXPECT_LT(deepest, 10);
}

TEST(NoDataWall, RetainsTheFlow) {
    const GridSpec grid = bench::plain_grid(60, 20, 1);
    const Raster bed =
        bench::sample_raster(grid, [](Point p) { return p.x > 40 && p.x < 44 ? k_no_data : 0.3 * (60 - p.x); });
    const ParticleSet seeds =
        bench::fill_lattice(grid, 2, 0, [](Point p) { return bench::Seed{p.x > 5 && p.x < 15 ? 2.0 : 0.0}; });
    Numerics n = numerics(Scheme::standard, SlopeCorrection::normal, Boundary::wall);
    n.nodata = NodataPolicy::wall;
    Flow flow(bed, seeds, dry_friction(5), n, 1);
    flow.advance_to(15);
    for (std::size_t i = 0; i < flow.particles().size(); ++i) ASSERT_LT(flow.particles()[Field::x][i], 41);
}

}  // namespace
}  // namespace frana::test
