// SPDX-License-Identifier: Apache-2.0
#include "core/colour.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"

namespace frana {
namespace {

TEST(Colour, EndsAndMiddle) {
    const Palette two{"two", {{0, 100, 200}, {100, 0, 200}}};
    EXPECT_EQ(colour_at(two, 0), (Rgb{0, 100, 200}));
    EXPECT_EQ(colour_at(two, 1), (Rgb{100, 0, 200}));
    EXPECT_EQ(colour_at(two, 0.5), (Rgb{50, 50, 200}));
    EXPECT_EQ(colour_at(two, -3), (Rgb{0, 100, 200}));
    EXPECT_EQ(colour_at(two, 7), (Rgb{100, 0, 200}));
}

/// Lightness L* of the CIE, from 0 black to 100 white.
double lightness(Rgb c) {
    const auto linear = [](double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); };
    const double y = 0.2126 * linear(c.r / 255.0) + 0.7152 * linear(c.g / 255.0) + 0.0722 * linear(c.b / 255.0);
    return y > 0.008856 ? 116 * std::cbrt(y) - 16 : 903.3 * y;
}

TEST(Colour, EveryPaletteDarkensSteadilySoThatGreyPrintsKeepTheOrder) {
    for (const char* name : {"depth", "velocity", "time"}) {
        double last = 200;  // lighter than anything
        for (int i = 0; i <= 7; ++i) {
            const double now = lightness(colour_at(palette(name), i / 7.0));
            EXPECT_LT(now, last - 4) << name << " class " << i;  // four units of L* are distinguishable side by side
            last = now;
        }
    }
}

TEST(Colour, ADifferenceIsPaleInTheMiddleAndItsSignsDifferInGrey) {
    const Palette& both = palette("difference");
    EXPECT_GT(lightness(colour_at(both, 0.5)), 95);
    for (int i = 0; i < 5; ++i) {
        const double below = lightness(colour_at(both, i / 10.0)), above = lightness(colour_at(both, 1 - i / 10.0));
        EXPECT_LT(below, lightness(colour_at(both, (i + 1) / 10.0)) - 2) << i;
        EXPECT_LT(above, lightness(colour_at(both, 1 - (i + 1) / 10.0)) - 2) << i;
        EXPECT_LT(below, above - (i < 4 ? 8 : 2)) << i;
    }
}

TEST(Colour, UnknownPaletteIsRefusedByName) {
    try {
        palette("rainbow");
        FAIL() << "accepted";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::input);
        EXPECT_NE(std::string(error.what()).find("rainbow"), std::string::npos);
        EXPECT_NE(std::string(error.what()).find("velocity"), std::string::npos);
    }
}

TEST(NiceClasses, AreRoundAndReachTheMaximum) {
    EXPECT_EQ(nice_classes(38, 8), (std::vector<double>{0, 5, 10, 15, 20, 25, 30, 35, 40}));
    EXPECT_EQ(nice_classes(0.7, 8), (std::vector<double>{0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7}));
    EXPECT_EQ(nice_classes(0, 8), (std::vector<double>{0, 1}));
    for (double maximum = 0.003; maximum < 5000; maximum *= 1.37) {
        const std::vector<double> bounds = nice_classes(maximum, 8);
        EXPECT_GE(bounds.back(), maximum);
        EXPECT_LE(bounds.size(), 9U);
        EXPECT_GE(bounds.size(), 4U) << maximum;
    }
}

}  // namespace
}  // namespace frana
