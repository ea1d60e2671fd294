// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace frana {

/// A colour of the screen (sRGB).
struct Rgb {
    std::uint8_t r = 0, g = 0, b = 0;

    bool operator==(const Rgb&) const = default;
};

/// A run of colours at equal distances from the scale's start (0) to its end (1), even to the eye, safe for
/// the colour-blind and falling steadily in lightness, so that it survives a grey print.
struct Palette {
    std::string name;
    std::vector<Rgb> anchors;
};

/// The colour at t in [0, 1] (outside: the nearest end), straight between anchors.
Rgb colour_at(const Palette& palette, double t);

/// "depth" (yellow to violet), "velocity" (yellow over red to black-violet), "time" (yellow over magenta to
/// blue). Throws Error(input) for any other name.
const Palette& palette(const std::string& name);

/// Rising class bounds 0, s, 2s, ... for values up to `maximum`, with s = 1, 2 or 5 times a power of ten, at
/// most `classes` classes, the last bound not below the maximum. For a maximum that is not positive: {0, 1}.
std::vector<double> nice_classes(double maximum, int classes);

}  // namespace frana
