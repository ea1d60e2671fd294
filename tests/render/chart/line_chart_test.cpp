// SPDX-License-Identifier: Apache-2.0
#include "render/chart/chart.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>

#include "core/raster.h"
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
    const std::string k_filled = "fill:rgb(35.29%,27.45%,19.60%)";  // the fifth colour
    std::size_t markers = 0;
    for (std::size_t at = svg.find(k_filled); at != std::string::npos; at = svg.find(k_filled, at + 1)) ++markers;
    EXPECT_GE(markers, 4U);
    EXPECT_LE(markers, 12U);
}

}  // namespace
}  // namespace frana::render
