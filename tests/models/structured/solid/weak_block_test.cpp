// SPDX-License-Identifier: Apache-2.0
// Blocks that their own weight breaks: what the vertical load, which is given, makes of strength.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "solid_cases.h"

namespace frana::structured::test {
namespace {

struct Spread {
    double area = 0;     // of cells ever deeper than 0.1 m [m2]
    double deepest = 0;  // at the end [m]
};

Raster hillside() {
    return bench::sample_raster(bench::plain_grid(90, 50, 10), [](Point p) {
        return p.x < 350 ? 200 + (350 - p.x) * std::tan(35 * k_degree) : 200 - (p.x - 350) * std::tan(5 * k_degree);
    });
}

// A dry block, 8 m thick and 100 m x 80 m, on 35 degrees that end on 5, or on a plain; cells of 10 m, 40 s.
Spread slide_off(double cohesion, DamageMeasure measure, const Raster& bed = hillside(),
                 EarthPressure thrust = EarthPressure::hydrostatic) {
    ThreadPool pool(1);
    Case c(10);
    c.laws.solid.fragmentation.measure = measure;
    c.laws.solid.earth_pressure = thrust;
    c.material.cohesion = cohesion;
    c.material.bed_friction = std::tan(20 * k_degree);
    c.fill(50, 210, 30, 24, [](Point) { return bench::Seed{8}; });
    State state = c.start(bed, pool);
    std::vector<bool> touched(state.solid->nodes.depth.size(), false);
    Spread spread;
    for (double t = 0.5; t < 40.1; t += 0.5) {
        advance_to(state, c.laws, t, pool);
        spread.deepest = 0;
        for (std::size_t n = 0; n < touched.size(); ++n) {
            const double depth = state.solid->nodes.depth[n];
            spread.deepest = std::max(spread.deepest, depth);
            if (depth > 0.1 && !touched[n]) {
                touched[n] = true;
                spread.area += 100;
            }
        }
    }
    return spread;
}

TEST(WeakBlock, OnePascalIsNearlyNone) {
    for (const DamageMeasure measure : {DamageMeasure::equivalent, DamageMeasure::volumetric}) {
        const Spread none = slide_off(0, measure), little = slide_off(1, measure);
        EXPECT_NEAR(little.area, none.area, 0.1 * none.area);
        EXPECT_LT(little.deepest, 1.25 * none.deepest);
    }
}

// A limit of the model (share/doc/structured.md): on gentle ground unbroken material of any cohesion has Rankine's
// active thrust, broken material by default the hydrostatic one, so that the limit of small cohesion is not that of
// none.
TEST(WeakBlock, OnAPlainOnePascalCoversLessUnlessBothHaveTheActiveThrust) {
    const Raster plain = bench::sample_raster(bench::plain_grid(90, 50, 10), [](Point) { return 0.0; });
    const auto area = [&](double cohesion, EarthPressure thrust) {
        return slide_off(cohesion, DamageMeasure::equivalent, plain, thrust).area;
    };
    const double none = area(0, EarthPressure::hydrostatic), little = area(1, EarthPressure::hydrostatic);
    RecordProperty("area_of_one_pascal_over_none", std::to_string(little / none));
    EXPECT_LT(little, 0.9 * none);
    EXPECT_GT(little, 0.65 * none);
    const double active = area(0, EarthPressure::active);
    EXPECT_NEAR(area(1, EarthPressure::active), active, 0.1 * active);
}

// A column of 10 kPa, 28 degrees and 1700 kg/m3 bears what its strength, 2.00 c, is to the mean of its load, N / 2.
struct Column {
    /// @param side in particles
    /// @param young E [Pa]
    /// @param bed_deg friction angle of the bed
    Column(double fraction, int side, double young, double bed_deg = 12)
        : pool(1), c(2), state(make(fraction, side, young, bed_deg)) {}

    /// Cohesion lost, mean of the particles near the rim or of those around the middle, of 36 x 36.
    [[nodiscard]] double lost(bool rim) const {
        const ParticleSet& p = state.solid->particles;
        double sum = 0;
        int count = 0;
        for (std::size_t i = 0; i < p.size(); ++i) {
            const double off = std::max(std::abs(p[Field::x][i] - 32), std::abs(p[Field::y][i] - 32));
            if (rim ? off < 9 : off > 5) continue;
            sum += 1 - p[Field::cohesion_ratio][i];
            ++count;
        }
        return sum / count;
    }

    State make(double fraction, int side, double young, double bed_deg) {
        c.material.cohesion = 1e4;
        c.laws.solid.elastic = Elasticity::from_young_and_bulk(young, young / 1.5);
        c.material.bed_friction = std::tan(bed_deg * k_degree);
        const double critical = 2 * 1.9991 * 1e4 / (1700 * 9.81);
        c.fill(20, 20, side, side, [&](Point) { return bench::Seed{fraction * critical}; });
        return c.start(flat(35, 35, 2), pool);
    }
    ThreadPool pool;
    Case c;
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

// A limit of the model (share/doc/structured.md): without motion there is no strain, and friction under the cells at
// the edge resists the thrust, so that on a grid a column stands beyond its critical height, longer on a rough bed.
TEST(WeakBlock, OnAGridStandsBeyondItsCriticalHeight) {
    Column higher(1.5, 36, 1e7), rough(3, 36, 1e7, 28);
    for (Column* column : {&higher, &rough}) advance_to(column->state, column->c.laws, 3, column->pool);
    EXPECT_LT(higher.lost(true), 1e-6);
    EXPECT_LT(rough.lost(true), 0.01);
}

}  // namespace
}  // namespace frana::structured::test
