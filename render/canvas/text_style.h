// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/colour.h"

namespace frana::render {

/// Font size of the smallest letters of a page on a screen [px].
inline constexpr int k_least_letters = 9;

struct TextStyle {
    int size_px = 16;
    Rgb colour{0, 0, 0};
    bool bold = false;
    double angle_deg = 0;  ///< counterclockwise
    double halo_px = 0;    ///< width of a rim that separates the letters from a varied background
    Rgb halo{255, 255, 255};
    int least_px = k_least_letters;  ///< to which the text may be made smaller to fit
};

/// The point of a text that is at the place given for it.
enum class Across { left, centre, right };
enum class Upright { baseline, middle, top };  ///< of capital letters, so that lines of text align

/// Height of a capital letter of DejaVu Sans [px].
inline double capital_height(const TextStyle& style) {
    return 0.729 * style.size_px;
}

}  // namespace frana::render
