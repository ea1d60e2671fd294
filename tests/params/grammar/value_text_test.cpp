// SPDX-License-Identifier: Apache-2.0
#include "params/grammar/value_text.h"

#include <gtest/gtest.h>

#include "core/text.h"
#include "params/keys/scene_parameters.h"

namespace frana {
namespace {

TEST(ValueText, NumbersAreWholeFiniteAndExact) {
    EXPECT_EQ(number_from_text("2.5e3"), 2500);
    EXPECT_EQ(number_from_text("+7"), 7);
    for (const std::string bad : {"", "1,5", "5 m", "nan", "inf", "1e999", "0x10", "+-1"})
        EXPECT_FALSE(number_from_text(bad)) << bad;
    EXPECT_EQ(integer_from_text("16"), 16);
    EXPECT_FALSE(integer_from_text("4.0"));
}

TEST(ValueText, ShortestTextReadsBackAsTheSameBits) {
    for (const double value : {0.1, 1.0 / 3, 9.80665, 5e-324, 1.7976931348623157e308, 527000.125})
        EXPECT_EQ(number_from_text(shortest_text(value)), value);
}

TEST(ValueText, WordsAndSwitches) {
    EXPECT_EQ(words_of(" a, b\tc ,,d "), (std::vector<std::string>{"a", "b", "c", "d"}));
    EXPECT_EQ(boolean_from_text("on"), true);
    EXPECT_EQ(boolean_from_text("no"), false);
    EXPECT_FALSE(boolean_from_text("maybe"));
}

TEST(EditDistance, ByHand) {
    EXPECT_EQ(edit_distance("", ""), 0);
    EXPECT_EQ(edit_distance("abc", ""), 3);
    EXPECT_EQ(edit_distance("density", "desnity"), 1);  // neighbours swapped
    EXPECT_EQ(edit_distance("density", "densty"), 1);
    EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
}

TEST(NearestName, FindsWhatWasMeant) {
    const auto known = names_of(scene_parameters());
    EXPECT_EQ(nearest_name("material.frictionangle", known), "material.friction-angle");
    EXPECT_EQ(nearest_name("material.desnity", known), "material.density");
    EXPECT_EQ(nearest_name("release.dtm", known), "terrain.dtm");
    EXPECT_EQ(nearest_name("thicknes", known), "release.thickness");
    EXPECT_EQ(nearest_name("times.end", known), "time.end");
    EXPECT_EQ(nearest_name("material.colour-of-the-sky", known), "");
}

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
    EXPECT_TRUE(size_from_text("A4")->turns && size_from_text("auto")->turns);
    EXPECT_FALSE(size_from_text("A4-landscape")->turns || size_from_text("1600x1200")->turns);
    const Size upright = size_for_ground(*size_from_text("A4"), 1, 2);
    EXPECT_TRUE(upright.height == 1754 && upright.paper == "A4-portrait");
    EXPECT_EQ(size_for_ground(*size_from_text("A4-landscape"), 1, 2).height, 1240);
    EXPECT_EQ(size_for_ground(*size_from_text("auto"), 1, 1.2).height, 1240);
    EXPECT_EQ(size_from_text("A3@300")->width, 4961);
    EXPECT_EQ(size_from_text("A3@300")->height, 3508);
    EXPECT_EQ(size_from_text("A3@300")->dots_per_inch, 300);
    for (const std::string bad : {"A5", "A4@", "A4@72", "A4@600", "A4@x", "A4-square", "A", "a4"})
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
