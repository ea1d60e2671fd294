// SPDX-License-Identifier: Apache-2.0
// Frictionless dam breaks in a 1000 m channel, 20 s, against Stoker and Ritter (bench/dam_break.h). The bounds are the
// values of the method's initial study (0.028 / 0.016 m wet, 0.022 / 0.011 m dry at 200 / 400 cells), with a margin of
// a quarter; they are no worse than finite-volume codes of second order within a factor 1.5.
#include <gtest/gtest.h>

#include "bench/exact/dam_break.h"
#include "support/cases.h"

namespace frana::test {
namespace {

// Mean |h - exact| [m].
double depth_error(std::int64_t columns, double right, Scheme scheme, double jitter = 0) {
    const double dx = 1000.0 / static_cast<double>(columns);
    const GridSpec grid = bench::plain_grid(columns, 4, dx);
    const Raster bed = bench::sample_raster(grid, [](Point) { return 0.0; });
    const ParticleSet seeds =
        bench::fill_lattice(grid, 2, jitter, [&](Point p) { return bench::Seed{p.x < 500 ? 10 : right}; });
    Flow flow(bed, seeds, water(), numerics(scheme, SlopeCorrection::none, Boundary::wall), 1);
    flow.advance_to(20);
    const bench::DamBreak exact(10, right);
    const Flow::NodalFields fields = flow.nodal_fields();
    double error = 0;
    for (std::int64_t row = 0; row < grid.rows; ++row) {
        for (std::int64_t column = 0; column < columns; ++column) {
            const double x = grid.cell_centre(row, column).x - 500;
            error += std::abs(fields.depth.at(row, column) - exact.at(x, 20).depth);
        }
    }
    return error / static_cast<double>(grid.cell_count());
}

// The errors of the table in share/doc/numerics.md, "What is known about the error"; 5 % for other compilers' rounding.
constexpr double k_measured = 1.05;

TEST(DamBreak, StokerConverges) {
    const double coarse = depth_error(200, 2, Scheme::standard), fine = depth_error(400, 2, Scheme::standard);
    EXPECT_LT(coarse, k_measured * 0.0352);
    EXPECT_LT(fine, k_measured * 0.0179);
    EXPECT_LT(fine, 0.62 * coarse);  // order 0.7 at least
}

TEST(DamBreak, RitterConverges) {
    const double coarse = depth_error(200, 0, Scheme::standard), fine = depth_error(400, 0, Scheme::standard);
    EXPECT_LT(coarse, k_measured * 0.0182);
    EXPECT_LT(fine, k_measured * 0.0090);
    EXPECT_LT(fine, 0.62 * coarse);
}

// Particles displaced by up to 0.4 of their spacing, as after a flow: without shifting their errors are 1.9 and 2.2
// times the lattice's here, with it 1.36 and 1.29; with a margin of a tenth.
TEST(DamBreak, IrregularParticlesCostLittle) {
    constexpr double k_jitter = 0.8;
    EXPECT_LT(depth_error(200, 2, Scheme::standard, k_jitter), 1.5 * depth_error(200, 2, Scheme::standard));
    EXPECT_LT(depth_error(200, 0, Scheme::standard, k_jitter), 1.45 * depth_error(200, 0, Scheme::standard));
}

// The published scheme is kept as published: it is known not to converge (share/doc/numerics.md, "What is known about
// the error").
TEST(DamBreak, PaperSchemeDoesNotConverge) {
    EXPECT_GT(depth_error(400, 0, Scheme::paper), depth_error(200, 0, Scheme::paper));
}

TEST(DamBreakExact, StokerMiddleStateSatisfiesBothRelations) {
    const bench::DamBreak exact(10, 2);
    const bench::WaterState middle = exact.at(0.5 * exact.front(1), 1);
    const double g = 9.81;
    EXPECT_NEAR(middle.velocity, 2 * (std::sqrt(g * 10) - std::sqrt(g * middle.depth)), 1e-12);
    EXPECT_NEAR(middle.velocity, (middle.depth - 2) * std::sqrt(0.5 * g * (middle.depth + 2) / (middle.depth * 2)),
                1e-9);
}

}  // namespace
}  // namespace frana::test
