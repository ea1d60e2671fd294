// SPDX-License-Identifier: Apache-2.0
// Blocks that their own weight breaks: what the vertical load, which is given, makes of strength.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <numeric>
#include <string>
#include <tuple>

#include "solid_cases.h"

namespace frana::structured::test {
namespace {

struct Spread {
    double area = 0;      // of cells ever deeper than 0.1 m [m2]
    double deepest = 0;   // at the end [m]
    double confined = 0;  // at the end [m3]
};

/// A slope that ends on 5 degrees, or, up to 5 degrees, a plain.
Raster hillside(double slope_deg) {
    const double foot_deg = std::min(slope_deg, 5.0);
    return bench::sample_raster(bench::plain_grid(90, 50, 10), [=](Point p) {
        return 200 + (350 - p.x) * std::tan((p.x < 350 ? slope_deg : foot_deg) * k_degree);
    });
}

// A block, 8 m thick and 100 m x 80 m, friction 20 degrees at the bed; cells of 10 m, 40 s. It is dry, or half of it is
// water: confined or, without cohesion, free from the start.
Spread slide_off(double cohesion, double slope_deg, bool wet = false) {
    ThreadPool pool(1);
    Case c(10);
    c.material.cohesion = cohesion;
    c.material.bed_friction = std::tan(20 * k_degree);
    const bool is_free = wet && cohesion == 0;
    c.material.solid_fraction = wet ? 0.5 : 1;
    c.fill(50, 210, 30, 24, [](Point) { return bench::Seed{8}; });
    State state = c.start(hillside(slope_deg), pool, wet);
    if (is_free) {
        std::vector<FluidSource> water;
        for (std::int64_t row = 21; row < 29; ++row)
            for (std::int64_t column = 5; column < 15; ++column)
                water.push_back({state.grid.index(column, row), 4, 0, 0});
        receive(water, *state.fluid, c.laws.fluid);
    }
    std::vector<bool> touched(state.solid->nodes.depth.size(), false);
    Spread spread;
    for (double t = 0.5; t < 40.1; t += 0.5) {
        advance_to(state, c.laws, t, pool);
        spread.deepest = 0;
        for (std::size_t n = 0; n < touched.size(); ++n) {
            const double depth = state.solid->nodes.depth[n] + (wet ? state.fluid->now.depth[n] : 0);
            spread.deepest = std::max(spread.deepest, depth);
            if (depth > 0.1 && !touched[n]) {
                touched[n] = true;
                spread.area += 100;
            }
        }
    }
    if (const double* confined = state.solid->particles[Field::confined]; wet && !is_free)
        spread.confined = std::accumulate(confined, confined + state.solid->particles.size(), 0.0);
    return spread;
}

// The limit of small cohesion is that of none, on any slope.
class OnePascal : public ::testing::TestWithParam<double> {};

TEST_P(OnePascal, IsNearlyNone) {
    const Spread none = slide_off(0, GetParam()), little = slide_off(1, GetParam());
    RecordProperty("area_of_none", std::to_string(none.area));
    RecordProperty("area_over_that_of_none", std::to_string(little.area / none.area));
    RecordProperty("depth_over_that_of_none", std::to_string(little.deepest / none.deepest));
    EXPECT_NEAR(little.area, none.area, 0.1 * none.area);
    EXPECT_NEAR(little.deepest, none.deepest, 0.1 * none.deepest);
}

INSTANTIATE_TEST_SUITE_P(Slopes, OnePascal, ::testing::Values(0, 35));

// Its water is held only as far as its strength bears the weight.
TEST(OnePascalWithWater, HoldsNone) {
    for (const double slope_deg : {0, 35}) {
        const auto of = [&](double cohesion) { return slide_off(cohesion, slope_deg, true); };
        const Spread none = of(0), little = of(1);
        EXPECT_NEAR(little.area, none.area, 0.1 * none.area) << slope_deg;
        EXPECT_LT(little.confined, 1e-4 * 4 * 8000);  // 2 q / N = 4e-5 at the start
    }
}

// A column of 10 kPa, 28 degrees and 1700 kg/m3 bears what its strength, 2.00 c, is to the mean of its load, N / 2.
struct Column {
    /// @param side in particles, three per cell
    /// @param young E [Pa]
    /// @param bed_deg friction angle of the bed
    /// @param cells_high height in cells
    Column(double times_critical, int side, double young, double bed_deg = 12, double cells_high = 0)
        : pool(1),
          height(times_critical * 2 * 1.9991 * 1e4 / (1700 * 9.81)),
          c(cells_high > 0 ? height / cells_high : 2),
          half(side * c.laws.solid.spacing / 2),
          state(make(side, young, bed_deg)) {}

