// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace frana {

/// A screen colour (sRGB).
struct Rgb {
    std::uint8_t r = 0, g = 0, b = 0;

    bool operator==(const Rgb&) const = default;
};

/// Colours at equal distances from the start (0) to the end (1) of the scale. Perceptually uniform, safe for the
/// colour-blind; of monotonically falling lightness, so that it can be printed in grey, unless it diverges.
struct Palette {
    std::string name;
    std::vector<Rgb> anchors;
};

/// Returns the colour at t in [0, 1] (clamped), interpolated linearly between the anchors.
Rgb colour_at(const Palette& palette, double t);

/// Returns the palette "depth" (yellow to violet), "velocity" (yellow over red to black-violet) or "time" (yellow over
/// magenta to blue), or "difference", which diverges: dark blue, pale in the middle, vermilion. Throws Error(input) for
/// any other name.
const Palette& palette(const std::string& name);

/// Returns rising class bounds 0, s, 2s, ... for values up to `maximum`, with s = 1, 2 or 5 times a power of ten, at
/// most `classes` classes, the last bound at or above the maximum. For a maximum that is not positive: {0, 1}.
std::vector<double> nice_classes(double maximum, int classes);

}  // namespace frana
