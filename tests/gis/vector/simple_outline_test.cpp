// SPDX-License-Identifier: Apache-2.0
#include "gis/vector/outline_check.h"

#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "gis/access/gdal_session.h"

namespace frana::gis {
namespace {

Ring round_ring(Point centre, double inner, double outer, int points) {
    Ring ring;
    for (int i = 0; i < points; ++i) {
        const double angle = 2 * std::numbers::pi * i / points, r = i % 2 == 0 ? outer : inner;
        ring.push_back({centre.x + r * std::cos(angle), centre.y + r * std::sin(angle)});
    }
    return ring;
}

TEST(Sweep, DetectsSoundOutlinesAndCrossings) {
    EXPECT_TRUE(sweep({{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {}}).sound);
    EXPECT_TRUE(sweep({{{0, 0}, {5, 0}, {10, 0}, {10, 10}, {0, 10}}, {}}).sound) << "a vertex in line";
    const OutlineVerdict bow = sweep({{{0, 0}, {10, 10}, {10, 0}, {0, 10}}, {}});
    ASSERT_TRUE(bow.crossing);
    EXPECT_EQ(bow.crossing->x, 5);
    EXPECT_EQ(bow.crossing->y, 5);
    const Ring square{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, hole{{2, 2}, {4, 2}, {4, 4}, {2, 4}};
    EXPECT_TRUE(sweep({square, {hole}}).sound);
    EXPECT_FALSE(sweep({hole, {square}}).sound) << "the hole surrounds the outline";
    EXPECT_FALSE(sweep({square, {hole, {{2.5, 2.5}, {3, 2.5}, {3, 3}}}}).sound) << "a hole in a hole";
    EXPECT_TRUE(sweep({square, {{{8, 8}, {12, 8}, {9, 9}}}}).crossing) << "the hole leaves the outline";
    // Touching edges: no verdict.
    for (const Ring& ring :
         {Ring{{0, 0}, {10, 0}, {5, 0}, {5, 5}}, Ring{{0, 0}, {10, 0}, {5, 5}, {10, 10}, {0, 10}, {5, 5}},
          Ring{{0, 0}, {10, 0}, {10, 10}, {5, 0}, {0, 10}}}) {
        const OutlineVerdict verdict = sweep({ring, {}});
        EXPECT_FALSE(verdict.sound);
        EXPECT_FALSE(verdict.crossing);
    }
}

// GEOS is the reference: of five random points in a circle hardly two outlines in three are sound.
TEST(Sweep, AgreesWithGeosOnRandomOutlines) {
    const GdalSession session;
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform(-50, 50);
    int sound = 0, crossed = 0;
    for (int k = 0; k < 4000; ++k) {
        Polygon polygon;
        const int points = 3 + k % 6;
        for (int i = 0; i < points; ++i) polygon.outer.push_back({529400 + uniform(random), 5094000 + uniform(random)});
        if (k % 2 == 0) {
            polygon.outer = round_ring({0, 0}, 10 + uniform(random) / 5, 40, 8 + k % 30);
            polygon.holes = {round_ring({uniform(random) / 5, 0}, 3, 5, 9)};
        }
        const OutlineVerdict verdict = sweep(polygon);
        const bool valid = to_ogr(polygon)->IsValid();
        EXPECT_EQ(verdict.sound, valid) << k;
        EXPECT_FALSE(valid && verdict.crossing) << k;
        sound += valid;
        crossed += verdict.crossing.has_value();
    }
    EXPECT_GT(sound, 1000);
    EXPECT_GT(crossed, 1000);
}

// GEOS would compare each pair of these edges.
TEST(Sweep, AStarOfManySpikesIsFast) {
    Polygon star{round_ring({0, 0}, 8, 45, 200'000), {round_ring({0, 0}, 3, 5, 100'000)}};
    EXPECT_TRUE(sweep(star).sound);
    std::swap(star.outer[1000], star.outer[1002]);
    EXPECT_TRUE(sweep(star).crossing);
}

}  // namespace
}  // namespace frana::gis
