// SPDX-License-Identifier: Apache-2.0
#include "render/chart/chart.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace frana::render {
namespace {

TEST(Decades, AreNeverEmpty) {
    EXPECT_EQ(decades_of({10}).high - decades_of({10}).low, 1);
    EXPECT_EQ(decades_of({}).high - decades_of({}).low, 1);
    const Decades d = decades_of({0, -1, std::numeric_limits<double>::quiet_NaN(), 5});
    EXPECT_EQ(d.low, 0);
    EXPECT_EQ(d.high, 1);
}

Chart two_panels() {
    const auto series = [](const char* label, Rgb colour, Marker marker, const std::vector<Point>& points) {
        ChartSeries one{label, colour, points};
        one.marker = marker;
        return one;
    };
    const Rgb blue{0, 90, 181}, red{220, 50, 32};
    Chart chart{"Errors", "of two schemes", "", 2, {}, true};
    chart.panels = {{"first",
                     "time [s]",
                     "error [-]",
                     {series("one", blue, Marker::circle, {{0.1, 0.1}, {1, 0.01}, {10, 0.001}}),
                      series("other", red, Marker::square, {{0.1, 0.5}, {1, 0.4}, {10, 0.3}})}},
                    {"second", "time [s]", "error [-]", {series("one", blue, Marker::circle, {{1, 0}, {2, -3}})}}};
    for (ChartPanel& panel : chart.panels) panel.x = panel.y = Scale::decades;
    chart.panels[1].note = "no error to show";
    return chart;
}

TEST(Chart, PutsPointsWhereTheAxesDo) {
    ChartLayout layout;
    draw_chart(two_panels(), 1000, 600, &layout);
    ASSERT_EQ(layout.panels.size(), 2u);
    ASSERT_EQ(layout.points.size(), 3u);
    const PageBox& box = layout.panels[0];
    const auto& one = layout.points[0];
    ASSERT_EQ(one.size(), 3u);
    // 0.1 to 10 s and 0.001 to 1: the corners and the middle, to rounding.
    EXPECT_NEAR(one[0].x, box.left, 1e-9);
    EXPECT_NEAR(one[1].x, (box.left + box.right) / 2, 1e-9);
    EXPECT_NEAR(one[2].x, box.right, 1e-9);
    EXPECT_NEAR(one[2].y, box.bottom, 1e-9);
    EXPECT_NEAR(one[0].y, box.top + box.height() / 3, 1e-9);
    EXPECT_TRUE(layout.points[2].empty()) << "values that have no logarithm must be left out";
}

// Figures of runs that differ by rounding alone: steps of 1e-15 gave ticks until all memory was used.
TEST(Chart, ValuesThatDifferByRoundingAreDrawn) {
    Chart chart{"", "", "", 1, {}, false, Words()};
    ChartSeries series{"", {0, 0, 0}, {}};
    series.points = {{15.170220189885796, 0}, {15.170220189885798, 1}};
    chart.panels.push_back({"", "x", "y", {series}});
    EXPECT_LT(chart_svg(chart, 400, 300).size(), 100'000U);
}

TEST(Chart, ALongNameOfAnAxisIsWhole) {
    const std::string name = "front from the release's centroid [m]";  // longer than the axis
    Chart chart;
    chart.panels = {{"", "time [s]", name, {{"", k_chart_colours[0], {{0, 0}, {1, 1}}}}}};
    ChartLayout layout;
    draw_chart(chart, 360, 180, &layout);
    const PageBox page{0, 0, 360, 180};
    bool found = false;
    for (const TextBox& text : layout.texts) {
        EXPECT_TRUE(text.box.inside(page)) << text.text;
        found = found || (text.text == name && text.box.height() > layout.panels[0].height());
    }
    EXPECT_TRUE(found);
}

TEST(Chart, NamesAxesPanelsAndSeriesOnThePage) {
    ChartLayout layout;
    draw_chart(two_panels(), 1000, 600, &layout);
    const PageBox page{0, 0, 1000, 600};
    for (const std::string word :
         {"Errors", "time [s]", "error [-]", "first", "second", "one", "other", "0.1", "no error to show"}) {
        const auto found = std::find_if(layout.texts.begin(), layout.texts.end(),
                                        [&](const TextBox& box) { return box.text == word; });
        ASSERT_NE(found, layout.texts.end()) << word;
        EXPECT_TRUE(found->box.inside(page)) << word;
    }
    EXPECT_EQ(
        std::count_if(layout.texts.begin(), layout.texts.end(), [](const TextBox& box) { return box.text == "one"; }),
        1)
        << "a label common to panels appears once";
}

// Less than a decade, or one: enough numbers to read a value, none over another.
TEST(ChartAxis, LogarithmicAxesHaveEnoughLabels) {
    constexpr double k_length = 400, k_room = 40;
    const std::vector<std::vector<double>> ranges{{110, 980},   {20, 80},     {0.21, 0.4}, {6.1, 6.9},
                                                  {1.2e5, 9e5}, {1e-7, 1e-1}, {3, 4e5},    {1, 10}};
    for (const Scale scale : {Scale::logarithmic, Scale::decades})
        for (const std::vector<double>& range : ranges) {
            const ChartAxis axis(scale, range, 0, k_length, k_room, false);
            std::vector<Tick> labelled;
            for (const Tick& tick : axis.ticks())
                if (!tick.words.empty()) labelled.push_back(tick);
            const std::string place = std::to_string(range[0]) + " to " + std::to_string(range[1]);
            EXPECT_GE(labelled.size(), 3U) << place;
            for (std::size_t i = 1; i < labelled.size(); ++i)
                EXPECT_GE(labelled[i].at - labelled[i - 1].at, k_room) << place << ": " << labelled[i].words;
        }
    const ChartAxis axis(Scale::logarithmic, {1.2e5, 9e5}, 0, k_length, k_room, false);
    std::vector<std::string> words;
    for (const Tick& tick : axis.ticks())
        if (!tick.words.empty()) words.push_back(tick.words);
    EXPECT_EQ(words, (std::vector<std::string>{"200 000", "300 000", "500 000", "700 000"}));
}

TEST(ChartAxis, GreatNumbersAreInGroups) {
    const ChartAxis axis(Scale::linear, {0, 290000}, 0, 400, 90, true);
    EXPECT_EQ(axis.ticks().back().words, "300 000");
}

TEST(Chart, InksTheSeriesInTheirColours) {
    ChartLayout layout;
    const Image page = draw_chart(two_panels(), 1000, 600, &layout);
    const Point at = layout.points[1][1];
    EXPECT_EQ(page.colour(static_cast<int>(at.x), static_cast<int>(at.y)), (Rgb{220, 50, 32}));
}

// The same page, for a browser.
TEST(Chart, AsSvgHasTheSamePlacesAndNames) {
    ChartLayout picture, element;
    draw_chart(two_panels(), 1000, 600, &picture);
    Chart chart = two_panels();
    const std::string svg = chart_svg(chart, 1000, 600, &element);
    ASSERT_EQ(element.points.size(), picture.points.size());
    for (std::size_t i = 0; i < picture.points.size(); ++i)
        EXPECT_EQ(element.points[i].size(), picture.points[i].size());
    for (const TextBox& text : picture.texts)
        EXPECT_NE(svg.find(">" + text.text + "</text>"), std::string::npos) << text.text;
    EXPECT_EQ(svg.rfind("<svg ", 0), 0U);
    EXPECT_TRUE(svg.ends_with("</svg>\n"));
    chart.panels[0].title = "a < b & \"c\"";
    EXPECT_NE(chart_svg(chart, 1000, 600).find(">a &lt; b &amp; &quot;c&quot;</text>"), std::string::npos);
}

// Bars in rows: all of them inside the frame, with no numbers along y.
TEST(Chart, RowsAreInsideTheFrameAndHaveNoNumbers) {
    Chart chart{"", "", "", 1, {{"", "correlation [-]", "", {}}}};
    ChartPanel& panel = chart.panels[0];
    panel.has_rows = true;
    panel.on_y = {0.5, 2.5};
    panel.on_x = {-1.05, 1.05};
    for (const double row : {1.0, 2.0}) panel.series.push_back({"", {0, 114, 178}, {{0, row}, {1, row}}, 14});
    ChartLayout layout;
    const std::string svg = chart_svg(chart, 560, 240, &layout);
    for (const auto& bar : layout.points) {
        for (const Point end : bar) {
            EXPECT_GT(end.y, layout.panels[0].top + 14);
            EXPECT_LT(end.y, layout.panels[0].bottom - 14);
            EXPECT_LT(end.x, layout.panels[0].right - 2);
        }
    }
    EXPECT_NE(svg.find(">0.5</text>"), std::string::npos);  // along x
    EXPECT_EQ(svg.find(">1.5</text>"), std::string::npos);
    EXPECT_EQ(svg.find(">2</text>"), std::string::npos);
}

// A run has one row per step.
TEST(Chart, ALineOfManyPointsKeepsItsPeaksAndIsSmall) {
    Chart chart{"", "", "", 1, {{"", "time [s]", "speed [m/s]", {{"", {0, 114, 178}, {}}}, {0}}}};
    constexpr int k_count = 1'000'000;
    for (int i = 0; i < k_count; ++i)
        chart.panels[0].series[0].points.push_back({1e-3 * i, i == 123'456 ? 50 : std::sin(0.1 * i)});
    ChartLayout layout;
    const std::string svg = chart_svg(chart, 560, 240, &layout);
    EXPECT_LT(svg.size(), 200'000U);
    double top = 240;
    for (const Point p : layout.points[0]) top = std::min(top, p.y);
    char peak[32];
    std::snprintf(peak, sizeof peak, " %.4g", top - 0.005);  // the letters of the drawing's paths are cut off there
    EXPECT_NE(svg.find(peak), std::string::npos) << peak;
}

}  // namespace
}  // namespace frana::render
