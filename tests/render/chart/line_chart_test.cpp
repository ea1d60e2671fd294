// SPDX-License-Identifier: Apache-2.0
#include "render/chart/chart.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>

#include "core/raster.h"
#include "render/map/plate.h"
#include "scenes.h"

namespace frana::render {
namespace {

Chart chart() {
    Chart content{"A slope and its depth", "along the flow path", "profiles.csv", 1, {}};
    std::vector<Point> bed, depth;
    std::vector<double> foot;
    for (int i = 0; i <= 100; ++i) {
        bed.push_back({10.0 * i, 800 - 3.0 * i});
        depth.push_back({10.0 * i, i > 40 && i < 60 ? k_no_data : 5 + 4 * std::sin(i / 10.0)});
        foot.push_back(0);
    }
    content.panels = {
        {"Bed", "distance [m]", "elevation [m]", {{"bed", {90, 70, 50}, bed}}},
        {"Depth", "distance [m]", "depth [m]", {{"maximum", {0, 114, 178}, depth, 2, Stroke::solid, foot}}, {0}}};
    return content;
}

TEST(LineChart, PointsAreWhereTheAxesPutThem) {
    ChartLayout layout;
    draw_chart(chart(), 1600, 1200, &layout);
    ASSERT_EQ(layout.panels.size(), 2U);
    ASSERT_EQ(layout.points.size(), 2U);
    // Straight in data, straight on the page; with its ends at the panel's sides.
    const std::vector<Point>& bed = layout.points[0];
    ASSERT_EQ(bed.size(), 101U);
    EXPECT_NEAR(bed.front().x, layout.panels[0].left, 1e-6);
    EXPECT_NEAR(bed.back().x, layout.panels[0].right, 1e-6);
    EXPECT_NEAR(bed[50].y, (bed[0].y + bed[100].y) / 2, 1e-6);
    // 800 and 500 m are read from the labels: the tick of 700 is at a third of the distance.
    const auto tick = std::find_if(layout.texts.begin(), layout.texts.end(), [&](const TextBox& text) {
        return text.text == "700" && text.box.right < layout.panels[0].left;
    });
    ASSERT_NE(tick, layout.texts.end());
    EXPECT_NEAR((tick->box.top + tick->box.bottom) / 2, bed[0].y + (bed[100].y - bed[0].y) / 3, 1.5);
    EXPECT_EQ(layout.points[1].size(), 101U - 19U);  // gaps are not drawn
}

TEST(LineChart, TextsAreTidyAtAllSizes) {
    for (const auto& [width, height] : {std::pair{800, 600}, {1600, 1200}, {1280, 960}, {1240, 1754}, {3508, 2480}}) {
        ChartLayout layout;
        draw_chart(chart(), width, height, &layout);
        const PageBox page{0, 0, static_cast<double>(width), static_cast<double>(height)};
        for (std::size_t i = 0; i < layout.texts.size(); ++i) {
            EXPECT_TRUE(layout.texts[i].box.inside(page)) << layout.texts[i].text;
            for (std::size_t j = 0; j < i; ++j) {
                EXPECT_FALSE(layout.texts[i].box.overlaps(layout.texts[j].box))
                    << width << ": " << layout.texts[i].text << " / " << layout.texts[j].text;
            }
            for (const PageBox& panel : layout.panels) EXPECT_FALSE(layout.texts[i].box.overlaps(panel));
        }
    }
}

TEST(LineChart, ACurveIsDrawnInItsColour) {
    ChartLayout layout;
    const Image page = draw_chart(chart(), 1600, 1200, &layout);
    const Point at = layout.points[0][37];
    EXPECT_TRUE(test::near(page.colour(static_cast<int>(at.x), static_cast<int>(at.y)), {90, 70, 50}, 40));
}

TEST(Plate, PartsAreInRowsUnderTheTitle) {
    Plate plate{"Four parts", "", "foot", 2, {}};
    const std::vector<Rgb> colours{{200, 0, 0}, {0, 200, 0}, {0, 0, 200}, {200, 200, 0}};
    for (const Rgb colour : colours)
        plate.parts.push_back([colour](int width, int height) {
            Page part(width, height);
            part.put(Image(width, height, colour), 0, 0);
            return part;
        });
    std::vector<TextBox> texts;
    const Image page = draw_plate(plate, 1000, 800, &texts).paint();
    EXPECT_EQ(page.colour(250, 250), colours[0]);
    EXPECT_EQ(page.colour(750, 250), colours[1]);
    EXPECT_EQ(page.colour(250, 650), colours[2]);
    EXPECT_EQ(page.colour(750, 650), colours[3]);
    for (const TextBox& text : texts)
        EXPECT_TRUE(page.colour(5, static_cast<int>(text.box.top)) == (Rgb{255, 255, 255})) << text.text;
}

// 640 x 480 is the smallest size of --size: two rows and the title leave less than a map needs.
TEST(Plate, GrowsIfPartsWouldBeTooSmallToDraw) {
    Plate plate{"Four parts", "below a title", "foot", 2, {}};
    int least_width = 10000, least_height = 10000;
    for (int part = 0; part < 4; ++part) {
        plate.parts.push_back([&](int width, int height) {
            least_width = std::min(least_width, width);
            least_height = std::min(least_height, height);
            return Page(width, height);
        });
    }
    const Image page = draw_plate(plate, 640, 480).paint();
    EXPECT_EQ(least_width, 480);
    EXPECT_EQ(least_height, 360);
    EXPECT_EQ(page.width, 960);
    EXPECT_GT(page.height, 720);
}

// Without its colour: stroke and marker.
TEST(LineChart, CurvesLookApartInGrey) {
    std::set<std::pair<Stroke, int>> looks;
    for (std::size_t i = 0; i < 20; ++i) {
        ChartSeries curve;
        look_apart(curve, i);
        looks.insert({curve.stroke, curve.marker ? static_cast<int>(*curve.marker) : -1});
        EXPECT_EQ(curve.marker.has_value(), curve.marker_gap_px > 0) << "a curve of many points is not a smear";
    }
    EXPECT_EQ(looks.size(), 20U);
}

TEST(LineChart, MarkersOfACurveOfManyPointsAreFew) {
    Chart content{"", "", "", 1, {}};
    ChartSeries curve;
    for (int i = 0; i <= 2000; ++i) curve.points.push_back({static_cast<double>(i), 0});
    look_apart(curve, 4);
    content.panels = {{"", "x", "y", {curve}, {-1, 1}}};
    const std::string svg = chart_svg(content, 1600, 1200);
    std::size_t markers = 0;
    for (std::size_t at = svg.find("<polygon"); at != std::string::npos; at = svg.find("<polygon", at + 1)) ++markers;
    EXPECT_GE(markers, 4U);
    EXPECT_LE(markers, 12U);
}

}  // namespace
}  // namespace frana::render
