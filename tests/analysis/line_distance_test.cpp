// SPDX-License-Identifier: Apache-2.0
#include "analysis/scores.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"

namespace frana {
namespace {

MultiPolygon square(double west, double south, double side) {
    return {{{{west, south}, {west + side, south}, {west + side, south + side}, {west, south + side}}, {}}};
}

TEST(LineSet, DistanceOfAPointFromASquare) {
    const LineSet boundary(square(0, 0, 10));
    EXPECT_EQ(boundary.distance({5, 4}), 4);    // inside
    EXPECT_EQ(boundary.distance({13, 14}), 5);  // beyond a corner: 3, 4, 5
    EXPECT_EQ(boundary.distance({10, 5}), 0);
    EXPECT_TRUE(std::isnan(LineSet(MultiPolygon{}).distance({0, 0})));
}

TEST(LineSet, OfASquareWithAHoleCountsTheHole) {
    MultiPolygon ring = square(0, 0, 10);
    ring[0].holes.push_back(square(4, 4, 2)[0].outer);
    EXPECT_EQ(LineSet(ring).distance({5, 3}), 1);
}

TEST(LineSet, SamplesAreEvenlySpreadWhateverTheVertices) {
    // The same square with a vertex at every metre, as in outlines along cells.
    Ring fine;
    for (int i = 0; i < 10; ++i) fine.push_back({double(i), 0});
    for (int i = 0; i < 10; ++i) fine.push_back({10, double(i)});
    for (int i = 10; i > 0; --i) fine.push_back({double(i), 10});
    for (int i = 10; i > 0; --i) fine.push_back({0, double(i)});
    EXPECT_EQ(LineSet(MultiPolygon{{fine, {}}}).samples(3).size(), 16U);  // 4 of 2.5 m on each side
    EXPECT_EQ(LineSet(square(0, 0, 10)).samples(3).size(), 16U);
}

TEST(DistanceBetween, ConcentricSquaresByHand) {
    // Squares of 10 and 30 m about one centre, sampled every metre. From the inner one to the outer: 10 m,
    // all 40 samples. From the outer one: 10 m beside the inner square (40 samples); at its corners sqrt(100
    // + a^2) with a = 0.5, 1.5 ... 9.5 m, 8 samples each; the farthest has a = 9.5.
    const LineDistance d = distance_between(LineSet(square(10, 10, 10)), LineSet(square(0, 0, 30)), 1);
    double sum = 80 * 10;
    for (int k = 0; k < 10; ++k) sum += 8 * std::hypot(10, k + 0.5);
    EXPECT_NEAR(d.mean_m, sum / 160, 1e-12);                 // rounding
    EXPECT_NEAR(d.hausdorff_m, std::hypot(10, 9.5), 1e-12);  // exact: 14.14 m; the sampling misses 0.35 m
    // Nearest rank of 160: the 152nd; the 8 farthest are those with a = 9.5, so it is the last with 9.5's
    // predecessor, a = 8.5.
    EXPECT_NEAR(d.percentile_95_m, std::hypot(10, 8.5), 1e-12);
}

TEST(DistanceBetween, ShiftedSquaresAndEqualOnes) {
    const LineDistance same = distance_between(LineSet(square(0, 0, 10)), LineSet(square(0, 0, 10)), 1);
    EXPECT_EQ(same.mean_m, 0);
    EXPECT_EQ(same.hausdorff_m, 0);
    // 100 m beside: the Hausdorff distance is the shift, up to half a sample's spacing.
    const LineDistance far = distance_between(LineSet(square(0, 0, 10)), LineSet(square(100, 0, 10)), 1);
    EXPECT_NEAR(far.hausdorff_m, 100, 0.5);
    EXPECT_THROW(distance_between(LineSet(square(0, 0, 1)), LineSet(MultiPolygon{}), 1), Error);
}

}  // namespace
}  // namespace frana
