// SPDX-License-Identifier: Apache-2.0
#include "render/map/legend.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "scenes.h"

namespace frana::render {
namespace {

constexpr double k_dots = 254;  // ten pixels per millimetre

TEST(PrintScale, MetresPerMillimetreOfPaper) {
    EXPECT_NEAR(10 * metres_per_pixel(5000, k_dots), 5, 1e-12);  // 1 mm is 5 m at 1 : 5000
    EXPECT_NEAR(scale_of(metres_per_pixel(5000, k_dots), k_dots), 5000, 1e-9);
}

TEST(PrintScale, RoundOnesAreThoseOfMaps) {
    const std::pair<double, double> expected[] = {{410, 500},     {500, 500},     {501, 600},
                                                  {1001, 1250},   {2001, 2500},   {2501, 3000},
                                                  {19000, 20000}, {20001, 25000}, {5e4 + 1, 60000}};
    for (const auto& [n, round] : expected) EXPECT_EQ(round_scale_above(n), round) << n;
}

TEST(PrintScale, IsRoundOnEveryPage) {
    const Print sheet{k_dots, "A4", std::nullopt};
    const Bounds content{1000, 2000, 1400, 2300};
    // 2000 x 1500 pixels are 200 x 150 mm; the content with a margin of 0.03 fits at 1 : 2120 and more.
    EXPECT_NEAR(least_scale(sheet, content, 2000, 1500), 2160, 1);
    const Bounds free{940, 1955, 1460, 2345};
    const Bounds shown = window_at_scale(sheet, content, free, 2000, 1500);
    EXPECT_NEAR(shown.width(), 500, 1e-9);  // 200 mm at 1 : 2500
    EXPECT_NEAR((shown.west + shown.east) / 2, 1200, 1e-9);
    const Bounds wide{1000, 2000, 1000 + 400 * 1.2, 2000 + 300 * 1.2};
    const Bounds wide_free{970, 1977, 1510, 2382};
    EXPECT_NEAR(window_at_scale(sheet, wide, wide_free, 2000, 1500).width(), 600, 1e-9);  // 1 : 3000, 2544 would fit
    EXPECT_NEAR(window_at_scale({k_dots, "", std::nullopt}, content, free, 2000, 1500).width(), 500, 1e-9);
    // A film is not printed.
    EXPECT_EQ(window_at_scale({}, content, free, 2000, 1500).width(), free.width());
}

TEST(PrintScale, ARequestedScaleIsExactOrRefused) {
    const Bounds content{1000, 2000, 1400, 2300}, free = content;
    EXPECT_NEAR(window_at_scale({k_dots, "A4", 3000}, content, free, 2000, 1500).width(), 600, 1e-9);
    try {
        window_at_scale({k_dots, "A4", 2000}, content, free, 2000, 1500);
        FAIL() << "accepted";
    } catch (const Error& error) {
        const std::string words = error.what();
        for (const char* one : {"does not fit the page at this scale", "1 : 2 000", "at least 1 : 2 160", "1 : 2 500"})
            EXPECT_NE(words.find(one), std::string::npos) << one << " in " << words;
    }
}

MapSpec on_sheet(const Raster& ground, const Raster& layer, int width, int height, const std::string& sheet) {
    MapSpec spec = test::full_map(ground, layer, width, height);
    spec.print = {150, sheet, std::nullopt};
    spec.longitude_latitude = test::degrees_at;
    spec.series = SeriesText{"The scene", spec.subtitle, spec.side_notes};
    return spec;
}

TEST(PrintScale, NoLetterIsSmallerThanIsAskedFor) {
    const Raster ground = test::terrain(), layer = test::tongue();
    constexpr int k_least = 17;
    const auto smallest = [&](int least) {
        MapSpec spec = on_sheet(ground, layer, 1417, 800, "");
        spec.side_notes.clear();
        spec.least_letters = least;
        MapLayout layout;
        draw_map(spec, &layout);
        double size = 1000;
        for (const TextBox& text : layout.texts) size = std::min(size, text.size_px);
        return size;
    };
    EXPECT_EQ(smallest(k_least), k_least);
    EXPECT_LT(smallest(k_least_letters), k_least) << "a page that is made for a screen has smaller ones";
}

// The pages of a series can be leafed through: frame and window stay, whatever else is on them.
TEST(PrintScale, AllPagesOfASeriesShareTheFrame) {
    const Raster ground = test::terrain(), layer = test::tongue();
    for (const auto& [width, height] :
         {std::pair(1600, 1200), std::pair(1240, 1754), std::pair(800, 600), std::pair(640, 480)}) {
        MapSpec spec = on_sheet(ground, layer, width, height, "");
        spec.block.lines = {"Regional survey", "A. Rossi", "2026-11-24"};
        MapLayout usual, hazard, frame;
        spec.title = "The scene: Maximum depth";
        draw_map(spec, &usual);
        spec.title = "The scene: Intensity, scheme swiss-debris-flow";
        spec.categories = {{1, "Medium intensity: depth < 1 m or speed < 1 m/s", {250, 200, 40}},
                           {2, "High intensity: depth > 1 m and speed > 1 m/s", {200, 30, 30}}};
        spec.legend_title = "Intensity, scheme swiss-debris-flow";
        spec.unit.clear();
        spec.side_notes.insert(spec.side_notes.begin(), {"Intensity of one scenario, without its frequency",
                                                         "Medium intensity: 12 300 m\u00B2"});
        draw_map(spec, &hazard);
        spec.categories.clear();
        spec.title = "The scene: Speed";
        spec.subtitle = "t = 12.5 s, " + spec.subtitle;
        spec.source = "frames/velocity_0003.tif, band 1, t = 12.5 s";
        spec.side_notes = {"Front at 12 m"};
        draw_map(spec, &frame);
        for (const MapLayout* other : {&hazard, &frame}) {
            EXPECT_EQ(other->map.left, usual.map.left) << width;
            EXPECT_EQ(other->map.top, usual.map.top) << width;
            EXPECT_EQ(other->map.right, usual.map.right) << width;
            EXPECT_EQ(other->map.bottom, usual.map.bottom) << width;
            EXPECT_EQ(other->window.west, usual.window.west) << width;
            EXPECT_EQ(other->window.north, usual.window.north) << width;
        }
        EXPECT_GT(usual.map.width() * usual.map.height(), 0.33 * width * height) << width;
    }
}

TEST(PrintScale, ALogoShrinksAndIsOmittedBeforeTheMapSuffers) {
    const Raster ground = test::terrain(), layer = test::tongue();
    const auto layout_of = [&](int width, int height, bool block, int logo_width) {
        MapSpec spec = on_sheet(ground, layer, width, height, "");
        if (block) {
            spec.block.logo = std::make_shared<const Image>(logo_width, 300, Rgb{0, 90, 0});
            spec.block.lines = {"Regional survey of slopes and torrents", "A. Rossi", "2026-11-24"};
        }
        MapLayout layout;
        const Image page = draw_map(spec, &layout);
        if (layout.logo.width() > 0) {
            EXPECT_EQ(page.colour(static_cast<int>(layout.logo.left) + 2, static_cast<int>(layout.logo.top) + 2),
                      (Rgb{0, 90, 0}));
        }
        return layout;
    };
    const auto area = [](const MapLayout& one) { return one.map.width() * one.map.height(); };
    const MapLayout large = layout_of(1600, 1200, true, 300), bare = layout_of(1600, 1200, false, 300);
    EXPECT_GT(large.logo.width(), 50);
    EXPECT_TRUE(large.logo.inside(large.title_block));
    EXPECT_GT(area(large), 0.95 * area(bare));
    for (const TextBox& text : large.texts) EXPECT_FALSE(text.box.overlaps(large.logo)) << text.text;
    const MapLayout small = layout_of(640, 480, true, 300), small_bare = layout_of(640, 480, false, 300);
    EXPECT_LT(small.logo.width(), large.logo.width());
    EXPECT_GT(area(small), 0.85 * area(small_bare));
    // Ten times as wide as high, it would be a few pixels high.
    EXPECT_EQ(layout_of(640, 480, true, 30000).logo.width(), 0);
}

TEST(PrintScale, CrossSectionsCarryTheirNames) {
    const Raster ground = test::terrain(), layer = test::tongue();
    MapSpec spec = on_sheet(ground, layer, 1000, 750, "");
    Outline sections{"Cross-sections", {}, {70, 50, 120}, 2, false};
    for (int i = 0; i < 4; ++i) {
        sections.lines.push_back({{527450, 5094300.0 + 60 * i}, {527750, 5094300.0 + 60 * i}});
        sections.names.push_back("Profile " + std::to_string(i + 1));
    }
    // On top of each other, and beyond the window on one side.
    sections.lines.push_back({{520000, 5094480}, {527750, 5094481}});
    sections.names.emplace_back("Long one");
    spec.outlines.push_back(sections);
    MapLayout layout;
    draw_map(spec, &layout);
    for (const std::string& name : sections.names) {
        const TextBox* found = nullptr;
        for (const TextBox& text : layout.texts)
            if (text.text == name) found = &text;
        ASSERT_NE(found, nullptr) << name;
        EXPECT_TRUE(found->box.inside(layout.map)) << name;
        for (const TextBox& text : layout.texts)
            EXPECT_TRUE(&text == found || !text.box.overlaps(found->box)) << name << " / " << text.text;
    }
}

}  // namespace
}  // namespace frana::render
