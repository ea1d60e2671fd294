// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/canvas/lettering.h"

namespace frana::render {

/// Sizes of everything on a page, from the page's size: letters shrink more slowly than the page, since a small page is
/// read from the same distance as a large one.
struct PageStyle {
    /// `density` below 1 makes letters and gaps smaller, to fit more on the page. No letter is smaller than `least_px`.
    PageStyle(int width, int height, double density = 1, int least_px = k_least_letters);

    double scale = 1;  ///< of lines and gaps; 1 on a page 1600 x 1200
    double margin = 28, gap = 14;
    TextStyle title, subtitle, heading, label, small;

    /// A length given for a page 1600 x 1200.
    [[nodiscard]] double length(double at_full_size) const { return at_full_size * scale; }
    /// The same for the width of a line, with a visible minimum.
    [[nodiscard]] double line(double at_full_size) const;
};

/// Ways of reducing the size of parts of a page, tried one after the other until everything fits.
struct Crowding {
    double density = 1;          ///< of letters and gaps
    bool notes_at_foot = false;  ///< side notes at the foot of the page, where they need far less height than beside
                                 ///< the map
};
inline constexpr Crowding k_crowdings[] = {{1, false}, {0.88, false}, {0.77, false}, {0.66, false}, {0.66, true}};

inline constexpr Rgb k_ink{25, 28, 32};            ///< of letters and frames
inline constexpr Rgb k_soft_ink{84, 90, 98};       ///< of less prominent parts
inline constexpr Rgb k_no_terrain{236, 237, 238};  ///< inside the frame where there is no terrain

}  // namespace frana::render
