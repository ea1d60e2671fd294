// SPDX-License-Identifier: Apache-2.0
// Where particles of structured solids begin.
#include <gtest/gtest.h>

#include <cmath>

#include "models/structured/solid/column_state.h"
#include "models/structured/solid/placement.h"

namespace frana::structured::test {
namespace {

TEST(R2Sequence, FirstPointsAndDistances) {
    EXPECT_DOUBLE_EQ(r2_point(0).x, 0.5);
    EXPECT_NEAR(r2_point(1).x, 0.254878, 1e-6);
    EXPECT_NEAR(r2_point(1).y, 0.069840, 1e-6);
    EXPECT_NEAR(r2_point(2).x, 0.009755, 1e-6);
    EXPECT_NEAR(r2_point(2).y, 0.639681, 1e-6);
    EXPECT_NEAR(r2_point(3).x, 0.764633, 1e-6);  // 0.5 + 3 * 0.7548776662, cut
    EXPECT_NEAR(r2_point(3).y, 0.209521, 1e-6);
    double nearest = 1;
    for (int a = 0; a < 100; ++a) {
        for (int b = 0; b < a; ++b) {
            const Point p = r2_point(a), q = r2_point(b);
            nearest = std::min(nearest, std::hypot(p.x - q.x, p.y - q.y));
        }
    }
    EXPECT_GT(nearest, 0.5 / std::sqrt(100.0));
}

double total(const ParticleSet& particles, Field field) {
    double sum = 0;
    for (std::size_t p = 0; p < particles.size(); ++p) sum += particles[field][p];
    return sum;
}

TEST(Placement, ByDepthKeepsBothVolumes) {
    GridSpec grid;
    grid.cell_size = 2;
    grid.columns = 17;
    grid.rows = 11;
    grid.north = 22;
    Raster solids(grid, k_no_data), confined(grid, k_no_data);
    double v_s = 0, v_fc = 0;
    for (std::int64_t row = 2; row < 9; ++row) {
        for (std::int64_t column = 3; column < 15; ++column) {
            // Thin edges hold less than a particle a cell; they must not be lost.
            solids.at(row, column) = 0.01 * static_cast<double>((row - 1) * (column - 2));
            confined.at(row, column) = 0.7 * solids.at(row, column);
            v_s += solids.at(row, column) * 4;
            v_fc += confined.at(row, column) * 4;
        }
    }
    const ParticleSet placed = place_by_depth(solids, confined, 9);
    EXPECT_GT(placed.size(), 100U);
    EXPECT_NEAR(total(placed, Field::volume), v_s, 1e-12 * v_s);
    EXPECT_NEAR(total(placed, Field::confined), v_fc, 1e-12 * v_fc);
    for (std::size_t p = 0; p < placed.size(); ++p) {
        EXPECT_DOUBLE_EQ(placed[Field::volume][p], placed[Field::volume][0]);
        EXPECT_TRUE(placed[Field::x][p] > 6 && placed[Field::x][p] < 30);
    }
    // The deepest cell holds as many as asked for, give or take what its neighbour left.
    int deepest = 0;
    for (std::size_t p = 0; p < placed.size(); ++p)
        deepest += placed[Field::x][p] > 28 && placed[Field::y][p] < 6 && placed[Field::y][p] > 4;
    EXPECT_NEAR(deepest, 9, 1);
}

TEST(Placement, NothingFromNothing) {
    GridSpec grid;
    grid.columns = grid.rows = 3;
    EXPECT_EQ(place_by_depth(Raster(grid), Raster(grid), 9).size(), 0U);
}

TEST(Placement, SplitsColumnsIntoPhases) {
    ParticleSet columns;
    ParticleRow r = ParticleSet::initial_row();
    get(r, Field::volume) = 10;
    get(r, Field::area) = 2;
    columns.push_back(r);
    SolidMaterial material;
    material.solid_fraction = 0.6;
    material.confined_fraction = 0.75;
    material.cohesion = 1e4;
    material.friction = 0.5;
    const auto everywhere = [&](Point) { return material; };
    const ParticleSet split = split_phases(columns, everywhere);
    EXPECT_DOUBLE_EQ(split[Field::volume][0], 6);
    EXPECT_DOUBLE_EQ(split[Field::confined][0], 3);
    const ParticleSet whole = assign_material(split, solid_fields(true, true), everywhere);
    EXPECT_EQ(whole[Field::cohesion_ratio][0], 1);
    EXPECT_EQ(whole[Field::friction][0], 0.5);
    EXPECT_EQ(whole[Field::confined][0], split[Field::confined][0]);

    material.cohesion = 0;  // nothing that could hold the fluid
    EXPECT_EQ(split_phases(columns, everywhere)[Field::confined][0], 0);
    EXPECT_EQ(assign_material(split, solid_fields(true, true), everywhere)[Field::cohesion_ratio][0], 0);
}

TEST(Placement, SharesOutColumnsThatAreTooThin) {
    ParticleSet columns(k_basic_fields);
    const double depths[] = {2, 1, 1e-17, 5e-5};
    for (const double depth : depths) {
        ParticleRow r = ParticleSet::initial_row();
        get(r, Field::area) = 4;
        get(r, Field::volume) = 4 * depth;
        columns.push_back(r);
    }
    const auto everywhere = [](Point) {
        SolidMaterial m;
        m.solid_fraction = 0.6;
        m.cohesion = 1000;
        return m;
    };
    const ParticleSet thick = split_phases(columns, everywhere, 1e-4), all = split_phases(columns, everywhere);
    ASSERT_EQ(all.size(), 4U);
    ASSERT_EQ(thick.size(), 2U);
    for (const Field field : {Field::volume, Field::confined}) {
        EXPECT_NEAR(total(thick, field), total(all, field), 1e-15 * total(all, field));
        EXPECT_NEAR(thick[field][0] / thick[field][1], 2, 1e-14);
    }
    EXPECT_EQ(split_phases(columns, everywhere, 3).size(), 4U);  // there are no others
}

}  // namespace
}  // namespace frana::structured::test