    /// Cohesion lost, mean of the particles within a quarter of the width from the rim, or around the middle.
    [[nodiscard]] double lost(bool rim) const {
        const ParticleSet& p = state.solid->particles;
        const double middle = 10 * c.cell_size + half;
        double sum = 0;
        int count = 0;
        for (std::size_t i = 0; i < p.size(); ++i) {
            const double off = std::max(std::abs(p[Field::x][i] - middle), std::abs(p[Field::y][i] - middle));
            if (rim ? off < 0.75 * half : off > 0.4 * half) continue;
            sum += 1 - p[Field::cohesion_ratio][i];
            ++count;
        }
        return sum / count;
    }

    State make(int side, double young, double bed_deg) {
        c.material.cohesion = 1e4;
        c.laws.solid.elastic = Elasticity::from_young_and_bulk(young, young / 1.5);
        c.material.bed_friction = std::tan(bed_deg * k_degree);
        c.fill(10 * c.cell_size, 10 * c.cell_size, side, side, [&](Point) { return bench::Seed{height}; });
        return c.start(flat(35, 35, c.cell_size), pool);
    }
    ThreadPool pool;
    double height;  // [m]
    Case c;
    double half;  // of the width [m]
    State state;
};

TEST(WeakBlock, StandsForEverUnderItsCriticalHeight) {
    Column column(0.95, 9, 1e6);  // small and soft: fewer steps
    const ParticleSet start = column.state.solid->particles;
    advance_to(column.state, column.c.laws, 600, column.pool);
    const ParticleSet& p = column.state.solid->particles;
    for (const Field f : {Field::x, Field::y, Field::cohesion_ratio})
        EXPECT_EQ(std::memcmp(p[f], start[f], p.size() * sizeof(double)), 0);
    for (std::size_t i = 0; i < p.size(); ++i) EXPECT_EQ(std::hypot(p[Field::u][i], p[Field::v][i]), 0);
}

TEST(WeakBlock, FailsAtItsFreeSidesOverIt) {
    Column column(3, 36, 1e7);
    advance_to(column.state, column.c.laws, 0.3, column.pool);
    EXPECT_GT(column.lost(true), 0.03);
    EXPECT_LT(column.lost(false), 0.3 * column.lost(true));
    advance_to(column.state, column.c.laws, 3, column.pool);
    EXPECT_GT(column.lost(true), 0.3);
}

// The thrust of an edge, P = (N / 2 - q) h, acts through the nodes of the stress on the columns within some cells, so
// that friction under them can resist it: the outermost is pushed with 2.46 to 2.50 P / (rho h dx), for three particles
// per cell side and any place of the edge on the nodes, 2/5 dx apart (sums of cubic splines), at a corner by sqrt(2) of
// that. So material of any cohesion stands up to
//     m = 1 / (1 - 2 tan(phi_b) dx / (2.46 h))     times its critical height, straight edges alone,
// which tends to 1 with the cell size: by first order.
class Edge : public ::testing::TestWithParam<std::tuple<double, double>> {};

TEST_P(Edge, FailsAtOnceBeyondWhatFrictionHolds) {
    const auto [cells_high, bed_deg] = GetParam();
    const auto multiple = [&, cells = cells_high, bed = bed_deg](double push) {
        return 1 / (1 - 2 * std::tan(bed * k_degree) / (push * cells));
    };
    const auto lost = [&, cells = cells_high, bed = bed_deg](double times) {
        Column column(times, 24, 1e6, bed, cells);
        advance_to(column.state, column.c.laws, 1, column.pool);
        return column.lost(true);
    };
    const double stands = 0.98 * multiple(std::sqrt(2) * 2.5), fails = 1.05 * multiple(2.46);
    EXPECT_EQ(lost(stands), 0) << stands;
    EXPECT_GT(lost(fails), 0.005) << fails;
}

INSTANTIATE_TEST_SUITE_P(WeakBlock, Edge, ::testing::Combine(::testing::Values(2, 4, 8), ::testing::Values(12, 28)));

}  // namespace
}  // namespace frana::structured::test
