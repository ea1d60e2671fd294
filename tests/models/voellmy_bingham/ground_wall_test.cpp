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

// Over walls of slopes 0, 90 and 99 % were in it; what flies over it falls down at its wall.
TEST(GroundWall, ABasinKeepsAFilm) {
    EXPECT_GT(kept(basin(5), 0), 0.6);
    for (const double cell : {2.5, 1.25}) EXPECT_GT(kept(basin(cell), 0), 0.95) << cell;
}

// As a slope, its wall let all but 31 and 11 % go on. The splines smooth its rim over a cell, from which it fills: it
// keeps 57, 48 and 43 % on 5, 2.5 and 1.25 m, finite volumes 42 %.
TEST(GroundWall, APitKeepsWhatFallsIntoIt) {
    for (const double cell : {5.0, 2.5}) {
        const double part = kept(pit(cell), 0.1);
        EXPECT_GT(part, 0.42) << cell;
        EXPECT_LT(part, 0.42 * (1 + cell / 10)) << cell;
    }
}

// What passes: of finite volumes 43, 42, 43, 45 %; with walls as slopes 98 and 97 %.
TEST(GroundWall, ADamHoldsAPart) {
    for (const double cell : {5.0, 2.5, 1.25}) EXPECT_NEAR(kept(dam(cell), 0), 0.44, 0.15) << cell;
}

// Of finite volumes 17 to 20 % pass over 9 m, whatever the angle to the grid and the cells, and 0.3 to 1.6 % over 13 m.
TEST(GroundWall, AnObliqueDamHoldsAsMuch) {
    for (const double degrees : {30.0, 45.0}) {
        for (const double cell : {5.0, 2.5}) {
            EXPECT_NEAR(kept(oblique_dam(cell, degrees, 9), 0), 0.19, 0.08) << degrees << ", " << cell;
            EXPECT_LT(kept(oblique_dam(cell, degrees, 13), 0), 0.05) << degrees << ", " << cell;
        }
    }
}

// The splines carry a part of what stands before a wall onto its top: it is neither in the maxima nor in the final
// depth, which keeps the volume.
TEST(GroundWall, ATopThatNothingReachedIsDry) {
    const Hollow hollow = oblique_dam(5, 0, 30);
    Flow flow(hollow.bed, hollow.seeds(2), water(), numerics(Scheme::standard, SlopeCorrection::normal, Boundary::wall),
              1);
    flow.advance_to(8);
    const std::size_t top = flow.nodes().scale().node_of(292.5, 252.5), before = top - 1;
    EXPECT_GT(flow.maxima().depth[top], 0.1);
    flow.end();
    const Raster depth = flow.snapshot().depth;
    flow.record_present();
    EXPECT_EQ(flow.maxima().depth[top], 0);
    EXPECT_EQ(flow.maxima().arrival_plus_1[top], 0);
    EXPECT_GT(flow.maxima().depth[before], 2);
    double shown = 0;
    for (const double h : depth.values)
        if (h > 0) shown += h * hollow.grid.cell_area();
    EXPECT_NEAR(shown, flow.volume(), 0.01 * flow.volume());
}

/// Water that runs against a wall with stairs and into a pit, on a map that is turned or mirrored.
struct Map {
    double xx, xy, yx, yy;

    [[nodiscard]] Point operator()(Point p) const { return {xx * p.x + xy * p.y, yx * p.x + yy * p.y}; }
    /// Of a place in the map.
    [[nodiscard]] Point place(Point p) const {
        const Point from_middle = (*this)({p.x - k_middle, p.y - k_middle});
        return {from_middle.x + k_middle, from_middle.y + k_middle};
    }
    static constexpr double k_middle = 100;
};

Flow walls_of(const Map& map) {
    const GridSpec grid = bench::plain_grid(40, 40, 5);
    const Map back{map.xx, map.yx, map.xy, map.yy};
    const Raster bed = bench::sample_raster(grid, [&](Point in_map) {
        const Point p = back.place(in_map);
        if (p.x + 0.6 * p.y > 190 && p.x + 0.6 * p.y < 210) return 30.0;
        return std::abs(p.x - 85) < 15 && std::abs(p.y - 60) < 20 ? 5.0 : 20 - 0.05 * p.x;
    });
    const ParticleSet seeds = bench::fill_lattice(grid, 2, 0, [&](Point in_map) {
        const Point p = back.place(in_map), along = map({14, 6});
        return bench::Seed{2.5 - 0.08 * std::hypot(p.x - 45, p.y - 70), along.x, along.y};
    });
    return Flow(bed, seeds, water(), numerics(Scheme::standard, SlopeCorrection::normal, Boundary::wall), 1);
}

