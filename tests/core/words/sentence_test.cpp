// SPDX-License-Identifier: Apache-2.0
#include "core/words/sentence.h"

#include <gtest/gtest.h>

#include "core/words/words.h"

namespace frana {
namespace {

TEST(Sentences, AreEnglishTextsAndShownInALanguageWithTheirNumbers) {
    const Sentence left =
        worded("{1} m3 ({2} %) left the computed ground: use a larger DTM", {numeral("1 234.5"), numeral("2.5")});
    EXPECT_EQ(left.text(), "1 234.5 m3 (2.5 %) left the computed ground: use a larger DTM");
    EXPECT_EQ(left.in(Words(Language::german)).find("1.234,5 m³ (2,5 %) verließen"), 0U);
}

TEST(Sentences, ContainOthersAndKeepNamesAsTheyAre) {
    const Sentence inner = worded("outline repaired ({1}): area {2} before, {3} after",
                                  {std::string("Ring 1.5"), numeral("10.5"), numeral("9")});
    const Sentence whole = worded("{1}: {2}", {worded("Release perimeter"), inner});
    EXPECT_EQ(whole.text(), "Release perimeter: outline repaired (Ring 1.5): area 10.5 before, 9 after");
    EXPECT_EQ(whole.in(Words(Language::italian)),
              "Perimetro del distacco: contorno riparato (Ring 1.5): area 10,5 prima, 9 dopo");
    const std::string named_like_a_row = "zones", with_a_place = "a {1} b";
    EXPECT_EQ(Sentence(named_like_a_row).in(Words(Language::german)), "zones");
    EXPECT_EQ(worded("{1}: {2}", {with_a_place, named_like_a_row}).in(Words(Language::french)), "a {1} b\u202F: zones");
}

TEST(Sentences, KnowTheirFirstNumberInTheOrderOfTheirPlaces) {
    const Sentence inner = worded("E {1}, N {2}", {numeral("1 234.5"), numeral("7")});
    EXPECT_EQ(worded("{1}: {2}", {std::string("name 3"), inner}).first_number(), 1234.5);
    EXPECT_FALSE(worded("{1}: {2}", {std::string("3"), worded("zones")}).first_number());
}

TEST(Sentences, AreListed) {
    EXPECT_EQ(listed({}).text(), "");
    EXPECT_EQ(listed({std::string("a"), worded("zones"), std::string("c")}).in(Words(Language::french)),
              "a\u202F; zones\u202F; c");
}

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
    const std::string english = "95.5 % of the area";
    EXPECT_EQ(NumberPattern(english).in(Words()), english);
    EXPECT_EQ(NumberPattern(english).in(Words(Language::german)), "95,5 % der Fläche");
    EXPECT_EQ(NumberPattern("12 300 marbles").in(Words(Language::italian)), "12.300 marbles") << "no row";
}

}  // namespace

}  // namespace frana
