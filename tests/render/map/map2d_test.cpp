// SPDX-License-Identifier: Apache-2.0
#include "render/map/map2d.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "scenes.h"

namespace frana::render {
namespace {

using test::pixel;

const LegendEntry* entry(const MapLayout& layout, double value) {
    for (const LegendEntry& one : layout.legend) {
        if (one.lower <= value && value < one.upper) return &one;
    }
    return nullptr;
}

TEST(Map, EveryCellHasTheColourThatTheLegendGivesItsValue) {
    const Raster ground = test::terrain(), layer = test::tongue();
    MapSpec spec = test::full_map(ground, layer, 1000, 800);
    spec.outlines.clear();  // they would cover cells
    spec.contours = false;
    MapLayout layout;
    const Image map = draw_map(spec, &layout);
    int seen = 0;
    for (std::int64_t row = 0; row < layer.grid.rows; ++row) {
        for (std::int64_t column = 0; column < layer.grid.columns; ++column) {
            if (!layer.has_data(row, column)) continue;
            // Off the centre, where there could be a coordinate cross.
            Point at = layer.grid.cell_centre(row, column);
            at.x += layer.grid.cell_size / 8;
            at.y += layer.grid.cell_size / 8;
            const auto [x, y] = pixel(layout, at);
            const double between = interpolated(layer, at);  // its neighbours count as well
            const LegendEntry* legend = entry(layout, std::isnan(between) ? layer.at(row, column) : between);
            ASSERT_NE(legend, nullptr);
            if (test::shows(map.colour(x, y), legend->colour)) ++seen;
        }
    }
    // All except the cells covered by a thin coordinate cross.
    EXPECT_GE(seen, 20 * 65 - 30);
}

TEST(Map, LegendBoxesShowThePalettesColours) {
    const Raster ground = test::terrain(), layer = test::tongue();
    MapLayout layout;
    const Image map = draw_map(test::full_map(ground, layer, 1600, 1200), &layout);
    ASSERT_EQ(layout.legend.size(), 5U);  // 0, 2, ... 10 for 9.5 m
    for (std::size_t i = 0; i < layout.legend.size(); ++i) {
        const LegendEntry& one = layout.legend[i];
        // The greatest class is on top.
        const Rgb expected = test::in_legend(colour_at(palette("depth"), 1 - static_cast<double>(i) / 4));
        EXPECT_EQ(one.colour, expected);
        EXPECT_EQ(map.colour(static_cast<int>((one.box.left + one.box.right) / 2),
                             static_cast<int>((one.box.top + one.box.bottom) / 2)),
                  expected);
    }
    EXPECT_EQ(layout.legend.front().label, "8 – 10");
    EXPECT_EQ(layout.legend.back().label, "0 – 2");
}

double luminance(Rgb c) {
    const auto linear = [](std::uint8_t byte) { return std::pow(byte / 255.0, 2.2); };
    return 0.2126 * linear(c.r) + 0.7152 * linear(c.g) + 0.0722 * linear(c.b);
}
double contrast(Rgb a, Rgb b) {
    const double one = luminance(a) + 0.05, other = luminance(b) + 0.05;
    return std::max(one, other) / std::min(one, other);
}

// A road of the base map, the relief and a line of the surroundings are read under and over a red zone.
TEST(Map, WhatIsUnderAZoneIsSeenThroughIt) {
    const Raster ground = test::terrain(), layer(ground.grid, 1);
    MapSpec spec = test::full_map(ground, layer, 800, 600);
    spec.outlines = {{"Road", {}, {45, 45, 55}, 1.4, false}};
    spec.contours = false;
    spec.categories = {{1, "High", {215, 25, 28}}};
    spec.classes.clear();
    spec.outlines[0].lines = {{{527300, 5094700}, {527900, 5094700}}};
    spec.window = Bounds{527400, 5094300, 527800, 5094800};
    const double north = 5094500, half = 6;  // of the base map's road [m]
    spec.background = [&](const Bounds& box, int width, int height) {
        std::vector<std::uint8_t> rgba;
        for (int row = 0; row < height; ++row) {
            const double y = box.north - (row + 0.5) * box.height() / height;
            const std::uint8_t tone = std::abs(y - north) < half ? 20 : y > north ? 240 : 150;
            for (int column = 0; column < width; ++column) rgba.insert(rgba.end(), {tone, tone, tone, 255});
        }
        return rgba;
    };
    MapLayout layout;
    const Image map = draw_map(spec, &layout);
    const auto at = [&](double y) {
        return map.colour(static_cast<int>(layout.map.left + layout.map.width() * 0.37),
                          static_cast<int>(layout.map.top + (layout.window.north - y) / layout.metres_per_pixel));
    };
    const Rgb bright = at(north + 60), shady = at(north - 60), road = at(north);
    EXPECT_GT(contrast(bright, road), 2.5);
    EXPECT_GT(contrast(shady, road), 1.8);
    EXPECT_GT(contrast(bright, shady), 1.25) << "the relief";
    for (const Rgb zone : {bright, shady}) {
        EXPECT_GT(zone.r, 2 * zone.g) << "red remains red";
        EXPECT_GT(zone.r, 2 * zone.b);
    }
    Rgb darkest = bright;
    for (double y = 5094690; y < 5094710; y += 0.5)
        if (luminance(at(y)) < luminance(darkest)) darkest = at(y);
    EXPECT_GT(contrast(bright, darkest), 2.5) << "a thin line of the surroundings";
}

TEST(Map, NothingIsColouredWhereNothingFlowed) {
    const Raster ground = test::terrain(), layer = test::tongue();
    MapSpec spec = test::full_map(ground, layer, 800, 600);
    spec.outlines.clear();
    MapLayout layout;
    const Image map = draw_map(spec, &layout);
    for (int y = static_cast<int>(layout.map.top) + 3; y < layout.map.bottom - 3; ++y) {
        for (int x = static_cast<int>(layout.map.left) + 3; x < layout.map.right - 3; ++x) {
            const double east = layout.window.west + (x + 0.5 - layout.map.left) * layout.metres_per_pixel;
            const double north = layout.window.north - (y + 0.5 - layout.map.top) * layout.metres_per_pixel;
            const bool beside = east < 527500 - 2 || east > 527700 + 2 || north > 5094800 + 2 || north < 5094150 - 2;
            if (!beside) continue;
            const Rgb c = map.colour(x, y);
            ASSERT_LT(std::max({c.r, c.g, c.b}) - std::min({c.r, c.g, c.b}), 40) << x << ", " << y;  // grey relief
        }
    }
}

TEST(Map, TheFlowHasADarkEdgeOnTheGroundBesideIt) {
    const Raster ground = test::terrain(), layer = test::tongue();
    MapSpec spec = test::full_map(ground, layer, 1600, 1200);
    spec.outlines.clear();
    spec.contours = false;
    MapLayout layout;
    const Image map = draw_map(spec, &layout);
    spec.layer = nullptr;
    spec.classes = {0, 2, 4, 6, 8, 10};
    spec.window = layout.window;
    MapLayout bare_layout;
    const Image bare = draw_map(spec, &bare_layout);
    ASSERT_EQ(layout.map.left, bare_layout.map.left);
    int darker = 0, rows = 0;
    for (std::int64_t row = 25; row < 80; ++row) {
        const auto [x, y] = pixel(layout, {527500, layer.grid.cell_centre(row, 0).y});  // the tongue's western side
        const auto [bare_x, bare_y] = pixel(bare_layout, {527500, layer.grid.cell_centre(row, 0).y});
        ++rows;
        for (const int step : {-2, -1, 0, 1})
            if (map.colour(x + step, y).g < 0.6 * bare.colour(bare_x + step, bare_y).g &&
                map.colour(x + step, y).r < 0.6 * bare.colour(bare_x + step, bare_y).r) {
                ++darker;
                break;
            }
    }
    EXPECT_GT(darker, rows - 5);  // there may be a coordinate cross
}

TEST(Map, ScaleBarIsAsLongAsItsLabel) {
    const Raster ground = test::terrain(), layer = test::tongue();
    for (const auto& [width, height] : {std::pair{800, 600}, {1600, 1200}, {1234, 777}}) {
        MapLayout layout;
        const Image map = draw_map(test::full_map(ground, layer, width, height), &layout);
        // On the page: the bar's frame at both ends, thinner than a pixel on small pages, so any ink counts. Half a
        // pixel of frame and one of rounding.
        const int y = static_cast<int>((layout.scale_bar.top + layout.scale_bar.bottom) / 2);
        int first = -1, last = -1;
        for (int x = static_cast<int>(layout.map.right) + 2; x < width; ++x) {
            if (map.colour(x, y).r > 220) continue;
            if (first < 0) first = x;
            last = x;
        }
        const double grid_metres = (last - first) * layout.metres_per_pixel;
        EXPECT_NEAR(grid_metres, layout.scale_bar_metres, 1.5 * layout.metres_per_pixel);
        EXPECT_NEAR(layout.scale_bar.width() * layout.metres_per_pixel, layout.scale_bar_metres, 1e-6);
        // A round length, with its label.
        const double power = std::pow(10, std::floor(std::log10(layout.scale_bar_metres)));
        const double leading = layout.scale_bar_metres / power;
        EXPECT_TRUE(std::fabs(leading - 1) < 1e-9 || std::fabs(leading - 2) < 1e-9 || std::fabs(leading - 5) < 1e-9);
        const std::string words = std::to_string(static_cast<int>(layout.scale_bar_metres)) + " m";
        EXPECT_TRUE(std::any_of(layout.texts.begin(), layout.texts.end(), [&](const TextBox& text) {
            return text.text == words;
        })) << words;
    }
}

TEST(Map, AnOutlineIsWhereItsCoordinatesAre) {
    const Raster ground = test::terrain(), layer = test::tongue();
    MapSpec spec = test::full_map(ground, layer, 1200, 900);
    spec.outlines = {{"Scar", test::square({527600, 5094500}, 200), {200, 20, 30}, 3, false}};
    MapLayout layout;
    const Image map = draw_map(spec, &layout);
    for (const Point corner : {Point{527400, 5094437}, Point{527800, 5094611}, Point{527483, 5094700}}) {
        const auto [x, y] = pixel(layout, corner);
        EXPECT_TRUE(test::near(map.colour(x, y), {200, 20, 30}, 12)) << corner.x << " " << corner.y;
    }
}

TEST(Map, NorthArrowTurnsWithTheConvergence) {
    const Raster ground = test::terrain(), layer = test::tongue();
    for (const double angle : {0.0, 25.0, -25.0}) {
        MapSpec spec = test::full_map(ground, layer, 1600, 1200);
        spec.convergence_deg = angle;
        MapLayout layout;
        draw_map(spec, &layout);
        EXPECT_EQ(layout.north_arrow_deg, angle);
        const auto letter = std::find_if(layout.texts.begin(), layout.texts.end(),
                                         [](const TextBox& text) { return text.text == "N"; });
        ASSERT_NE(letter, layout.texts.end());
        const double x =
            (letter->box.left + letter->box.right) / 2 - (layout.north_arrow.left + layout.north_arrow.right) / 2;
        const double y =
            (layout.north_arrow.top + layout.north_arrow.bottom) / 2 - (letter->box.top + letter->box.bottom) / 2;
        // The letter is some 30 pixels from the centre; a pixel of rounding is two degrees there.
        EXPECT_NEAR(std::atan2(x, y) * 180 / std::numbers::pi, angle, 2.5);
        const bool is_named = std::any_of(layout.texts.begin(), layout.texts.end(),
                                          [](const TextBox& text) { return text.text.find("true north") == 0; });
        EXPECT_EQ(is_named, angle != 0);
    }
}

TEST(Map, AnEmptyLayerHasANote) {
    const Raster ground = test::terrain();
    const Raster empty(ground.grid, k_no_data);
    MapSpec spec = test::full_map(ground, empty, 800, 600);
    MapLayout layout;
    draw_map(spec, &layout);
    EXPECT_TRUE(layout.legend.empty());
    EXPECT_TRUE(std::any_of(layout.texts.begin(), layout.texts.end(),
                            [](const TextBox& text) { return text.text.find("no values") != std::string::npos; }));
}

TEST(Map, WithoutLayerOrWithoutTerrain) {
    const Raster ground = test::terrain(), layer = test::tongue();
    MapSpec bare;
    bare.terrain = &ground;
    bare.title = "Terrain";
    EXPECT_EQ(draw_map(bare).width, 1600);
    MapSpec flat;
    flat.layer = &layer;
    EXPECT_EQ(draw_map(flat).height, 1200);
}

TEST(Map, ContradictionsAreRefused) {
    const Raster ground = test::terrain(), layer = test::tongue();
    const auto refused = [](const MapSpec& spec) {
        try {
            draw_map(spec);
        } catch (const Error& error) {
            return error.kind() == ErrorKind::input;
        }
        return false;
    };
    EXPECT_TRUE(refused(MapSpec{}));
    MapSpec tiny = test::full_map(ground, layer, 100, 100);
    EXPECT_TRUE(refused(tiny));
    MapSpec crowded = test::full_map(ground, layer, 400, 300);
    crowded.side_notes.assign(60, "a line of figures");
    EXPECT_TRUE(refused(crowded));
    MapSpec unknown = test::full_map(ground, layer, 800, 600);
    unknown.palette = "rainbow";
    EXPECT_TRUE(refused(unknown));
    MapSpec window = test::full_map(ground, layer, 800, 600);
    window.window = Bounds{10, 10, 5, 20};
    EXPECT_TRUE(refused(window));
}

// Sources side by side on a strip of terrain: the frame is the strip's, with no grey round it, at the same scale.
TEST(Map2d, AFrameEndsWithTheTerrain) {
    const Raster ground = part_of(test::terrain(), CellWindow{30, 0, 30, 120});
    Raster layer(ground.grid, k_no_data);
    for (std::int64_t row = 5; row < 25; ++row) layer.at(row, 4) = layer.at(row, 115) = 2;
    for (const double dots_per_inch : {0.0, 150.0}) {
        MapSpec spec;
        spec.terrain = &ground;
        spec.layer = &layer;
        spec.width = 800;
        spec.height = 600;
        spec.print.dots_per_inch = dots_per_inch;
        MapLayout layout;
        const Image map = draw_map(spec, &layout);
        const Bounds all = ground.grid.bounds();
        const double pixel = layout.metres_per_pixel;
        EXPECT_NEAR(layout.window.width(), all.width(), 2 * pixel);
        EXPECT_NEAR(layout.window.height(), all.height(), 2 * pixel);
        EXPECT_NEAR(layout.map.width() * pixel, layout.window.width(), 1e-6);
        int grey = 0;
        for (int y = static_cast<int>(layout.map.top) + 3; y < layout.map.bottom - 3; ++y)
            for (int x = static_cast<int>(layout.map.left) + 3; x < layout.map.right - 3; ++x)
                grey += map.colour(x, y) == k_no_terrain;
        EXPECT_EQ(grey, 0);
    }
}

}  // namespace
}  // namespace frana::render
