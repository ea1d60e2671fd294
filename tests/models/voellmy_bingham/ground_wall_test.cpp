// SPDX-License-Identifier: Apache-2.0
// Walls of the ground take the velocity normal to them (mpm/ground_walls.h): what a basin and a pit keep of a flow.
#include <gtest/gtest.h>

#include "mpm/ground_walls.h"
#include "support/cases.h"
#include "support/hollows.h"

namespace frana::test {
namespace {

double kept(const Hollow& hollow, double friction) {
    Material material = water();
    material.of<CoulombFriction>().friction_coefficient = friction;
    Flow flow(hollow.bed, hollow.seeds(2), material,
              numerics(Scheme::standard, SlopeCorrection::normal, Boundary::wall), 1);
    flow.advance_to(hollow.time);
    return fraction_inside(hollow, flow.particles());
}

// Over walls of slopes 0, 90 and 99 % were in it; on cells of 5 m the splines smooth the wall over a quarter of the
// basin, and what piles up there still goes over it: 38 %.
TEST(GroundWall, ABasinKeepsAFilm) {
    EXPECT_GT(kept(basin(5), 0), 0.35);
    const double fine = kept(basin(1.25), 0);
    EXPECT_GT(fine, 0.95);
    EXPECT_NEAR(kept(basin(2.5), 0), fine, 0.1 * fine);
}

// As a slope, its wall let all but 31 and 11 % go on. The splines smooth its rim over a cell, from which it fills: it
// keeps 57, 49 and 43 % on 5, 2.5 and 1.25 m, finite volumes 42 %.
TEST(GroundWall, APitKeepsWhatFallsIntoIt) {
    for (const double cell : {5.0, 2.5}) {
        EXPECT_GT(kept(pit(cell), 0.1), 0.42) << cell;
        EXPECT_LT(kept(pit(cell), 0.1), 0.42 * (1 + cell / 10)) << cell;
    }
}

// With walls as slopes 98 and 97 % passed. Finite volumes let 43 and 42 % pass, particles 51 and 82 %: the splines
// smooth the crest over a cell, and what piles up before it goes over.
TEST(GroundWall, ADamHoldsAPart) {
    EXPECT_LT(kept(dam(5), 0), 0.6);
    EXPECT_LT(kept(dam(2.5), 0), 0.9);
}

// A wall of 3 m and one cell. What is lower keeps nothing of its motion towards it, all along it and away from it; over
// the crest it keeps the critical speed, or the part over it.
TEST(GroundWall, TakesTheMotionTowardsIt) {
    const GridSpec grid = bench::plain_grid(16, 16, 1);
    const NodeGrid nodes(bench::sample_raster(grid, [](Point p) { return p.x > 8 ? 3.0 : 0.0; }));
    const Point from{7.2, 8.2};
    const auto keep = [&](double depth, double crest, Point& to) {
        return keep_at_walls(nodes, depth - 0.5 * 0.2 * 0.2 * 3, crest, from, to);  // the splines' bed
    };
    for (const double aside : {0.5, -0.5}) {
        Point to{8.4, from.y + aside};
        const Kept kept = keep(2, 1, to);
        EXPECT_EQ(kept.x, 0);
        EXPECT_EQ(kept.y, 1);
        EXPECT_EQ(to.x, from.x);
        EXPECT_EQ(to.y, from.y + aside);
    }
    Point back{6.2, 8.2}, slow{8.4, 8.2}, fast{8.4, 8.2}, dry{8.4, 8.2};
    EXPECT_EQ(keep(2, 1, back).x, 1);
    EXPECT_NEAR(keep(3.25, 1, slow).x, 0.5 / 1.2, 1e-12);
    EXPECT_NEAR(keep(4.5, 0, fast).x, 0.5, 1e-12);
    EXPECT_EQ(keep(0, 1, dry).x, 0);
    Point low{8.4, 8.2}, high{8.4, 8.2};
    EXPECT_TRUE(stop_jet_at_walls(nodes, 2.9, from, low));
    EXPECT_FALSE(stop_jet_at_walls(nodes, 3.1, from, high));
    WalledTiles tiles;
    const TileGrid of{grid.columns, grid.rows, k_ghost};
    EXPECT_TRUE(tiles.examine(0, of, nodes));
    EXPECT_FALSE(WalledTiles().examine(0, of, NodeGrid(Raster(grid, 0.0))));
}

}  // namespace
}  // namespace frana::test