// Neither axis comes first. Sums in another order differ by some 1e-15 of a metre after a step; where the flow piles up
// at walls this grows, to 3e-13 m in 10 s.
TEST(GroundWall, IsTheSameTurnedAndMirrored) {
    Flow straight = walls_of({1, 0, 0, 1});
    straight.advance_to(8);
    const Raster depth = straight.nodal_fields().depth;
    const auto cell = [&](Point p) {
        return depth.index(static_cast<std::int64_t>((2 * Map::k_middle - p.y) / 5),
                           static_cast<std::int64_t>(p.x / 5));
    };
    double piled = 0;
    for (double y = 2.5; y < 200; y += 5) piled = std::max(piled, depth.values[cell({187.5 - 0.6 * y, y})]);
    EXPECT_GT(piled, 1);  // before the stairs
    for (const Map map : {Map{0, -1, 1, 0}, Map{-1, 0, 0, 1}, Map{0, 1, 1, 0}}) {
        Flow flow = walls_of(map);
        flow.advance_to(8);
        const Raster other = flow.nodal_fields().depth;
        double difference = 0;
        for (double y = 2.5; y < 200; y += 5)
            for (double x = 2.5; x < 200; x += 5)
                difference =
                    std::max(difference, std::abs(other.values[cell(map.place({x, y}))] - depth.values[cell({x, y})]));
        EXPECT_LT(difference, 1e-11) << map.xx << map.xy;
    }
}

// A wall of 3 m and one cell. In a cell before it a flow that is lower comes nearer and nearer and loses the speed
// towards it, by 1 / (1 + Courant number) in a step; along it and away from it it keeps all. Over the crest goes what
// is above it: at its own speed or at that of a weir.
TEST(GroundWall, TakesTheMotionTowardsIt) {
    const GridSpec grid = bench::plain_grid(16, 16, 1);
    const NodeGrid nodes(bench::sample_raster(grid, [](Point p) { return p.x > 8 ? 3.0 : 0.0; }));
    const Point from{7.2, 8.2};
    for (const double aside : {0.5, -0.5}) {
        Point to{8.1, from.y + aside};
        const Kept kept = keep_at_walls(nodes, 2, 1, from, to);
        EXPECT_NEAR(kept.x, 1 / 1.9, 1e-12);
        EXPECT_EQ(kept.y, 1);
        EXPECT_NEAR(to.x, 8 - 0.8 * std::exp(-0.9), 1e-12);
        EXPECT_EQ(to.y, from.y + aside);
        EXPECT_NEAR(kept.part.met, 0.9, 1e-12);
        EXPECT_EQ(kept.part.passed, 0);
    }
    Point back{6.2, 8.2}, fast{8.1, 8.2}, slow{7.3, 8.2}, dry{8.1, 8.2}, face{8.9, 8.2}, beyond{8.8, 8.2};
    EXPECT_EQ(keep_at_walls(nodes, 2, 1, from, back).x, 1);
    const double part = 1.5 / 4.5, reach = 0.8 + part / (1 - part);  // of 4.5 m, 1.5 m are above the wall
    const Kept over = keep_at_walls(nodes, 4.5, 0.1, from, fast);
    EXPECT_NEAR(fast.x, 7.2 + reach * (1 - std::exp(-(1 - part) * 0.9)), 1e-12);
    EXPECT_NEAR(over.x, 1 / (1 + 3 / 4.5 * 0.9), 1e-12);
    EXPECT_EQ(over.part.passed, 0);
    EXPECT_EQ(keep_at_walls(nodes, 4.5, 0.1, {7.9, 8.2}, beyond).part.passed, 1);
    EXPECT_GT(beyond.x, 8);
    keep_at_walls(nodes, 4.5, 1, from, slow);
    EXPECT_EQ(slow.x, 7.3);  // a weir would carry more
    keep_at_walls(nodes, 0, 1, from, dry);
    EXPECT_LT(dry.x, 8);
    keep_at_walls(nodes, 2, 1, {std::nextafter(8.0, 0.0), 8.2}, face);  // rounding does not carry it over
    EXPECT_LT(face.x, 8);
    Point low{8.4, 8.2}, high{8.4, 8.2};
    EXPECT_TRUE(stop_jet_at_walls(nodes, 2.9, from, low));
    EXPECT_FALSE(stop_jet_at_walls(nodes, 3.1, from, high));
    WalledTiles tiles;
    const TileGrid of{grid.columns, grid.rows, k_ghost};
    EXPECT_TRUE(tiles.examine(0, of, nodes));
    EXPECT_FALSE(WalledTiles().examine(0, of, NodeGrid(Raster(grid, 0.0))));
}

// A block on the far side of a corner: through the corner itself it is a wall, and the same on both ways round it.
TEST(GroundWall, ACornerStopsWhatComesDiagonally) {
    const GridSpec grid = bench::plain_grid(16, 16, 1);
    const NodeGrid nodes(bench::sample_raster(grid, [](Point p) { return p.x > 8 && p.y > 8 ? 3.0 : 0.0; }));
    Point through{8.25, 8.25}, below{8.5, 8.25}, above{8.25, 8.5};
    keep_at_walls(nodes, 2, 1, {7.75, 7.75}, through);
    EXPECT_EQ(through.x, 7.75);
    EXPECT_EQ(through.y, 7.75);
    keep_at_walls(nodes, 2, 1, {7.75, 7.75}, below);
    keep_at_walls(nodes, 2, 1, {7.75, 7.75}, above);
    EXPECT_EQ(below.x, above.y);
    EXPECT_EQ(below.y, above.x);
    EXPECT_EQ(below.y, 7.75);
    EXPECT_EQ(below.x, 8.5);
}

}  // namespace
}  // namespace frana::test
