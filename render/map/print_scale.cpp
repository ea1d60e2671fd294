// SPDX-License-Identifier: Apache-2.0
#include "render/map/print_scale.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "render/canvas/ticks.h"

namespace frana::render {
namespace {

constexpr double k_inch = 0.0254;              // m
constexpr double k_least_margin = 0.03;        // of the content's longer side, beside it
constexpr double k_scale_rounding = 1 + 1e-9;  // a scale may be equal to the least

Bounds with_margin(const Bounds& box, double fraction) {
    const double margin = fraction * std::max(box.width(), box.height());
    return {box.west - margin, box.south - margin, box.east + margin, box.north + margin};
}

Bounds centred(const Bounds& on, double metre, int width, int height) {
    const double x = (on.west + on.east) / 2, y = (on.south + on.north) / 2;
    return {x - width * metre / 2, y - height * metre / 2, x + width * metre / 2, y + height * metre / 2};
}

}  // namespace

double metres_per_pixel(double n, double dots_per_inch) {
    return n * k_inch / dots_per_inch;
}

double scale_of(double metres_per_pixel, double dots_per_inch) {
    return metres_per_pixel * dots_per_inch / k_inch;
}

double round_scale_above(double n) {
    double decade = std::pow(10, std::floor(std::log10(n)));
    for (;; decade *= 10) {
        for (const double step : {1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 7.5}) {
            const double scale = std::round(step * decade);
            if (scale * k_scale_rounding >= n) return scale;
        }
    }
}

double least_scale(const Print& print, const Bounds& required, int width, int height) {
    const Bounds box = with_margin(required, k_least_margin);
    return scale_of(std::max(box.width() / width, box.height() / height), print.dots_per_inch);
}

Bounds window_at_scale(const Print& print, const Bounds& required, const Bounds& free, int width, int height) {
    if (!(print.dots_per_inch > 0)) return free;
    const double least = least_scale(print, required, width, height);
    if (print.scale) {
        if (*print.scale * k_scale_rounding < least) {
            throw Error(
                ErrorKind::input,
                Problem{"the flow does not fit the page at this scale", "", scale_words(*print.scale),
                        "at least " + scale_words(std::ceil(least)), "Take " + scale_words(round_scale_above(least))});
        }
        return centred(required, metres_per_pixel(*print.scale, print.dots_per_inch), width, height);
    }
    return centred(free, metres_per_pixel(round_scale_above(least), print.dots_per_inch), width, height);
}

std::string scale_words(double n, const Words& words) {
    return "1 : " + words.number(grouped(std::round(n)));
}

std::string print_words(const Print& print, double page_width, double page_height, const Words& words) {
    if (!print.sheet.empty()) return words("on {1}", {print.sheet});
    const auto centimetres = [&](double pixels) {
        return words.number(number(std::round(1000 * k_inch * pixels / print.dots_per_inch) / 10));
    };
    return words("printed {1} \u00D7 {2} cm", {centimetres(page_width), centimetres(page_height)});
}

}  // namespace frana::render
