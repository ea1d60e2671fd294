// SPDX-License-Identifier: Apache-2.0
// Replacements for loops over all vertices give the same results as the loops, to the bit.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "analysis/scores.h"
#include "core/error.h"
#include "core/geometry.h"

namespace frana {
namespace {

Ring random_ring(Point centre, double radius, int points, std::mt19937& random) {
    std::uniform_real_distribution<double> uniform(0.3, 1);
    Ring ring;
    for (int i = 0; i < points; ++i) {
        const double angle = 2 * std::numbers::pi * i / points, r = radius * uniform(random);
        // Whole numbers: many edges are level, and many points are at a vertex's height.
        ring.push_back({std::round(centre.x + r * std::cos(angle)), std::round(centre.y + r * std::sin(angle))});
    }
    return ring;
}

TEST(InsideTest, EqualsContains) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> anywhere(-60, 160);
    for (int k = 0; k < 60; ++k) {
        MultiPolygon polygons{{random_ring({50, 50}, 50, 3 + 5 * k, random), {}}};
        if (k % 2 == 0)
            polygons[0].holes = {random_ring({50, 50}, 12, 9, random), random_ring({55, 45}, 9, 40, random)};
        if (k % 3 == 0) polygons.push_back({random_ring({90, 50}, 40, 30, random), {}});
        if (k % 7 == 0) polygons.push_back({});
        const InsideTest inside(polygons);
        int held = 0;
        for (int i = 0; i < 600; ++i) {
            Point p{anywhere(random), anywhere(random)};
            if (i % 2 == 0) p = {std::round(p.x), std::round(p.y)};
            ASSERT_EQ(inside(p), contains(polygons, p)) << k << ": " << p.x << ' ' << p.y;
            held += inside(p);
        }
        EXPECT_GT(held, 10);
    }
    EXPECT_FALSE(InsideTest({})({0, 0}));
}

TEST(NearestSegment, EqualsTheMinimumOverAll) {
    std::mt19937 random(12);
    std::uniform_real_distribution<double> uniform(0, 100);
    for (const int count : {1, 7, 100, 3000}) {
        std::vector<Segment> segments;
        for (int i = 0; i < count; ++i) {
            const Point a{529400 + uniform(random), 5094000 + uniform(random)};
            segments.push_back({a, {a.x + uniform(random) / 10 + 0.1, a.y + uniform(random) / 10}});
        }
        const NearestSegment nearest(segments);
        for (int i = 0; i < 300; ++i) {
            const Point p = i % 3 == 0 ? segments[static_cast<std::size_t>(i % count)].to
                                       : Point{529400 + 2 * uniform(random), 5094000 + 2 * uniform(random)};
            double least = std::numeric_limits<double>::infinity();
            for (const Segment& s : segments) {
                const double dx = s.to.x - s.from.x, dy = s.to.y - s.from.y;
                const double px = p.x - s.from.x, py = p.y - s.from.y;
                const double t = std::clamp((px * dx + py * dy) / (dx * dx + dy * dy), 0.0, 1.0);
                const double ex = px - t * dx, ey = py - t * dy;
                least = std::min(least, ex * ex + ey * ey);
            }
            ASSERT_EQ(nearest.square_of_distance(p), least);
        }
    }
    EXPECT_TRUE(std::isinf(NearestSegment().square_of_distance({0, 0})));
}

// Two outlines of 200 000 vertices: comparing each pair would be 10^11 distances.
TEST(LineDistance, OfManyVerticesIsFast) {
    Ring inner, outer;
    for (int i = 0; i < 200'000; ++i) {
        const double angle = 2 * std::numbers::pi * i / 200'000;
        inner.push_back({100 * std::cos(angle), 100 * std::sin(angle)});
        outer.push_back({103 * std::cos(angle), 103 * std::sin(angle)});
    }
    const LineDistance distance =
        distance_between(LineSet(MultiPolygon{{inner, {}}}), LineSet(MultiPolygon{{outer, {}}}), 5);
    EXPECT_NEAR(distance.mean_m, 3, 1e-6);
    EXPECT_NEAR(distance.hausdorff_m, 3, 1e-6);
}

TEST(CountedTexts, ListTheFirstAndCountTheRest) {
    CountedTexts texts;
    texts.add("b", "one other");
    for (int i = 1; i <= 1503; ++i) texts.add("a", "number " + std::to_string(i));
    EXPECT_EQ(texts_of(texts.texts()),
              (std::vector<std::string>{"one other", "number 1", "number 2", "number 3; and 1 500 more of this kind"}));
}

}  // namespace
}  // namespace frana
