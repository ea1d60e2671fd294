// SPDX-License-Identifier: Apache-2.0
// No text is cut off or covers another, at any size and with any content of a map.
#include <gtest/gtest.h>

#include "render/animation/animation.h"
#include "render/chart/chart.h"
#include "render/map/map2d.h"
#include "render/view/view3d.h"
#include "scenes.h"

namespace frana::render {
namespace {

int dark_pixels(const Image& image, const PageBox& box) {
    int count = 0;
    for (int y = static_cast<int>(box.top); y < static_cast<int>(box.bottom); ++y) {
        for (int x = static_cast<int>(box.left); x < static_cast<int>(box.right); ++x) {
            const Rgb c = image.colour(x, y);
            count += c.r < 160 && c.g < 160 && c.b < 160 ? 1 : 0;
        }
    }
    return count;
}

void expect_tidy(const std::vector<TextBox>& texts, const PageBox& page, const Image& image) {
    for (std::size_t i = 0; i < texts.size(); ++i) {
        EXPECT_TRUE(texts[i].box.inside(page)) << texts[i].text;
        EXPECT_GE(texts[i].size_px, 9) << texts[i].text;  // DejaVu is legible from 9 pixels on
        // Rotated or upright, letters ink at least one pixel in twelve of their box.
        EXPECT_GT(dark_pixels(image, texts[i].box), texts[i].box.width() * texts[i].box.height() / 12) << texts[i].text;
        for (std::size_t j = 0; j < i; ++j) {
            EXPECT_FALSE(texts[i].box.overlaps(texts[j].box)) << texts[i].text << " / " << texts[j].text;
        }
    }
}

class AtSize : public testing::TestWithParam<std::pair<int, int>> {};

TEST_P(AtSize, MapsWithEverythingAreTidy) {
    const Raster ground = test::terrain(), layer = test::tongue();
    const auto [width, height] = GetParam();
    MapSpec spec = test::crowded_map(ground, layer, width, height);
    spec.title = "Maximum flow depth of the rock slide above the village in the second scenario";
    spec.attribution = "frana 0.1.0, terrain of the regional survey of 2019, not for construction; file max_depth.tif";
    MapLayout layout;
    const Image map = draw_map(spec, &layout);
    expect_tidy(layout.texts, layout.page, map);
    EXPECT_TRUE(layout.map.inside(layout.page));
    EXPECT_GT(layout.map.width() * layout.map.height(), 0.25 * width * height) << "the map itself must stay large";
    for (const LegendEntry& one : layout.legend) {
        EXPECT_TRUE(one.box.inside(layout.page));
        EXPECT_FALSE(one.box.overlaps(layout.map));
        for (const TextBox& text : layout.texts) EXPECT_FALSE(one.box.overlaps(text.box)) << text.text;
    }
    for (const TextBox& text : layout.texts) {
        // A text is inside the map or outside, never across the frame.
        EXPECT_TRUE(text.box.inside(layout.map) || !text.box.overlaps(layout.map)) << text.text;
        EXPECT_FALSE(text.box.overlaps(layout.scale_bar)) << text.text;
    }
    EXPECT_FALSE(layout.north_arrow.overlaps(layout.scale_bar));
    EXPECT_FALSE(layout.north_arrow.overlaps(layout.map));
}

TEST_P(AtSize, ViewsAreTidy) {
    const Raster ground = test::terrain(), layer = test::tongue();
    const auto [width, height] = GetParam();
    const MapSpec map = test::full_map(ground, layer, width, height);
    ViewSpec spec;
    spec.title = map.title;
    spec.subtitle = map.subtitle;
    spec.legend_title = map.legend_title;
    spec.unit = map.unit;
    spec.crs_label = map.crs_label;
    spec.terrain = &ground;
    spec.layer = &layer;
    spec.outlines = map.outlines;
    spec.side_notes = map.side_notes;
    spec.width = width;
    spec.height = height;
    ViewLayout layout;
    const Image view = draw_view(spec, &layout);
    expect_tidy(layout.texts, layout.page, view);
    for (const TextBox& text : layout.texts) EXPECT_FALSE(text.box.overlaps(layout.picture)) << text.text;
}

/// Everything a run can put on a map: every kind of outline, all values, an animation's pace, long texts.
MapSpec fullest_map(const Raster& ground, const Raster& layer, int width, int height) {
    MapSpec spec = test::crowded_map(ground, layer, width, height);
    spec.title = std::string(119, 'w') + "\u2026: Maximum energy head";
    spec.attribution = std::string(400, 'w');
    spec.outlines.clear();
    for (const char* label :
         {"Friction zones", "Obstacles", "Walls", "Profiles", "Cross-sections", "Gauges", "Release", "Surveyed scar"})
        spec.outlines.push_back({label, test::square({527600, 5094700}, 80), {200, 20, 30}, 2.5, true});
    spec.side_notes = {
        "Volume 1 200 000 m³",   "Covered 1 200 000 m²", "(deeper than 0.1 m)",     "Run-out 12 345 m",
        "Drop 1 234 m",          "Angle of reach 21.3°", "Still moving at the end", "1 200 000 m³ left the map",
        "1 s of playback: 100 s"};
    return spec;
}

// The smallest and the most oblong pages that output.map-size accepts, and their animations: what is accepted can be
// drawn, also at the end of a run of days.
TEST(OnSmallPages, EverythingFits) {
    const Raster ground = test::terrain(), layer = test::tongue();
    for (const auto& [width, height] : {std::pair{640, 480}, {1280, 480}, {8000, 480}, {640, 8000}}) {
        SCOPED_TRACE(std::to_string(width) + " x " + std::to_string(height));
        MapSpec spec = fullest_map(ground, layer, width, height);
        MapLayout layout;
        const Image map = draw_map(spec, &layout);
        expect_tidy(layout.texts, layout.page, map);
        EXPECT_NO_THROW(MapAnimator(spec).frame(layer, "t = 1234.5 s"));
        for (int i = 1; i <= 4; ++i) {
            const std::string label = "Class " + std::to_string(i) + ": strong, over 2 m";
            spec.categories.push_back({static_cast<double>(i), label, {9, 9, 9}});
        }
        EXPECT_NO_THROW(draw_map(spec));
        ViewSpec view;
        view.title = spec.title;
        view.legend_title = spec.legend_title;
        view.attribution = spec.attribution;
        view.terrain = &ground;
        view.layer = &layer;
        view.outlines = spec.outlines;
        view.side_notes = spec.side_notes;
        view.width = width;
        view.height = height;
        EXPECT_NO_THROW(draw_view(view));
        EXPECT_NO_THROW(ViewAnimator(view).frame(layer, "t = 1234.5 s"));
    }
}

/// A3 at 300 dpi, once: it takes as long as all the others.
TEST(AtPrintSize, MapsAreTidy) {
    const Raster ground = test::terrain(), layer = test::tongue();
    MapLayout layout;
    const Image map = draw_map(test::crowded_map(ground, layer, 4961, 3508), &layout);
    expect_tidy(layout.texts, layout.page, map);
}

TEST_P(AtSize, ChartsAreTidy) {
    const auto [width, height] = GetParam();
    Chart chart{"Rock slide above the village in the second scenario: profile along the flow path",
                "Voellmy-Bingham, scheme default, 20 s simulated",
                "profiles.csv  ·  survey of 2019",
                1,
                {}};
    const auto curve = [](const std::string& label, double factor) {
        ChartSeries one{label, {0, 114, 178}, {}};
        for (int i = 0; i <= 100; ++i) one.points.push_back({5.0 * i, 600 + factor * i});
        return one;
    };
    for (const char* title : {"Surfaces", "Depths, vertical", "Greatest speed, along the bed"}) {
        chart.panels.push_back({title,
                                "distance along the line [m]",
                                "elevation [m]",
                                {curve("final surface", 1), curve("initial surface", 2),
                                 curve("bed plus maximum depth", 3), curve("bed", 0.5)}});
    }
    ChartLayout layout;
    const Image image = draw_chart(chart, width, height, &layout);
    const PageBox page{0, 0, static_cast<double>(width), static_cast<double>(height)};
    expect_tidy(layout.texts, page, image);
    for (const TextBox& text : layout.texts)
        for (const PageBox& panel : layout.panels) EXPECT_FALSE(text.box.overlaps(panel)) << text.text;
}

INSTANTIATE_TEST_SUITE_P(Sizes, AtSize,
                         testing::Values(std::pair{800, 600}, std::pair{1600, 1200}, std::pair{1280, 720},
                                         std::pair{640, 480}, std::pair{900, 1200}, std::pair{2400, 1000},
                                         std::pair{1754, 1240}, std::pair{1240, 1754},  // A4 at 150 dpi
                                         std::pair{3508, 2480},                         // A4 at 300 dpi
                                         std::pair{2480, 1754}),                        // A3 at 150 dpi
                         [](const auto& size) {
                             return std::to_string(size.param.first) + "x" + std::to_string(size.param.second);
                         });

}  // namespace
}  // namespace frana::render
