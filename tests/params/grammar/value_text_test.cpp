// SPDX-License-Identifier: Apache-2.0
#include "params/grammar/value_text.h"

#include <gtest/gtest.h>

#include "core/text.h"

namespace frana {
namespace {

TEST(ValueText, NumbersAreWholeFiniteAndExact) {
    EXPECT_EQ(number_from_text("2.5e3"), 2500);
    EXPECT_EQ(number_from_text("+7"), 7);
    for (const std::string bad : {"", "1,5", "5 m", "nan", "inf", "1e999", "0x10", "+-1"})
        EXPECT_FALSE(number_from_text(bad)) << bad;
    EXPECT_EQ(integer_from_text("16"), 16);
    EXPECT_FALSE(integer_from_text("4.0"));
}

TEST(ValueText, ShortestTextReadsBackAsTheSameBits) {
    for (const double value : {0.1, 1.0 / 3, 9.80665, 5e-324, 1.7976931348623157e308, 527000.125})
        EXPECT_EQ(number_from_text(shortest_text(value)), value);
}

TEST(ValueText, WordsAndSwitches) {
    EXPECT_EQ(words_of(" a, b\tc ,,d "), (std::vector<std::string>{"a", "b", "c", "d"}));
    EXPECT_EQ(boolean_from_text("on"), true);
    EXPECT_EQ(boolean_from_text("no"), false);
    EXPECT_FALSE(boolean_from_text("maybe"));
}

}  // namespace
}  // namespace frana
