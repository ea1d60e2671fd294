// SPDX-License-Identifier: Apache-2.0
#include "render/canvas/furniture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <sstream>

namespace frana::render {
namespace {

std::string length_words(double metres, const Words& words) {
    return metres >= 1000 ? words.number(number(metres / 1000)) + " km" : words.number(number(metres)) + " m";
}

double bar_thickness(const PageStyle& style) {
    return std::max(5.0, style.length(10));
}

}  // namespace

double scale_bar_height(const PageStyle& style) {
    return bar_thickness(style) + style.label.size_px * 1.5;
}

ScaleBar draw_scale_bar(Sheet& sheet, const PageStyle& style, Point corner, double width, double metres_per_pixel,
                        const Words& words) {
    const Lettering& lettering = sheet.lettering();
    // The labels are centred below the bar's ends and must fit the width as well.
    double metres = nice_step_below(width * metres_per_pixel);
    const auto overhang = [&](double length) {
        return (lettering.width("0", style.label) + lettering.width(length_words(length, words), style.label)) / 2;
    };
    while (metres / metres_per_pixel + overhang(metres) > width) metres = nice_step_below(0.9 * metres);
    const double pixels = metres / metres_per_pixel;
    const double left = corner.x + lettering.width("0", style.label) / 2;
    const PageBox bar{left, corner.y, left + pixels, corner.y + bar_thickness(style)};
    sheet.fill(bar, {255, 255, 255});
    constexpr int k_parts = 4;
    for (int i = 0; i < k_parts; i += 2) {
        sheet.fill(PageBox{left + pixels * i / k_parts, bar.top, left + pixels * (i + 1) / k_parts, bar.bottom}, k_ink);
    }
    sheet.frame(bar, {style.line(1.2), k_ink});
    const double text_y = bar.bottom + 0.45 * style.label.size_px;
    sheet.text("0", {bar.left, text_y}, style.label, Across::centre, Upright::top);
    sheet.text(length_words(metres, words), {bar.right, text_y}, style.label, Across::centre, Upright::top);
    return {bar, metres};
}

double north_arrow_height(const PageStyle& style) {
    return 4.6 * style.label.size_px;
}

PageBox draw_north_arrow(Sheet& sheet, const PageStyle& style, Point centre, double angle_deg) {
    const double reach = north_arrow_height(style) / 2;
    const double angle = angle_deg * std::numbers::pi / 180;
    const auto turned = [&](double right, double up) {
        return Point{centre.x + right * std::cos(angle) + up * std::sin(angle),
                     centre.y + right * std::sin(angle) - up * std::cos(angle)};
    };
    const double tip = 0.52 * reach, foot = -0.95 * reach, wing = 0.36 * reach, notch = -0.62 * reach;
    const std::array<Point, 3> dark{turned(0, tip), turned(0, notch), turned(-wing, foot)};
    const std::array<Point, 3> light{turned(0, tip), turned(wing, foot), turned(0, notch)};
    const std::array<Point, 4> rim{turned(0, tip), turned(wing, foot), turned(0, notch), turned(-wing, foot)};
    sheet.fill(dark, k_ink);
    sheet.fill(light, {255, 255, 255});
    sheet.line(rim, {style.line(1.4), k_ink}, true);
    TextStyle letter = style.heading;
    sheet.text("N", turned(0, tip + 0.26 * reach), letter, Across::centre, Upright::middle);
    return {centre.x - reach, centre.y - reach, centre.x + reach, centre.y + reach};
}

std::string convergence_words(double convergence_deg, const Words& words) {
    if (std::fabs(convergence_deg) < 0.05) return {};
    std::array<char, 64> degrees{};
    std::snprintf(degrees.data(), degrees.size(), "%+.1f", convergence_deg);
    return words("true north at grid azimuth {1}°", {words.number(degrees.data())});
}

TextStyle shrunk_to_fit(const Lettering& lettering, const std::string& words, TextStyle style, double width,
                        double least_fraction) {
    const int least = std::max(style.least_px, static_cast<int>(std::ceil(least_fraction * style.size_px)));
    while (style.size_px > least && lettering.width(words, style) > width) --style.size_px;
    return style;
}

TitleResult draw_titles(Sheet& sheet, const PageStyle& style, const std::string& title, const std::string& subtitle,
                        bool subtitle_later, Point corner, double width) {
    double y = corner.y;
    constexpr double k_least_fraction = 0.7;
    if (!title.empty()) {
        const TextStyle fitting = shrunk_to_fit(sheet.lettering(), title, style.title, width, k_least_fraction);
        y = sheet.lines(sheet.wrapped(title, fitting, width), {corner.x, y}, fitting, Across::left);
    }
    TitleResult result{y, {corner.x, y}};
    if (subtitle_later) {
        result.bottom = y + Sheet::line_height(style.subtitle);
    } else if (!subtitle.empty()) {
        const TextStyle fitting = shrunk_to_fit(sheet.lettering(), subtitle, style.subtitle, width, k_least_fraction);
        result.bottom = sheet.lines(sheet.wrapped(subtitle, fitting, width), {corner.x, y}, fitting, Across::left);
    }
    return result;
}

std::shared_ptr<const Overlay> late_subtitle(int width, int height, const PageStyle& style, const std::string& subtitle,
                                             Point at) {
    Sheet sheet(width, height);
    const double room = width - 2 * style.margin;
    constexpr double k_least = 0.5, k_least_of_many = 0.75;
    std::string words;
    std::istringstream parts(subtitle);
    for (std::string part; std::getline(parts, part);) {
        const std::string more = words.empty() ? part : words + ", " + part;
        const TextStyle small = shrunk_to_fit(sheet.lettering(), more, style.subtitle, room, k_least_of_many);
        if (!words.empty() && sheet.lettering().width(more, small) > room) break;
        words = more;
    }
    sheet.text(words, at, shrunk_to_fit(sheet.lettering(), words, style.subtitle, room, k_least), Across::left,
               Upright::top);
    return sheet.take();
}

std::string foot_line(const std::vector<std::string>& parts) {
    std::string all;
    for (const std::string& part : parts)
        if (!part.empty()) all += (all.empty() ? "" : "  \u00B7  ") + part;
    return all;
}

double foot_height(const Sheet& sheet, const PageStyle& style, const std::vector<std::string>& parts, double width) {
    const std::vector<std::string> lines = sheet.wrapped(foot_line(parts), style.small, width);
    if (lines.empty()) return 0;
    // Keeps the last line's descenders above the bottom.
    return 0.3 * style.small.size_px + Sheet::line_height(style.small) * static_cast<double>(lines.size() - 1) +
           capital_height(style.small) + style.gap / 2;
}

double draw_foot(Sheet& sheet, const PageStyle& style, const std::vector<std::string>& parts, double left,
                 double bottom, double width) {
    const double top = bottom - foot_height(sheet, style, parts, width);
    double y = top + style.gap / 2 + capital_height(style.small);
    for (const std::string& line : sheet.wrapped(foot_line(parts), style.small, width)) {
        sheet.text(line, {left, y}, style.small, Across::left, Upright::baseline);
        y += Sheet::line_height(style.small);
    }
    return top;
}

namespace {

constexpr double k_slack = 1e-9;  // of a step: rounding of decimal steps in binary

double step(double value, bool above) {
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    double below = power;
    for (const double factor : {1.0, 2.0, 5.0, 10.0}) {
        const double candidate = factor * power;
        if (above && candidate >= value * (1 - k_slack)) return candidate;
        if (!above && candidate <= value * (1 + k_slack)) below = candidate;
    }
    return below;
}

}  // namespace

double nice_step_above(double least) {
    return step(least, true);
}

double nice_step_below(double most) {
    return step(most, false);
}

std::vector<double> multiples(double from, double to, double step) {
    std::vector<double> all;
    for (double k = std::ceil(from / step - k_slack); k * step <= to + k_slack * step; k += 1) all.push_back(k * step);
    return all;
}

std::string number(double value) {
    std::array<char, 32> text{};
    // Six digits hide the rounding of decimal steps in binary (0.30000000000000004) and keep every bound that users
    // write.
    std::snprintf(text.data(), text.size(), std::fabs(value) >= 1e5 && std::fabs(value) < 1e12 ? "%.0f" : "%.6g",
                  value + 0.0);
    return text.data();
}

std::string grouped(double value) {
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%.0f", std::fabs(value));
    const std::string digits = text.data();
    std::string result = value < -0.5 ? "\u2212" : "";
    for (std::size_t i = 0; i < digits.size(); ++i) {
        if (i > 0 && (digits.size() - i) % 3 == 0) result += ' ';
        result += digits[i];
    }
    return result;
}

}  // namespace frana::render
