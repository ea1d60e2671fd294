// SPDX-License-Identifier: Apache-2.0
#include "render/canvas/page_style.h"

#include <algorithm>
#include <cmath>

namespace frana::render {

PageStyle::PageStyle(int width, int height, double density, int least_px) {
    scale = std::min(height / 1200.0, width / 1200.0);
    constexpr double k_letters = 0.72;  // 18 pixels at full size become 11 on a page of 800 x 600
    const double letters = std::pow(scale, k_letters) * density;
    margin = std::max(10.0, 28 * scale);
    gap = std::max(5.0, 14 * scale * density);
    // `least` where the smallest letters have k_least_letters.
    const auto size = [letters, least_px](double at_full_size, int least) {
        return std::max(least * least_px / k_least_letters, static_cast<int>(std::lround(at_full_size * letters)));
    };
    title = {size(34, 13), k_ink, true};
    subtitle = {size(21, 11), k_soft_ink};
    heading = {size(20, 11), k_ink, true};
    label = {size(18, 10), k_ink};
    small = {size(15, 9), k_soft_ink};
    for (TextStyle* const style : {&title, &subtitle, &heading, &label, &small}) style->least_px = least_px;
}

double PageStyle::line(double at_full_size) const {
    return std::max(0.6, at_full_size * std::sqrt(scale));
}

}  // namespace frana::render
