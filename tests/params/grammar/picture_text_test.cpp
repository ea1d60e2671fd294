// SPDX-License-Identifier: Apache-2.0
#include "params/grammar/picture_text.h"

#include <gtest/gtest.h>

namespace frana {
namespace {

TEST(PictureText, SizesInPixels) {
    EXPECT_EQ(size_from_text("1600x1200")->height, 1200);
    for (const std::string bad : {"1600", "1600x", "x1200", "10x10", "640x400", "1600x1200x3", "99999x400", ""})
        EXPECT_FALSE(size_from_text(bad)) << bad;
}

TEST(PictureText, PagesOfIso216) {
    // 297 mm at 150 dots per inch of 25.4 mm are 1753.9 pixels.
    EXPECT_EQ(size_from_text("A4")->width, 1754);
    EXPECT_EQ(size_from_text("A4")->height, 1240);
    EXPECT_EQ(size_from_text("A4-portrait")->height, 1754);
    EXPECT_EQ(size_from_text("A3@300")->width, 4961);
    EXPECT_EQ(size_from_text("A3@300")->height, 3508);
    EXPECT_EQ(size_from_text("A3@300")->dots_per_inch, 300);
    for (const std::string bad : {"A5", "A4@", "A4@72", "A4@600", "A4@x", "A4-landscape", "A", "a4"})
        EXPECT_FALSE(size_from_text(bad)) << bad;
}

TEST(PictureText, Cameras) {
    const auto camera = camera_from_text("210, 30, 1.5");
    ASSERT_TRUE(camera);
    EXPECT_EQ(camera->azimuth, 210);
    EXPECT_EQ(camera->elevation, 30);
    EXPECT_EQ(camera->zoom, 1.5);
    EXPECT_EQ(camera_from_text("0 89")->zoom, 1);
    for (const std::string bad : {"", "210", "361, 30", "10, 0", "10, 90", "10, 30, 0", "a, b", "1, 2, 3, 4"})
        EXPECT_FALSE(camera_from_text(bad)) << bad;
}

}  // namespace
}  // namespace frana
