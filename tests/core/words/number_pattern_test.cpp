// SPDX-License-Identifier: Apache-2.0
#include "core/words/words.h"

#include <gtest/gtest.h>

namespace frana {
namespace {

TEST(NumberPattern, TakesOutNumbersButNotDigitsOfWords) {
    const NumberPattern pattern("24, a smooth wide bed");
    EXPECT_EQ(pattern.text, "{1}, a smooth wide bed");
    EXPECT_EQ(pattern.numbers, std::vector<std::string>{"24"});
    EXPECT_EQ(NumberPattern("Float32 in metre").text, "Float32 in metre");
    EXPECT_EQ(NumberPattern("63 071 m2").text, "{1} m2");
    EXPECT_EQ(NumberPattern("2020 123").text, "{1} {2}") << "not groups of one number";
    EXPECT_EQ(NumberPattern("").text, "");
    EXPECT_EQ(NumberPattern("1 2 3 4 5 6 7 8 9 10").numbers.size(), 9U) << "a row has nine places";
}

TEST(NumberPattern, IsPutIntoTheLanguageWithItsNumbers) {
    const std::string english = "0.136, glass beads";
    EXPECT_EQ(NumberPattern(english).in(Words()), english);
    EXPECT_EQ(NumberPattern(english).in(Words(Language::german)), "0,136, Glaskugeln");
    EXPECT_EQ(NumberPattern("12 300 marbles").in(Words(Language::italian)), "12.300 marbles") << "no row";
}

}  // namespace
}  // namespace frana
