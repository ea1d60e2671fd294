// SPDX-License-Identifier: Apache-2.0
#include "render/map/map_lines.h"

#include <gtest/gtest.h>

#include <cmath>

#include "render/map/map2d.h"
#include "scenes.h"

namespace frana::render {
namespace {

TEST(Graticule, DegreesAreWrittenAsFinelyAsTheirStep) {
    EXPECT_EQ(degree_words(9.408333333333333, 30.0 / 3600, "EW"), "9°24′30″ E");
    EXPECT_EQ(degree_words(-70.25, 15.0 / 60, "EW"), "70°15′ W");
    EXPECT_EQ(degree_words(46, 1, "NS"), "46° N");
    EXPECT_EQ(degree_words(46, 1.0 / 60, "NS"), "46°00′ N");
    EXPECT_EQ(degree_words(46 + 0.5 / 3600, 0.5 / 3600, "NS"), "46°00′00.5″ N");
    EXPECT_EQ(degree_words(0, 1, "NS"), "0°");
    // Rounding must carry: 59.9999999 seconds are the next minute.
    EXPECT_EQ(degree_words(9 + 59.99999999 / 3600, 1.0 / 3600, "EW"), "9°01′00″ E");
}

TEST(Graticule, RoundPlacesSolveTheCoordinate) {
    const auto rising = [](double t) { return 9.3 + 0.02 * t + 0.001 * t * t; };
    for (const RoundPlace& one : round_places(rising, 0.005)) EXPECT_NEAR(rising(one.place), one.value, 1e-12);
    EXPECT_EQ(round_places(rising, 0.005).size(), 5U);  // 9.300, 9.305 ... 9.320
    const auto falling = [](double t) { return 5 - 3 * t; };
    EXPECT_EQ(round_places(falling, 1).size(), 4U);
    EXPECT_TRUE(round_places([](double) { return k_no_data; }, 1).empty());
}

TEST(Graticule, TicksAreWhereTheProjectionPutsThem) {
    const Raster ground = test::terrain(), layer = test::tongue();
    MapSpec spec = test::crowded_map(ground, layer, 1600, 1200);
    MapLayout layout;
    draw_map(spec, &layout);
    int checked = 0;
    for (const TextBox& text : layout.texts) {
        int degrees = 0, minutes = 0, seconds = 0;
        char side = 0;
        if (std::sscanf(text.text.c_str(), "%d°%d′%d″ %c", &degrees, &minutes, &seconds, &side) != 4) continue;
        const double value = degrees + minutes / 60.0 + seconds / 3600.0;
        // The middle of the label's ink; at most a pixel off, since letters are not symmetric.
        const Point centre{(text.box.left + text.box.right) / 2, (text.box.top + text.box.bottom) / 2};
        if (side == 'E') {
            const double east = layout.window.west + (centre.x - layout.map.left) * layout.metres_per_pixel;
            EXPECT_NEAR(test::degrees_at({east, layout.window.north}).x, value, 1.5 * layout.metres_per_pixel / 80e3);
        } else {
            const double north = layout.window.north - (centre.y - layout.map.top) * layout.metres_per_pixel;
            EXPECT_NEAR(test::degrees_at({layout.window.east, north}).y, value, 1.5 * layout.metres_per_pixel / 110e3);
        }
        ++checked;
    }
    EXPECT_GE(checked, 4);
}

}  // namespace
}  // namespace frana::render
