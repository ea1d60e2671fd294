// SPDX-License-Identifier: Apache-2.0
#include "core/words/number_text.h"

#include <cmath>
#include <cstdio>

namespace frana {

std::string number_text(double value, int digits) {
    if (value == 0) return "0";
    char text[64];
    const double size = std::abs(value);
    // For values that round to as many digits before the point.
    if (size >= std::pow(10.0, digits) - 0.5 && size < 1e15)
        std::snprintf(text, sizeof text, "%.0f", value);
    else
        std::snprintf(text, sizeof text, "%.*g", digits, value);
    return text;
}

std::string grouped(std::int64_t value) {
    const std::string digits = std::to_string(value);
    std::string text;
    for (std::size_t i = 0; i < digits.size(); ++i) {
        const std::size_t left = digits.size() - i;
        if (i > 0 && left % 3 == 0 && digits[i - 1] != '-') text += ' ';
        text += digits[i];
    }
    return text;
}

std::string grouped(double value) {
    if (std::abs(value) < 10) return number_text(value, 2);  // small volumes, as of a flume
    return std::isfinite(value) && std::abs(value) < 9e18 ? grouped(static_cast<std::int64_t>(std::llround(value)))
                                                          : number_text(value);
}

}  // namespace frana
