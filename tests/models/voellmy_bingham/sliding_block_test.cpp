// SPDX-License-Identifier: Apache-2.0
// A wide uniform slab on a plane must accelerate in map view by g cos^2(theta) (tan theta - tan phi)
// (share/doc/model.md, "Unknowns"), and reach Voellmy's terminal speed. Only the slab's middle is compared: its edges
// collapse.
#include <gtest/gtest.h>

#include "physics/laws.h"
#include "support/cases.h"

namespace frana::test {
namespace {

// Returns the mean speed (map view) of particles in the middle of a slab 200 m long that started at rest at 20 m < x <
// 220 m.
double slab_speed(double slope_deg, const Material& material, SlopeCorrection slope, double jitter, double time,
                  double travelled) {
    const double gradient = std::tan(slope_deg * M_PI / 180);
    const std::int64_t columns = 300 + static_cast<std::int64_t>(travelled);
    const GridSpec grid = bench::plain_grid(columns, 12, 1);
    const Raster bed =
        bench::sample_raster(grid, [&](Point p) { return (static_cast<double>(columns) - p.x) * gradient; });
    const ParticleSet seeds =
        bench::fill_lattice(grid, 2, jitter, [](Point p) { return bench::Seed{p.x > 20 && p.x < 220 ? 1.0 : 0.0}; });
    Flow flow(bed, seeds, material, numerics(Scheme::standard, slope, Boundary::wall), 2);
    flow.advance_to(time);
    double sum = 0;
    int n = 0;
    const ParticleSet& p = flow.particles();
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (std::abs(p[Field::x][i] - 120 - travelled) > 20) continue;
        sum += flow.map_velocity(i).x;
        ++n;
    }
    return sum / n;
}

class SlidingBlock : public testing::TestWithParam<std::tuple<double, SlopeCorrection, double>> {};

TEST_P(SlidingBlock, AcceleratesAsARigidBlock) {
    const auto [slope_deg, slope, jitter] = GetParam();
    const double theta = slope_deg * M_PI / 180, phi = 20 * M_PI / 180, time = 4;
    const double cosine = std::cos(theta);
    const double exact = k_gravity * cosine * cosine * (std::tan(theta) - std::tan(phi)) * time;
    const double speed = slab_speed(slope_deg, dry_friction(20), slope, jitter, time, 0.5 * exact * time);
    EXPECT_NEAR(speed, exact, 1e-3 * exact);  // the limit of the accuracy bench
}

INSTANTIATE_TEST_SUITE_P(Slopes, SlidingBlock,
                         testing::Combine(testing::Values(25.0, 35.0, 45.0),
                                          testing::Values(SlopeCorrection::normal, SlopeCorrection::surface),
                                          testing::Values(0.0, 0.8)));

TEST(SlidingBlock, WithoutCorrectionItIsTooFastByTheSquaredSecant) {
    const double theta = 35 * M_PI / 180, phi = 20 * M_PI / 180, time = 4;
    const double gentle = k_gravity * (std::tan(theta) - std::tan(phi)) * time;
    EXPECT_NEAR(slab_speed(35, dry_friction(20), SlopeCorrection::none, 0, time, 0.5 * gentle * time), gentle,
                1e-3 * gentle);
}

// A pile 40 m thick slides over rough ground with Coulomb's friction alone: nothing that moves at 3/4 of the greatest
// speed or more has more energy than its fall from the highest point released to it, less friction on the shortest way,
//     v^2 / 2 <= g (Z_0 + h_0 - Z) - mu g distance.
// Where the pile starts its pressure may give more: by 0.4 % of the energy at its side, at half of the greatest speed.
TEST(SlidingBlock, IsNowhereFasterThanItsFallAllows) {
    constexpr double k_cell = 20, k_friction = 0.2;
    const GridSpec grid = bench::plain_grid(170, 60, k_cell);
    const Raster bed = bench::sample_raster(grid, [](Point p) {
        const double rough = 8 * std::sin(p.x / 31 + 0.7 * std::sin(p.y / 47)) * std::sin(p.y / 37) +
                             5 * std::sin(p.x / 19 - p.y / 23) + 10 * std::sin(p.x / 83 + 1.3) * std::cos(p.y / 71);
        return rough + (p.x < 1500 ? 0.65 * (1500 - p.x) : 0);
    });
    const auto pile = [](Point p) {
        return 40 * (1 - std::pow((p.x - 300) / 180, 2) - std::pow((p.y - 600) / 200, 2));
    };
    Flow flow(bed, bench::fill_lattice(grid, 2, 0, [&](Point p) { return bench::Seed{pile(p)}; }),
              dry_friction(std::atan(k_friction) * 180 / M_PI),
              numerics(Scheme::standard, SlopeCorrection::normal, Boundary::open), 1);
    flow.advance_to(60);
    const auto place = [&](std::int64_t row, std::int64_t column) {
        return grid.local_from_map(grid.cell_centre(row, column));
    };
    const auto for_cells = [&](const auto& visit) {
        for (std::int64_t row = 0; row < grid.rows; ++row)
            for (std::int64_t column = 0; column < grid.columns; ++column)
                visit(place(row, column), bed.at(row, column), flow.nodes().index(column, grid.rows - 1 - row));
    };
    double greatest = 0;
    for_cells(
        [&](Point, double, std::size_t node) { greatest = std::max(greatest, flow.maxima().speed.data()[node]); });
    EXPECT_GT(greatest, 50);
    int fast = 0;
    double most = 0;
    for_cells([&](Point at, double z, std::size_t node) {
        const double speed = flow.maxima().speed.data()[node];
        if (speed < 0.75 * greatest || pile(at) > 0) return;
        ++fast;
        double bound = 0;
        for_cells([&](Point from, double top, std::size_t) {
            if (pile(from) > 0)
                bound = std::max(bound, top + pile(from) - z - k_friction * std::hypot(at.x - from.x, at.y - from.y));
        });
        most = std::max(most, 0.5 * speed * speed / (k_gravity * bound));
    });
    EXPECT_LE(most, 1);
    EXPECT_GT(fast, 300);
}

// g sin(theta) = g cos(theta) tan(phi) + g v^2 / (xi d) along the bed, d = h cos(theta); map speed v
// cos(theta).
TEST(VoellmyPlane, ReachesTheTerminalSpeed) {
    const double theta = 30 * M_PI / 180, phi = 15 * M_PI / 180, turbulence = 300;
    Material material = dry_friction(15);
    material.of<TurbulentFriction>().turbulence = turbulence;
    const double thickness = 1 * std::cos(theta);
    const double along = std::sqrt(turbulence * thickness * (std::sin(theta) - std::cos(theta) * std::tan(phi)));
    const double map_speed = along * std::cos(theta);
    // Approach: dv/dt = a (1 - v^2 / v_t^2), so v = v_t tanh(a t / v_t); after 20 s 1 - tanh < 1e-5.
    const double a = k_gravity * (std::sin(theta) - std::cos(theta) * std::tan(phi));
    const double time = 20, reached = along * std::tanh(a * time / along);
    ASSERT_GT(reached / along, 1 - 1e-5);
    const double distance = along * along / a * std::log(std::cosh(a * time / along)) * std::cos(theta);
    const double speed = slab_speed(30, material, SlopeCorrection::normal, 0, time, distance);
    EXPECT_NEAR(speed, map_speed, 1e-3 * map_speed);
}

}  // namespace
}  // namespace frana::test
