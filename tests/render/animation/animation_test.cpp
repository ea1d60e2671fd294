// SPDX-License-Identifier: Apache-2.0
#include "render/animation/animation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"
#include "scenes.h"

namespace frana::render {
namespace {

/// Depths at a fraction of the whole tongue.
Raster part(double fraction) {
    Raster raster = test::tongue();
    for (double& value : raster.values) value *= fraction;
    return raster;
}

// Classes that reach the greatest value over time are the same on a map and in a film: no open class is added.
TEST(MapAnimator, AFrameOfTheBaseInGivenClassesIsTheMapItself) {
    const Raster ground = test::terrain(), layer = test::tongue();
    MapSpec spec = test::full_map(ground, layer, 640, 480);
    spec.classes = {0, 2, 5, 10, 20, 50};
    MapAnimator animator(spec);
    const Image frame = animator.frame(layer, spec.subtitle), map = draw_map(spec);
    ASSERT_EQ(frame.rgb.size(), map.rgb.size());
    // What is over all frames is drawn once, over nothing, and rounded to bytes twice.
    for (std::size_t i = 0; i < map.rgb.size(); ++i) ASSERT_NEAR(frame.rgb[i], map.rgb[i], 2) << i;
}

TEST(MapAnimator, PartsOfASubtitleWithoutRoomAreLeftOut) {
    const Raster ground = test::terrain(), layer = test::tongue();
    MapAnimator animator(test::full_map(ground, layer, 640, 480));
    const std::string figures = "t = 12.5 s\nvolume 1 199 712 m\u00b3\ncovers 105 350 m\u00b2";
    const Image fits = animator.frame(layer, figures);
    EXPECT_NE(fits.rgb, animator.frame(layer, "t = 12.5 s").rgb);
    EXPECT_EQ(fits.rgb, animator.frame(layer, figures + '\n' + std::string(90, 'm')).rgb);
}

TEST(MapAnimator, TheScaleIsFixedAndOnlyMapAndSubtitleChange) {
    const Raster ground = test::terrain(), layer = test::tongue();
    const MapSpec spec = test::full_map(ground, layer, 800, 600);
    MapLayout layout;
    draw_map(spec, &layout);
    MapAnimator animator(spec);
    const Image early = animator.frame(part(0.2), "t = 2 s"), late = animator.frame(part(1), "t = 20 s");
    bool map_differs = false;
    for (int y = 0; y < early.height; ++y) {
        for (int x = 0; x < early.width; ++x) {
            const bool in_map = x >= layout.map.left && x < layout.map.right && y >= layout.map.top;
            if (in_map) map_differs |= early.colour(x, y) != late.colour(x, y);
            if (!in_map && y > layout.map.top) {
                ASSERT_EQ(early.colour(x, y), late.colour(x, y)) << x << ", " << y;
            }
        }
    }
    EXPECT_TRUE(map_differs);
    EXPECT_NE(early.rgb, animator.frame(part(0.2), "t = 3 s").rgb);
}

TEST(MapAnimator, AFrameBeyondTheScaleIsRefusedNotHidden) {
    const Raster ground = test::terrain(), layer = test::tongue(9.5);
    MapAnimator animator(test::full_map(ground, layer, 640, 480));
    try {
        animator.frame(test::tongue(25), "");
        FAIL() << "accepted";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::input);
    }
}

TEST(MapAnimator, WithGivenClassesHigherValuesHaveAClass) {
    const Raster ground = test::terrain(), layer = test::tongue();
    MapSpec spec = test::full_map(ground, layer, 640, 480);
    spec.layer = nullptr;
    EXPECT_THROW(MapAnimator{spec}, Error);  // nothing defines the scale
    spec.classes = {0, 1, 2, 3, 4, 5};
    MapAnimator animator(spec);
    EXPECT_EQ(animator.frame(test::tongue(25), "").width, 640);
}

TEST(MapAnimator, AnEmptyFrameIsJustTheGround) {
    const Raster ground = test::terrain(), layer = test::tongue();
    MapAnimator animator(test::full_map(ground, layer, 640, 480));
    EXPECT_NE(animator.frame(Raster(ground.grid, k_no_data), "").rgb, animator.frame(layer, "").rgb);
}

TEST(ViewAnimator, FramesFollowTheirLayer) {
    const Raster ground = test::terrain(), layer = test::tongue();
    ViewSpec spec;
    spec.terrain = &ground;
    spec.layer = &layer;
    spec.thickness = &layer;
    spec.width = 640;
    spec.height = 480;
    ViewAnimator animator(spec);
    const Image full = animator.frame(layer, "t = 1 s"), again = animator.frame(layer, "t = 1 s");
    EXPECT_EQ(full.rgb, again.rgb);
    EXPECT_NE(full.rgb, animator.frame(part(0.3), "t = 1 s").rgb);
}

}  // namespace
}  // namespace frana::render
