// SPDX-License-Identifier: Apache-2.0
#include "render/canvas/lettering.h"

#include <gtest/gtest.h>

#include <cmath>

#include "render/canvas/page.h"

namespace frana::render {
namespace {

/// Draws one black text on a white page.
Image written(int width, int height, const std::string& words, Point at, const TextStyle& style, Across across,
              Upright upright) {
    Sheet sheet(width, height);
    sheet.text(words, at, style, across, upright);
    Page page(width, height);
    page.put(sheet.take());
    return page.paint();
}

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
            TextStyle style{20, {0, 0, 0}};
            style.angle_deg = angle;
            const std::string words = "Ágp 5 m²";
            const PageBox box = lettering.place(words, {150, 150}, style, across, Upright::middle).box;
            const PageBox found = ink(written(300, 300, words, {150, 150}, style, across, Upright::middle));
            // A letter's place is rounded to a pixel, and its rim covers pixels in part.
            EXPECT_TRUE(found.inside({box.left - 2, box.top - 2, box.right + 2, box.bottom + 2})) << angle;
            if (std::fmod(angle, 90) != 0) continue;  // around an oblique text the box is that of its box
            EXPECT_NEAR(found.width(), box.width(), 3) << angle;
            EXPECT_NEAR(found.height(), box.height(), 3) << angle;
        }
    }
}

// A stem of four pixels or more is black in its middle, not grey: letters are not drawn between pixels or twice.
TEST(Lettering, IsSharp) {
    const Image page = written(120, 120, "HIE", {10, 100}, {60, {0, 0, 0}}, Across::left, Upright::baseline);
    int black = 0, grey = 0;
    for (int row = 0; row < page.height; ++row)
        for (int column = 0; column < page.width; ++column) {
            const int v = page.colour(column, row).r;
            black += v < 5;
            grey += v >= 5 && v < 250;
        }
    EXPECT_GT(black, 2 * grey);
    // The same wherever it is on the page: parts of a pixel make no other letters.
    const Image moved = written(120, 120, "HIE", {10.1, 100.1}, {60, {0, 0, 0}}, Across::left, Upright::baseline);
    EXPECT_EQ(page.rgb, moved.rgb);
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

TEST(Lettering, BrokenUtf8AndLineEndsDoNoHarm) {
    const Image page = written(200, 50, "a\xff\xc3(\n\xf0\x9f", {10, 25}, {20}, Across::left, Upright::middle);
    EXPECT_GT(ink(page).width(), 20);
}

// Both scripts are in DejaVu Sans.
TEST(Lettering, EveryScriptHasItsDirectionAndJoinsItsLetters) {
    const Lettering lettering;
    const TextStyle style{40};
    // From right to left: the second letter is the left one, as if it were alone.
    const auto left_columns = [&](const std::string& text) {
        const Image page = written(200, 80, text, {20, 60}, style, Across::left, Upright::baseline);
        std::vector<int> sums;  // of the ink in the leftmost columns; a letter is wider
        for (int column = 20; column < 30; ++column) {
            sums.push_back(0);
            for (int row = 0; row < page.height; ++row) sums.back() += 255 - page.colour(column, row).r;
        }
        return sums;
    };
    EXPECT_EQ(left_columns("\u05d0\u05d1"), left_columns("\u05d1"));
    EXPECT_NE(left_columns("\u05d0\u05d1"), left_columns("\u05d0"));
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
    const auto drawn = [](const std::string& text) {
        return written(120, 60, text, {10, 50}, {40}, Across::left, Upright::baseline);
    };
    const Image page = drawn("\u6ed1\u5761");
    if (!take_letters_without_font().empty()) GTEST_SKIP() << "no font has Chinese letters (Debian: fonts-noto-cjk)";
    EXPECT_NEAR(ink(page).width(), 80, 10);  // as wide as high
    EXPECT_NE(page.rgb, drawn("\u5761\u6ed1").rgb);
}

}  // namespace
}  // namespace frana::render
