// SPDX-License-Identifier: Apache-2.0
// A mass whose driving force is below the friction bound remains exactly at rest: not one bit of any position changes.
#include <gtest/gtest.h>

#include "support/cases.h"

namespace frana::test {
namespace {

// A cone 3 m high and 30 m in radius (surface slope 5.7 degrees) on a plane, friction angle 30 degrees.
class RestingPile : public testing::TestWithParam<std::tuple<double, double, Scheme>> {};

TEST_P(RestingPile, DoesNotMoveByOneBit) {
    const auto [slope_deg, jitter, scheme] = GetParam();
    const double gradient = std::tan(slope_deg * M_PI / 180);
    const GridSpec grid = bench::plain_grid(100, 100, 1);
    const Raster bed = bench::sample_raster(grid, [&](Point p) { return (100 - p.x) * gradient; });
    const ParticleSet seeds = bench::fill_lattice(
        grid, 2, jitter, [](Point p) { return bench::Seed{3 - 0.1 * std::hypot(p.x - 50, p.y - 50)}; });
    const SlopeCorrection slope = scheme == Scheme::paper ? SlopeCorrection::none : SlopeCorrection::normal;
    Flow flow(bed, seeds, dry_friction(30), numerics(scheme, slope, Boundary::open), 1);
    std::vector<double> x(flow.particles()[Field::x], flow.particles()[Field::x] + flow.particles().size());
    flow.advance_to(60);
    ASSERT_EQ(flow.particles().size(), x.size());
    EXPECT_EQ(greatest_speed(flow), 0);
    for (std::size_t i = 0; i < x.size(); ++i) ASSERT_EQ(flow.particles()[Field::x][i], x[i]);
}

INSTANTIATE_TEST_SUITE_P(All, RestingPile,
                         testing::Combine(testing::Values(0.0, 10.0, 20.0), testing::Values(0.0, 0.8),
                                          testing::Values(Scheme::standard, Scheme::paper)));

TEST(MovingPile, SlidesAboveTheFrictionAngleAndStopsOnTheFlat) {
    const GridSpec grid = bench::plain_grid(160, 60, 1);
    const double gradient = std::tan(30 * M_PI / 180);
    const Raster bed = bench::sample_raster(grid, [&](Point p) { return p.x < 60 ? (60 - p.x) * gradient : 0; });
    const ParticleSet seeds =
        bench::fill_lattice(grid, 2, 0, [](Point p) { return bench::Seed{2 - 0.2 * std::hypot(p.x - 25, p.y - 30)}; });
    Flow flow(bed, seeds, dry_friction(20), numerics(Scheme::standard, SlopeCorrection::normal, Boundary::open), 1);
    const double start = flow.centroid().x;
    flow.advance_to(60);
    EXPECT_EQ(greatest_speed(flow), 0) << "friction must stop the mass, not leave it creeping";
    EXPECT_GT(flow.centroid().x, start + 20);
    EXPECT_EQ(flow.volume_left(), 0);
}

}  // namespace
}  // namespace frana::test
