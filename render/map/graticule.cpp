// SPDX-License-Identifier: Apache-2.0
#include "render/map/graticule.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "core/error.h"

namespace frana::render {
namespace {

/// Returns the least round step, in degrees, that is at least `least`: whole parts of a degree, a minute, a second.
double degree_step_above(double least) {
    constexpr std::array<double, 9> k_parts{1, 2, 5, 10, 15, 20, 30, 45, 60};
    for (double unit = 1.0 / 3600 / 1e4; unit < 1.0 / 3600; unit *= 10) {
        for (const double part : {1.0, 2.0, 5.0}) {
            if (part * unit >= least) return part * unit;
        }
    }
    for (const double unit : {1.0 / 3600, 1.0 / 60, 1.0}) {
        for (const double part : k_parts) {
            if (part * unit >= least * (1 - 1e-9)) return part * unit;
        }
    }
    return 90;
}

}  // namespace

double tick_band(const PageStyle& style) {
    return style.length(8) + 1.75 * style.small.size_px;
}

std::string degree_words(double degrees, double step, const std::string& letters) {
    const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(step * 3600) - 1e-9)), 0, 6);
    const double grain = 3600 * std::pow(10.0, decimals);
    const auto whole = static_cast<long long>(std::llround(std::fabs(degrees) * grain));
    const auto per_second = static_cast<long long>(std::llround(std::pow(10.0, decimals)));
    const long long seconds = whole / per_second;
    std::string text = std::to_string(seconds / 3600) + "\u00B0";
    const bool in_seconds = step < 1.0 / 60 * (1 - 1e-9), in_minutes = step < 1 - 1e-9;
    std::array<char, 48> part{};
    if (in_minutes) {
        std::snprintf(part.data(), part.size(), "%02lld\u2032", seconds / 60 % 60);
        text += part.data();
    }
    if (in_seconds) {
        std::snprintf(part.data(), part.size(), "%02lld", seconds % 60);
        text += part.data();
        if (decimals > 0) {
            std::snprintf(part.data(), part.size(), ".%0*lld", decimals, whole % per_second);
            text += part.data();
        }
        text += "\u2033";
    }
    if (whole == 0) return text;
    return text + " " + letters[degrees > 0 ? 0 : 1];
}

std::vector<RoundPlace> round_places(const std::function<double(double)>& at, double step) {
    const double first = at(0), last = at(1);
    std::vector<RoundPlace> places;
    if (!std::isfinite(first) || !std::isfinite(last) || first == last) return places;
    const double least = std::min(first, last), most = std::max(first, last);
    for (double k = std::ceil(least / step); k * step <= most; ++k) {
        const double value = k * step;
        double low = 0, high = 1;
        for (int i = 0; i < 50; ++i) {
            const double middle = (low + high) / 2;
            if ((at(middle) < value) == (first < last)) {
                low = middle;
            } else {
                high = middle;
            }
        }
        places.push_back({value, (low + high) / 2});
    }
    return places;
}

void draw_graticule(Sheet& sheet, const PageStyle& style, const MapFrame& frame,
                    const std::function<Point(Point)>& longitude_latitude, const Words& words) {
    const PageBox box = frame.box();
    const Bounds& window = frame.window;
    const auto longitude = [&](double t) {
        return longitude_latitude({window.west + t * window.width(), window.north}).x;
    };
    const auto latitude = [&](double t) {
        return longitude_latitude({window.east, window.south + t * window.height()}).y;
    };
    double east, west, north, south;
    try {
        west = longitude(0);
        east = longitude(1);
        south = latitude(0);
        north = latitude(1);
    } catch (const Error&) {
        return;  // the projection has no inverse there
    }
    const Lettering& lettering = sheet.lettering();
    const double tick = style.length(8), text_gap = tick + 0.45 * style.small.size_px;
    const LineStyle line{style.line(1.2), k_ink, 1, {}};
    const auto step_for = [&](double span, double pixels) {
        const double widest = lettering.width("000\u00B000\u203200\u2033 W", style.small);
        return degree_step_above(1.5 * widest * std::fabs(span) / pixels);
    };
    const double step_x = step_for(east - west, box.width());
    for (const RoundPlace& one : round_places(longitude, step_x)) {
        const double x = box.left + one.place * box.width();
        sheet.line(std::array<Point, 2>{{{x, box.top - tick}, {x, box.top}}}, line);
        const std::string label = words.number(degree_words(one.value, step_x, words("EW")));
        const double half = lettering.width(label, style.small) / 2;
        if (x - half < box.left || x + half > box.right) continue;
        sheet.text(label, {x, box.top - text_gap}, style.small, Across::centre, Upright::baseline);
    }
    const double step_y = step_for(north - south, box.height());
    TextStyle upright = style.small;
    upright.angle_deg = 90;
    for (const RoundPlace& one : round_places(latitude, step_y)) {
        const double y = box.bottom - one.place * box.height();
        sheet.line(std::array<Point, 2>{{{box.right, y}, {box.right + tick, y}}}, line);
        const std::string label = words.number(degree_words(one.value, step_y, "NS"));
        const double half = lettering.width(label, style.small) / 2;
        if (y - half < box.top || y + half > box.bottom) continue;
        sheet.text(label, {box.right + text_gap, y}, upright, Across::centre, Upright::top);
    }
}

}  // namespace frana::render
