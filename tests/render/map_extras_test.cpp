// SPDX-License-Identifier: Apache-2.0
// Places and lines, series of maps and views, and a user's picture as background.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "render/animation/animation.h"
#include "render/map/map2d.h"
#include "render/view/view3d.h"
#include "scenes.h"

namespace frana::render {
namespace {

using test::pixel;

TEST(Places, AreDrawnWithTheirNames) {
    const Raster ground = test::terrain(), layer = test::tongue();
    MapSpec spec = test::crowded_map(ground, layer, 1600, 1200);
    MapLayout layout;
    const Image map = draw_map(spec, &layout);
    for (const NamedPlace& one : spec.outlines[2].places) {
        const auto [x, y] = pixel(layout, one.place);
        EXPECT_TRUE(test::near(map.colour(x, y), {150, 0, 60}, 12)) << one.name;
        const auto text = std::find_if(layout.texts.begin(), layout.texts.end(),
                                       [&](const TextBox& box) { return box.text == one.name; });
        ASSERT_NE(text, layout.texts.end()) << one.name;
        const double away =
            std::max({text->box.left - x, x - text->box.right, text->box.top - y, y - text->box.bottom});
        EXPECT_LT(away, 2 * layout.font_px) << one.name;
    }
    const auto [x, y] = pixel(layout, {527605, 5094410});  // on the section
    bool found = false;
    for (int shift = -2; shift <= 2; ++shift) found = found || test::near(map.colour(x, y + shift), {70, 50, 120}, 25);
    EXPECT_TRUE(found);
}

TEST(Background, IsUnderTheMapInItsPlaceAndTheLayerOverIt) {
    const Raster ground = test::terrain(), layer = test::tongue();
    MapSpec spec = test::full_map(ground, layer, 1000, 800);
    spec.outlines.clear();
    spec.contours = false;
    // Green west of 527300, nothing north of 5094900, blue elsewhere.
    spec.background = [](const Bounds& window, int width, int height) {
        std::vector<std::uint8_t> picture;
        for (int row = 0; row < height; ++row) {
            for (int column = 0; column < width; ++column) {
                const double x = window.west + (column + 0.5) * window.width() / width;
                const double y = window.north - (row + 0.5) * window.height() / height;
                const bool there = y < 5094900, west = x < 527300;
                for (const int v : {0, there && west ? 200 : 0, there && !west ? 200 : 0, there ? 255 : 0})
                    picture.push_back(static_cast<std::uint8_t>(v));
            }
        }
        return picture;
    };
    spec.window = Bounds{527050, 5094050, 527950, 5094950};
    MapLayout layout;
    const Image map = draw_map(spec, &layout);
    const auto at = [&](double x, double y) {
        const auto [column, row] = pixel(layout, {x, y});
        return map.colour(column, row);
    };
    const Rgb west = at(527277, 5094333), east = at(527323, 5094333), north = at(527277, 5094922);
    EXPECT_GT(west.g, west.b + 100);
    EXPECT_GT(east.b, east.g + 100);
    EXPECT_NEAR(north.r, north.g, 3);  // the background without terrain is visible
    const Rgb flow = at(layer.grid.cell_centre(52, 59).x + 2, layer.grid.cell_centre(52, 59).y + 2);
    EXPECT_TRUE(test::shows(flow, layout.legend.front().colour));
}

TEST(MapSeries, SharesTheGroundAndDrawsWhatSingleMapsShow) {
    const Raster ground = test::terrain(), deep = test::tongue(), shallow = test::tongue(2);
    MapSpec first = test::full_map(ground, deep, 800, 600), second = test::full_map(ground, shallow, 800, 600);
    second.legend_title = "Velocity";
    second.palette = "velocity";
    first.extent = second.extent = &deep;
    MapSeries series;
    MapLayout shared, alone;
    EXPECT_EQ(series.draw(first).paint().rgb, draw_map(first).rgb);
    EXPECT_EQ(series.draw(second, &shared).paint().rgb, draw_map(second, &alone).rgb);
    EXPECT_EQ(shared.texts.size(), alone.texts.size());
    EXPECT_EQ(shared.window.west, alone.window.west);
    second.outlines.pop_back();  // different ground
    EXPECT_EQ(series.draw(second).paint().rgb, draw_map(second).rgb);
}

TEST(MapSeries, AnExtentFixesTheWindow) {
    const Raster ground = test::terrain(), all = test::tongue();
    Raster part = all;
    for (std::int64_t row = 0; row < 60; ++row)
        for (std::int64_t column = 0; column < part.grid.columns; ++column) part.at(row, column) = k_no_data;
    MapSpec spec = test::full_map(ground, part, 800, 600);
    spec.outlines.clear();
    spec.extent = &all;
    MapLayout of_part, of_all;
    draw_map(spec, &of_part);
    spec.layer = &all;
    draw_map(spec, &of_all);
    EXPECT_EQ(of_part.window.north, of_all.window.north);
    EXPECT_EQ(of_part.window.west, of_all.window.west);
}

TEST(ViewSeries, SharesTheTerrainAndDrawsWhatSingleViewsShow) {
    const Raster ground = test::terrain(), deep = test::tongue();
    ViewSpec first;
    first.legend_title = "Depth";
    first.terrain = &ground;
    first.layer = first.thickness = first.extent = &deep;
    first.outlines = test::full_map(ground, deep, 640, 480).outlines;
    first.width = 640;
    first.height = 480;
    ViewSpec second = first;
    second.thickness = nullptr;
    second.legend_title = "A longer title of the legend";
    second.sky = false;
    ViewSeries series;
    EXPECT_EQ(series.draw(first).paint().rgb, draw_view(first).rgb);
    EXPECT_EQ(series.draw(second).paint().rgb, draw_view(second).rgb);
    EXPECT_EQ(series.draw(first).paint().rgb, draw_view(first).rgb);
}

TEST(Dots, AreWhereTheirParticlesAreInTheLegendsColours) {
    const Raster ground = test::terrain(), extent = test::tongue();
    const Dots dots{{{{527600, 5094500}, 1, 1}, {{527560, 5094300}, 1, 7}, {{527560, 5094301}, 1, 3}}, 12};
    MapSpec spec = test::full_map(ground, extent, 800, 600);
    spec.layer = nullptr;
    spec.extent = &extent;
    spec.outlines.clear();
    spec.contours = false;
    spec.classes = {0, 2, 4, 8};
    spec.dots = &dots;
    MapLayout layout;
    const Image map = draw_map(spec, &layout);
    const auto pixel = [&](Point place) {
        return map.colour(static_cast<int>(layout.map.left + (place.x - layout.window.west) / layout.metres_per_pixel),
                          static_cast<int>(layout.map.top + (layout.window.north - place.y) / layout.metres_per_pixel));
    };
    ASSERT_EQ(layout.legend.size(), 3U);  // the greatest on top
    EXPECT_EQ(pixel({527600, 5094500}), layout.legend[2].colour);
    EXPECT_EQ(pixel({527560, 5094298}), layout.legend[1].colour) << "the later dot covers the earlier one";
    EXPECT_NE(pixel({527600, 5094514}), layout.legend[2].colour) << "8 m beyond the dot's rim";
}

TEST(Dots, AreDrawnInViewsWithoutThoseOfTheFrameBefore) {
    const Raster ground = test::terrain(), extent = test::tongue();
    Dots left{{}, 20}, right{{}, 20};
    for (int i = 0; i < 20; ++i) {
        left.dots.push_back({{527540, 5094300 + 20.0 * i}, 2, 7});
        right.dots.push_back({{527660, 5094300 + 20.0 * i}, 2, 1});
    }
    ViewSpec spec;
    spec.legend_title = "Speed";
    spec.terrain = &ground;
    spec.layer = spec.extent = &extent;
    spec.classes = {0, 2, 4, 8};
    spec.width = 640;
    spec.height = 480;
    ViewSpec alone = spec;
    alone.layer = nullptr;
    alone.dots = &left;
    ViewLayout layout;
    const Image picture = draw_view(alone, &layout);
    const auto count = [&](const Image& image, Rgb colour) {
        int n = 0;
        for (int y = static_cast<int>(layout.picture.top); y < static_cast<int>(layout.picture.bottom); ++y)
            for (int x = static_cast<int>(layout.picture.left); x < static_cast<int>(layout.picture.right); ++x)
                n += image.colour(x, y) == colour ? 1 : 0;
        return n;
    };
    const Rgb slow = layout.legend.back().colour, fast = layout.legend.front().colour;
    EXPECT_GT(count(picture, fast), 100);
    EXPECT_EQ(count(picture, slow), 0);
    ViewAnimator animation(spec);
    animation.frame(left, "t = 0 s");
    const Image second = animation.frame(right, "t = 1 s");
    EXPECT_EQ(count(second, fast), 0);
    // The animation's scale is open above: its slowest class has the same colour only if both scales begin at the same
    // value.
    EXPECT_GT(count(second, slow), 100);
    EXPECT_THROW(animation.frame(Dots{{{{527600, 5094500}, 0, -1}}, 1}, ""), Error)
        << "a speed that the legend has not";
}

}  // namespace
}  // namespace frana::render
