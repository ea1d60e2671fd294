// SPDX-License-Identifier: Apache-2.0
#include "render/canvas/furniture.h"

#include <gtest/gtest.h>

namespace frana::render {
namespace {

TEST(Ticks, NiceStepsAre125) {
    EXPECT_DOUBLE_EQ(nice_step_above(0.21), 0.5);
    EXPECT_DOUBLE_EQ(nice_step_above(200), 200);
    EXPECT_DOUBLE_EQ(nice_step_above(201), 500);
    EXPECT_DOUBLE_EQ(nice_step_above(501), 1000);
    EXPECT_DOUBLE_EQ(nice_step_below(499), 200);
    EXPECT_DOUBLE_EQ(nice_step_below(500), 500);
    EXPECT_DOUBLE_EQ(nice_step_below(0.99), 0.5);
}

TEST(Ticks, MultiplesIncludeBothEnds) {
    EXPECT_EQ(multiples(100, 300, 100), (std::vector<double>{100, 200, 300}));
    EXPECT_EQ(multiples(101, 299, 100), (std::vector<double>{200}));
    EXPECT_EQ(multiples(-150, 150, 100), (std::vector<double>{-100, 0, 100}));
}

TEST(Ticks, NumbersAreShort) {
    EXPECT_EQ(number(0.1 + 0.2), "0.3");
    EXPECT_EQ(number(20), "20");
    EXPECT_EQ(number(1234567), "1234567");
    EXPECT_EQ(grouped(5094000), "5 094 000");
    EXPECT_EQ(grouped(527000), "527 000");
    EXPECT_EQ(grouped(12), "12");
    EXPECT_EQ(grouped(-1500), "−1 500");
    EXPECT_EQ(grouped(0), "0");
}

}  // namespace
}  // namespace frana::render
