// SPDX-License-Identifier: Apache-2.0
#include "render/map/map_lines.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/raster.h"

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

}  // namespace
}  // namespace frana::render
