// SPDX-License-Identifier: Apache-2.0
#include "render/view/view3d.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "render/view/view_ground.h"
#include "scenes.h"

namespace frana::render {
namespace {

ViewSpec view(const Raster& ground, const Raster& layer) {
    ViewSpec spec;
    spec.title = "Maximum depth";
    spec.legend_title = "Maximum depth";
    spec.unit = std::string("m");  // from a literal, GCC 12 warns of an impossible overlap
    spec.terrain = &ground;
    spec.layer = &layer;
    spec.width = 800;
    spec.height = 600;
    return spec;
}

TEST(View, TheFlowFillsThePictureAndIsInsideIt) {
    const Raster ground = test::terrain(), layer = test::tongue();
    ViewLayout layout;
    const Image image = draw_view(view(ground, layer), &layout);
    EXPECT_EQ(image.width, 800);
    EXPECT_TRUE(layout.flow.inside(layout.picture));
    const double fraction =
        std::max(layout.flow.width() / layout.picture.width(), layout.flow.height() / layout.picture.height());
    EXPECT_NEAR(fraction, 0.8, 0.01);  // the margin that place_camera leaves
}

TEST(View, AGivenCameraBehindTheSlopeIsRaisedOverIt) {
    const Raster ground = test::terrain(), layer = test::tongue();  // runs down to the south
    ViewSpec spec = view(ground, layer);
    spec.vertical_exaggeration = 3;
    ViewLayout layout;
    spec.camera = Camera{180, 10, 1};  // from the north, under the slope's surface
    draw_view(spec, &layout);
    EXPECT_GT(layout.camera.elevation_deg, 20);
    spec.camera = Camera{0, 30, 1};
    draw_view(spec, &layout);
    EXPECT_EQ(layout.camera.elevation_deg, 30);  // all of it is visible
}

TEST(View, IsUphillFromBeyondTheFront) {
    const Raster ground = test::terrain(), layer = test::tongue();  // runs down to the south
    ViewLayout layout;
    draw_view(view(ground, layer), &layout);
    const double off_north = std::remainder(layout.camera.azimuth_deg, 360);
    EXPECT_LT(std::fabs(off_north), 45);
    EXPECT_NEAR(layout.north_arrow_deg, -layout.camera.azimuth_deg, 1e-9);
}

TEST(View, ShowsTheFlowInHuesOfTheLegend) {
    const Raster ground = test::terrain(), layer = test::tongue();
    ViewLayout layout;
    const Image image = draw_view(view(ground, layer), &layout);
    for (const LegendEntry& one : layout.legend) {
        int like_it = 0;
        for (int y = static_cast<int>(layout.flow.top); y < layout.flow.bottom; ++y) {
            for (int x = static_cast<int>(layout.flow.left); x < layout.flow.right; ++x) {
                // Shading takes at most an eighth of the light.
                const Rgb c = image.colour(x, y);
                const auto shaded = [](int seen, int full) { return seen <= full + 6 && seen >= 0.87 * full - 6; };
                like_it += shaded(c.r, one.colour.r) && shaded(c.g, one.colour.g) && shaded(c.b, one.colour.b) ? 1 : 0;
            }
        }
        EXPECT_GT(like_it, 100) << one.label;
    }
}

TEST(View, GivenCameraAndExaggerationAreUsed) {
    const Raster ground = test::terrain(), layer = test::tongue();
    ViewSpec spec = view(ground, layer);
    spec.camera = Camera{90, 50, 1.5};
    spec.vertical_exaggeration = 2;
    ViewLayout layout;
    draw_view(spec, &layout);
    EXPECT_EQ(layout.camera.azimuth_deg, 90);
    EXPECT_EQ(layout.north_arrow_deg, -90);
    EXPECT_TRUE(std::any_of(layout.texts.begin(), layout.texts.end(), [](const TextBox& text) {
        return text.text.find("heights \u00d7 2") != std::string::npos;
    }));
}

TEST(View, InvalidViewsAreRefused) {
    const Raster ground = test::terrain(), layer = test::tongue();
    EXPECT_THROW(draw_view(ViewSpec{}), Error);
    ViewSpec flat = view(ground, layer);
    flat.vertical_exaggeration = 0;
    EXPECT_THROW(draw_view(flat), Error);
    ViewSpec below = view(ground, layer);
    below.camera = Camera{0, -20, 1};
    EXPECT_THROW(draw_view(below), Error);
    Raster elsewhere = layer;
    elsewhere.grid.west += 1e6;
    EXPECT_THROW(draw_view(view(ground, elsewhere)), Error);
}

TEST(ViewCamera, ProjectionMatchesItsOwnAxes) {
    PlacedCamera camera{{0, -100, 100}, {0, 0, 0}, 30};
    EXPECT_NEAR(camera.project({0, 0, 0}).x, 0, 1e-12);
    EXPECT_NEAR(camera.project({0, 0, 0}).y, 0, 1e-12);
    EXPECT_GT(camera.project({10, 0, 0}).x, 0);  // east is right when looking north
    EXPECT_GT(camera.project({0, 0, 10}).y, 0);
    // The upper edge of the picture is half the opening above the axis.
    const double slope = std::tan((45 - 15) * std::numbers::pi / 180);
    EXPECT_NEAR(camera.project({0, -100 + 100, 100 - slope * 100}).y, 1, 1e-9);
}

TEST(ViewCamera, AllPointsFitAndOneTouchesTheMargin) {
    std::vector<ScenePoint> points;
    for (int i = 0; i < 50; ++i) points.push_back({20.0 * i, 13.0 * (i % 7) - 500, 5.0 * (i % 11)});
    for (const double aspect : {0.5, 1.0, 2.5}) {
        const PlacedCamera camera = place_camera({40, 30, 1}, points, aspect);
        double most = 0;
        for (const ScenePoint& p : points) {
            const Point at = camera.project(p);
            most = std::max({most, std::fabs(at.x) / aspect, std::fabs(at.y)});
        }
        EXPECT_NEAR(most, 0.8, 1e-9) << aspect;
    }
}

// Terrain cut off obliquely: seen from above, its edge is as straight in whichever direction it runs.
TEST(View, AnObliqueEdgeOfTheTerrainHasNoTeeth) {
    const auto ink_of_edge = [](bool mirrored) {
        Raster ground(GridSpec{527000, 5095000, 10, 100, 100, ""}, k_no_data), layer(ground.grid, k_no_data);
        for (std::int64_t row = 0; row < 100; ++row)
            for (std::int64_t column = 0; column < 100; ++column) {
                const std::int64_t from_edge = (mirrored ? 99 - column : column) - row;
                if (from_edge < 0) continue;
                ground.at(row, column) = 600;
                if (from_edge > 5) layer.at(row, column) = 1;
            }
        ViewSpec spec = view(ground, layer);
        spec.camera = Camera{0, 89, 0.8};
        spec.sky = false;
        ViewLayout layout;
        const Image image = draw_view(spec, &layout);
        int terrain = 0;  // neither paper nor frame
        for (int y = static_cast<int>(layout.picture.top) + 4; y < layout.picture.bottom - 4; ++y)
            for (int x = static_cast<int>(layout.picture.left) + 4; x < layout.picture.right - 4; ++x)
                terrain += !(image.colour(x, y) == Rgb{255, 255, 255});
        return terrain;
    };
    // A hundred triangles of the 5000 cells were missing on one of the two.
    const int one = ink_of_edge(false), other = ink_of_edge(true);
    EXPECT_GT(one, 20000);
    EXPECT_NEAR(one, other, 0.004 * one);
}

}  // namespace
}  // namespace frana::render
