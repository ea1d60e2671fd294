// SPDX-License-Identifier: Apache-2.0
// U19 (Ritter) and U20 (Stoker): dam breaks on a flat bed against their exact solutions.
#include <gtest/gtest.h>

#include "basin.h"
#include "bench/exact/solutions.h"

namespace frana::structured::test {
namespace {

using bench::DamBreak;
using bench::plain_grid;

// A channel three cells wide, `half` metres long on either side of the dam, at `time` after the break.
Basin channel(double half, std::int64_t cells, double left, double right, double time, double dry, bool turned) {
    const double dx = 2 * half / static_cast<double>(cells);
    FluidLaws laws = still_laws();
    laws.dry = dry;
    Basin basin(Raster(turned ? plain_grid(3, cells, dx) : plain_grid(cells, 3, dx), 0.0), laws);
    basin.fill([&](Point p) { return Water{(turned ? p.y : p.x) < half ? left : right}; });
    basin.advance(time);
    return basin;
}

double error(const Basin& basin, double half, double left, double right, double time, bool turned) {
    const DamBreak exact(left, right);
    return basin.l1_depth([&](Point p) { return exact.at((turned ? p.y : p.x) - half, time).depth; });
}

// The numbers are those of the exact solutions that the errors are measured against.
TEST(FluidDamBreak, ExactSolutionsHaveTheSpecifiedStates) {
    const DamBreak wet(1, 0.1), shallow(0.005, 0.001), dry(1, 0);
    EXPECT_NEAR(wet.at(1, 1).depth, 0.396175, 1e-6);
    EXPECT_NEAR(wet.at(1, 1).velocity, 2.321355, 1e-6);
    EXPECT_NEAR(wet.front(1), 3.105134, 1e-6);
    EXPECT_NEAR(shallow.at(0.13, 1).depth, 0.00253936, 1e-8);
    EXPECT_NEAR(shallow.at(0.13, 1).velocity, 0.127280, 1e-6);
    EXPECT_NEAR(shallow.front(1), 0.209963, 1e-6);
    EXPECT_NEAR(dry.at(0, 1).depth, 4.0 / 9, 1e-12);
    EXPECT_NEAR(dry.at(0, 1).velocity, 2.0881, 1e-4);
    EXPECT_NEAR(dry.front(1), 6.264, 1e-3);
}

TEST(FluidDamBreak, RitterWithinTwoPercent) {
    for (const bool turned : {false, true}) {
        const Basin basin = channel(50, 400, 1, 0, 5, 1e-6, turned);
        EXPECT_LT(error(basin, 50, 1, 0, 5, turned), 0.02);
        // At the dam h = 4/9 and u = 2.0881 m/s for ever; the cells on its two sides, 1 %.
        const double depth = turned ? 0.5 * (basin.depth(1, 199) + basin.depth(1, 200))
                                    : 0.5 * (basin.depth(199, 1) + basin.depth(200, 1));
        EXPECT_NEAR(depth, 4.0 / 9, 0.01 * 4 / 9);
        if (turned) continue;
        EXPECT_NEAR(0.5 * (basin.u(199, 1) + basin.u(200, 1)), 2.0881, 0.01 * 2.0881);
    }
}

// Where the exact water is 1 cm deep (1 % of the dam); the place there of the computed water, between cell centres,
// behind it [cells].
double front_lag(const Basin& basin, std::int64_t cells, double half, double time) {
    constexpr double k_thin = 0.01;
    const double dx = 2 * half / static_cast<double>(cells);
    std::int64_t i = cells - 1;
    while (basin.depth(i, 1) < k_thin) --i;
    const double inside = basin.depth(i, 1), outside = basin.depth(i + 1, 1);
    const double place = (static_cast<double>(i) + 0.5 + (inside - k_thin) / (inside - outside)) * dx - half;
    return (time * (2 * std::sqrt(9.81) - 3 * std::sqrt(9.81 * k_thin)) - place) / dx;
}

// While the jump of the start is no wider than a cell or two, the scheme spreads it and the tip falls behind; it stays
// three to four and a half cells behind on every grid. A scheme whose front ran on at a wrong speed would be tens of
// cells off.
TEST(FluidDamBreak, RitterFrontLagsByFourCells) {
    for (const std::int64_t cells : {200, 400, 800}) {
        const double lag = front_lag(channel(50, cells, 1, 0, 5, 1e-6, false), cells, 50, 5);
        EXPECT_GT(lag, 0);
        EXPECT_LT(lag, 5) << cells << " cells";
    }
}

// A front that the grid resolves is where it should be: from the exact state at a tenth of the time on, the scheme
// loses less than half a cell.
TEST(FluidDamBreak, AResolvedFrontDoesNotLag) {
    const DamBreak exact(1, 0);
    for (const std::int64_t cells : {400, 800}) {
        FluidLaws laws = still_laws();
        laws.dry = 1e-6;
        Basin basin(Raster(plain_grid(cells, 3, 100 / static_cast<double>(cells)), 0.0), laws);
        basin.fill([&](Point p) {
            const bench::WaterState s = exact.at(p.x - 50, 0.5);
            return Water{s.depth, s.velocity};
        });
        basin.advance(4.5);
        EXPECT_NEAR(front_lag(basin, cells, 50, 5), 0, 0.5) << cells << " cells";
        EXPECT_LT(error(basin, 50, 1, 0, 5, false), 0.001);
    }
}

TEST(FluidDamBreak, StokerWithinTwoPercent) {
    EXPECT_LT(error(channel(50, 400, 1, 0.1, 6, 1e-6, false), 50, 1, 0.1, 6, false), 0.02);
    EXPECT_LT(error(channel(5, 400, 0.005, 0.001, 6, 1e-7, false), 5, 0.005, 0.001, 6, false), 0.02);
}

// The plateau behind the shock and the shock's place, as the solver has them: 1 m over 0.1 m, and 5 mm over 1 mm.
TEST(FluidDamBreak, StokerPlateauAndShock) {
    struct Wanted {
        double half, left, right, dry, time, depth, velocity, shock;
    };
    for (const Wanted& w : {Wanted{50, 1, 0.1, 1e-6, 6, 0.396175, 2.321355, 3.105134},
                            Wanted{5, 0.005, 0.001, 1e-7, 6, 0.00253936, 0.127280, 0.209963}}) {
        constexpr std::int64_t k_cells = 800;
        const Basin basin = channel(w.half, k_cells, w.left, w.right, w.time, w.dry, false);
        const double dx = 2 * w.half / k_cells;
        const auto cell = [&](double x) { return static_cast<std::int64_t>((w.half + x) / dx); };
        // Half way between the rarefaction's foot, (u - c) t, and the shock.
        const double foot = w.velocity - std::sqrt(9.81 * w.depth);
        const std::int64_t middle = cell(0.5 * (foot + w.shock) * w.time);
        EXPECT_NEAR(basin.depth(middle, 1), w.depth, 0.005 * w.depth);
        EXPECT_NEAR(basin.u(middle, 1), w.velocity, 0.005 * w.velocity);
        // The shock is where the depth is half way between those on its sides: within two cells.
        std::int64_t i = middle;
        while (basin.depth(i, 1) > 0.5 * (w.depth + w.right)) ++i;
        EXPECT_NEAR((static_cast<double>(i) * dx - w.half) / w.time, w.shock, 2 * dx / w.time);
    }
}

// A scheme of second order is of first order at a shock; the mark is 0.8.
TEST(FluidDamBreak, StokerConvergesWithOrderPointEight) {
    const auto at = [](std::int64_t cells) {
        return error(channel(50, cells, 1, 0.1, 6, 1e-6, false), 50, 1, 0.1, 6, false);
    };
    EXPECT_GT(0.5 * std::log2(at(100) / at(400)), 0.8);
}

TEST(FluidDamBreak, NoCellOverlooksAnotherAcross) {
    const Basin basin = channel(50, 200, 1, 0.1, 6, 1e-6, false);
    for (std::int64_t i = 0; i < 200; ++i) {
        EXPECT_EQ(basin.depth(i, 0), basin.depth(i, 1));
        EXPECT_EQ(basin.depth(i, 2), basin.depth(i, 1));
    }
}

}  // namespace
}  // namespace frana::structured::test
