// SPDX-License-Identifier: Apache-2.0
#include "app/text/number_text.h"

#include <gtest/gtest.h>

namespace frana::app {
namespace {

TEST(NumberText, Statistics) {
    EXPECT_EQ(number_text(0), "0");
    EXPECT_EQ(number_text(16.04, 3), "16");
    EXPECT_EQ(number_text(123456.7, 3), "123457");  // no exponents in messages
    EXPECT_EQ(number_text(0.01234, 2), "0.012");
}

TEST(NumberText, GroupsOfThree) {
    EXPECT_EQ(grouped(std::int64_t{0}), "0");
    EXPECT_EQ(grouped(std::int64_t{-1234567}), "-1 234 567");
    EXPECT_EQ(grouped(std::int64_t{-123}), "-123");
    EXPECT_EQ(grouped(999.6), "1 000");
    EXPECT_EQ(grouped(0.01504), "0.015");
    EXPECT_EQ(grouped(3.0), "3");
    EXPECT_EQ(grouped(0.0), "0");
}

TEST(NumberText, FiguresWithoutExponent) {
    EXPECT_EQ(number_text(100, 2), "100");
    EXPECT_EQ(number_text(99.96, 2), "100");
    EXPECT_EQ(number_text(99.4, 2), "99");
    EXPECT_EQ(number_text(9999.7), "10000");
    EXPECT_EQ(number_text(0.9996, 3), "1");
}

TEST(NumberText, BytesAndExtents) {
    EXPECT_EQ(bytes_text(999), "999 B");
    EXPECT_EQ(bytes_text(373469184), "373 MB");
    EXPECT_EQ(extent_text({1, 2, 3, 4.5}), "west 1.00, south 2.00, east 3.00, north 4.50");
}

}  // namespace
}  // namespace frana::app
