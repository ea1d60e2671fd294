// SPDX-License-Identifier: Apache-2.0
#include "render/canvas/lettering.h"

#include <gtest/gtest.h>

namespace frana::render {
namespace {

/// Returns the smallest box around all dark pixels.
PageBox ink(const Image& page) {
    PageBox box{1e9, 1e9, -1e9, -1e9};
    for (int row = 0; row < page.height; ++row) {
        for (int column = 0; column < page.width; ++column) {
            if (page.colour(column, row) == Rgb{255, 255, 255}) continue;
            box.left = std::min<double>(box.left, column);
            box.top = std::min<double>(box.top, row);
            box.right = std::max<double>(box.right, column + 1);
            box.bottom = std::max<double>(box.bottom, row + 1);
        }
    }
    return box;
}

TEST(Lettering, BoxesContainTheInk) {
    const Lettering lettering;
    for (const double angle : {0.0, 90.0, 37.0, -60.0}) {
        for (const Across across : {Across::left, Across::centre, Across::right}) {
            Image page(300, 300);
            TextStyle style{20, {0, 0, 0}};
            style.angle_deg = angle;
            const TextBox told = lettering.write(page, "Ágp 5 m²", {150, 150}, style, across, Upright::middle);
            const TextBox placed = lettering.place("Ágp 5 m²", {150, 150}, style, across, Upright::middle);
            const PageBox found = ink(page);
            EXPECT_EQ(told.box.left, placed.box.left);
            EXPECT_EQ(told.box.top, placed.box.top);
            // The faintest rim (one part in 255) is rounded to white: a pixel of difference on each side.
            EXPECT_NEAR(found.left, told.box.left, 1);
            EXPECT_NEAR(found.top, told.box.top, 1);
            EXPECT_NEAR(found.right, told.box.right, 1);
            EXPECT_NEAR(found.bottom, told.box.bottom, 1);
        }
    }
}

TEST(Lettering, ReferencePoints) {
    const Lettering lettering;
    const TextStyle style{40, {0, 0, 0}};
    const auto box = [&](Across across, Upright upright) {
        return lettering.place("HHH", {200, 100}, style, across, upright).box;
    };
    EXPECT_NEAR(box(Across::left, Upright::top).left, 200, 1);
    EXPECT_NEAR(box(Across::right, Upright::top).right, 200, 1);
    const PageBox middle = box(Across::centre, Upright::middle);
    EXPECT_NEAR((middle.left + middle.right) / 2, 200, 1);
    EXPECT_NEAR((middle.top + middle.bottom) / 2, 100, 1);
    EXPECT_NEAR(box(Across::left, Upright::baseline).bottom, 100, 1);
    EXPECT_NEAR(box(Across::left, Upright::top).top, 100, 1);
}

TEST(Lettering, CapitalsAlignWhateverElseIsInTheLine) {
    const Lettering lettering;
    const TextStyle style{30, {0, 0, 0}};
    EXPECT_EQ(lettering.place("H", {50, 50}, style, Across::left, Upright::baseline).box.bottom,
              lettering.place("ÁH", {50, 50}, style, Across::left, Upright::baseline).box.bottom);
}

TEST(Lettering, GreekDegreesAndSuperscriptsHaveDistinctInk) {
    const Lettering lettering;
    const TextStyle style{24, {0, 0, 0}};
    for (const char* glyph : {"ξ", "µ", "φ", "²", "³", "°", "–", "≥", "ä", "ñ"}) {
        EXPECT_GT(lettering.width(glyph, style), 2) << glyph;
    }
}

TEST(Lettering, DollarsAreNotMathematics) {
    const Lettering lettering;
    const TextStyle style{20, {0, 0, 0}};
    EXPECT_GT(lettering.width("$x_1$", style), lettering.width("x_1", style) + 10);
}

TEST(Lettering, BrokenUtf8AndLineEndsDoNoHarm) {
    const Lettering lettering;
    Image page(200, 50);
    const TextBox box =
        lettering.write(page, "a\xff\xc3(\n\xf0\x9f", {10, 25}, {20, {0, 0, 0}}, Across::left, Upright::middle);
    EXPECT_GT(box.box.width(), 20);
}

// Both scripts are in DejaVu Sans.
TEST(Lettering, EveryScriptHasItsDirectionAndJoinsItsLetters) {
    const Lettering lettering;
    const TextStyle style{40};
    const auto glyphs = [&](const std::string& text) {
        return lettering.set(text, {0, 0}, style, Across::left, Upright::baseline);
    };
    // From right to left: the second letter is the left one, as if it were alone.
    const auto left_columns = [](const Glyphs& g) {
        std::vector<int> sums(10);  // of the ink in the leftmost columns; a letter is wider
        for (std::size_t i = 0; i < g.ink.size(); ++i)
            if (const std::size_t column = i % static_cast<std::size_t>(g.width); column < sums.size())
                sums[column] += g.ink[i];
        return sums;
    };
    EXPECT_EQ(left_columns(glyphs("\u05d0\u05d1")), left_columns(glyphs("\u05d1")));
    EXPECT_NE(left_columns(glyphs("\u05d0\u05d1")), left_columns(glyphs("\u05d0")));
    // Joined forms of BEH are narrower than three letters that are kept apart.
    EXPECT_LT(lettering.width("\u0628\u0628\u0628", style),
              0.9 * lettering.width("\u0628\u200c\u0628\u200c\u0628", style));
}

TEST(Lettering, LettersWithoutFontAreToldOnce) {
    take_letters_without_font();
    const Lettering lettering;
    EXPECT_GT(lettering.width("a\U0010fffd", {20}), lettering.width("a", {20})) << "a box in its place";
    EXPECT_GT(lettering.width("\U0010fffd \U0010fffd", {20}), 0);
    EXPECT_EQ(take_letters_without_font(), std::vector<std::string>{"\U0010fffd"});
    EXPECT_EQ(take_letters_without_font(), std::vector<std::string>{});
    EXPECT_GT(lettering.width("Größe \u03be \u0416", {20}), 0);
    EXPECT_EQ(take_letters_without_font(), std::vector<std::string>{});
}

TEST(Lettering, ChineseIsDrawn) {
    take_letters_without_font();
    const Glyphs glyphs = Lettering().set("\u6ed1\u5761", {0, 0}, {40}, Across::left, Upright::baseline);
    if (!take_letters_without_font().empty()) GTEST_SKIP() << "no font has Chinese letters (Debian: fonts-noto-cjk)";
    EXPECT_NEAR(glyphs.width, 80, 10);  // as wide as high
    EXPECT_NE(glyphs.ink, Lettering().set("\u5761\u6ed1", {0, 0}, {40}, Across::left, Upright::baseline).ink);
}

TEST(Lettering, NothingFromNothing) {
    const Lettering lettering;
    EXPECT_EQ(lettering.width("", {20}), 0);
    EXPECT_EQ(lettering.width("   ", {20}), 0);
}

}  // namespace
}  // namespace frana::render
