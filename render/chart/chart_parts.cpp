// SPDX-License-Identifier: Apache-2.0
#include "render/chart/chart_parts.h"

#include <array>
#include <cmath>
#include <numbers>

namespace frana::render {
namespace {

constexpr Rgb k_grid{226, 229, 232}, k_fine_grid{240, 241, 243};
// In units of the letters' size.
constexpr double k_swatch = 2.2, k_gap = 0.5, k_apart = 1.2, k_row = 1.5, k_off_frame = 0.55;

LineStyle line_of(const PageStyle& style, const ChartSeries& series) {
    LineStyle line{style.line(series.width_px), series.colour};
    const double wide = line.width_px;
    switch (series.stroke) {
        case Stroke::solid:
            break;
        case Stroke::dashed:
            line.dashes = {4.5 * wide, 2.5 * wide};
            break;
        case Stroke::dotted:
            line.dashes = {wide, 1.8 * wide};
            break;
        case Stroke::dash_dot:
            line.dashes = {6 * wide, 2 * wide, wide, 2 * wide};
            break;
    }
    return line;
}

std::vector<Point> corners_of(Marker marker, Point at, double size) {
    const auto ring = [&](int sides, double radius, double turn) {
        std::vector<Point> corners;
        for (int k = 0; k < sides; ++k) {
            const double angle = turn + 2 * std::numbers::pi * k / sides;
            corners.push_back({at.x + radius * std::sin(angle), at.y - radius * std::cos(angle)});
        }
        return corners;
    };
    switch (marker) {
        case Marker::circle:
            return ring(20, size, 0);
        case Marker::square:
            return ring(4, 1.3 * size, std::numbers::pi / 4);
        case Marker::triangle:
            return ring(3, 1.4 * size, 0);
        case Marker::diamond:
            return ring(4, 1.35 * size, 0);
    }
    return {};
}

}  // namespace

void draw_ticks(Sheet& sheet, const PageStyle& style, const PageBox& box, const std::vector<Tick>& x,
                const std::vector<Tick>& y) {
    for (const bool fine : {true, false}) {
        const LineStyle hair{style.line(1), fine ? k_fine_grid : k_grid};
        for (const Tick& tick : x)
            if (tick.words.empty() == fine)
                sheet.line(std::array{Point{tick.at, box.top}, Point{tick.at, box.bottom}}, hair);
        for (const Tick& tick : y)
            if (tick.words.empty() == fine)
                sheet.line(std::array{Point{box.left, tick.at}, Point{box.right, tick.at}}, hair);
    }
    const double off = k_off_frame * style.small.size_px;
    for (const Tick& tick : x)
        if (!tick.words.empty())
            sheet.text(tick.words, {tick.at, box.bottom + off}, style.small, Across::centre, Upright::top);
    for (const Tick& tick : y)
        if (!tick.words.empty())
            sheet.text(tick.words, {box.left - off, tick.at}, style.small, Across::right, Upright::middle);
}

void draw_vertical_name(Sheet& sheet, TextStyle style, Point middle, const std::string& words) {
    style.angle_deg = 90;
    sheet.text(words, middle, style, Across::centre, Upright::middle);
}

void draw_line(Sheet& sheet, const PageStyle& style, const ChartSeries& series, const std::vector<Point>& places) {
    if (places.size() > 1) sheet.line(places, line_of(style, series));
}

void draw_markers(Sheet& sheet, const PageStyle& style, const ChartSeries& series, const std::vector<Point>& places) {
    if (!series.marker) return;
    for (const Point place : places)
        sheet.fill(corners_of(*series.marker, place, 1.2 + style.line(3.2)), series.colour);
}

ChartKey::ChartKey(const Sheet& sheet, const TextStyle& letters, std::vector<const ChartSeries*> series, double width)
    : letters_(letters), series_(std::move(series)) {
    std::erase_if(series_, [](const ChartSeries* one) { return one->label.empty(); });
    const double letter = letters.size_px;
    double x = 0, y = 0;
    for (const ChartSeries* one : series_) {
        const double length = (k_swatch + k_gap) * letter + sheet.lettering().width(one->label, letters);
        if (x > 0 && x + length > width) {
            x = 0;
            y += k_row * letter;
        }
        places_.push_back({x, y});
        x += length + k_apart * letter;
    }
    if (!series_.empty()) height_ = y + k_row * letter;
}

void ChartKey::draw(Sheet& sheet, const PageStyle& style, Point corner) const {
    const double letter = letters_.size_px;
    for (std::size_t i = 0; i < series_.size(); ++i) {
        const double x = corner.x + places_[i].x, y = corner.y + places_[i].y + letter / 2;
        draw_line(sheet, style, *series_[i], {{x, y}, {x + k_swatch * letter, y}});
        draw_markers(sheet, style, *series_[i], {{x + k_swatch * letter / 2, y}});
        sheet.text(series_[i]->label, {x + (k_swatch + k_gap) * letter, y}, letters_, Across::left, Upright::middle);
    }
}

}  // namespace frana::render
