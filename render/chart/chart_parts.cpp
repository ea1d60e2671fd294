// SPDX-License-Identifier: Apache-2.0
#include "render/chart/chart_parts.h"

#include <array>

namespace frana::render {
namespace {

// In letters' sizes.
constexpr double k_swatch = 2.2, k_gap = 0.5, k_apart = 1.2, k_row = 1.5, k_off_frame = 0.55;

}  // namespace

LineStyle chart_line(const PageStyle& style, Rgb colour, double width_px, Stroke stroke) {
    LineStyle line{style.line(width_px), colour};
    const double wide = line.width_px;
    switch (stroke) {
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

void grid_upright(Sheet& sheet, const PageBox& box, double x, const LineStyle& line) {
    sheet.canvas().line(std::array{Point{x, box.top}, Point{x, box.bottom}}, line);
}

void grid_level(Sheet& sheet, const PageBox& box, double y, const LineStyle& line) {
    sheet.canvas().line(std::array{Point{box.left, y}, Point{box.right, y}}, line);
}

void number_below(Sheet& sheet, const PageStyle& style, const PageBox& box, double x, const std::string& words) {
    sheet.text(words, {x, box.bottom + k_off_frame * style.small.size_px}, style.small, Across::centre, Upright::top);
}

void number_beside(Sheet& sheet, const PageStyle& style, const PageBox& box, double y, const std::string& words) {
    sheet.text(words, {box.left - k_off_frame * style.small.size_px, y}, style.small, Across::right, Upright::middle);
}

void upright_name(Sheet& sheet, TextStyle style, Point middle, const std::string& words) {
    style.angle_deg = 90;
    sheet.text(words, middle, style, Across::centre, Upright::middle);
}

ChartKey::ChartKey(const Sheet& sheet, const TextStyle& style, const std::vector<std::string>& names, double width)
    : style_(style), names_(names) {
    const double letter = style.size_px;
    double x = 0, y = 0;
    for (const std::string& name : names) {
        const double length = (k_swatch + k_gap) * letter + sheet.lettering().width(name, style);
        if (x > 0 && x + length > width) {
            x = 0;
            y += k_row * letter;
        }
        places_.push_back({x, y});
        x += length + k_apart * letter;
    }
    if (!names.empty()) height_ = y + k_row * letter;
}

void ChartKey::draw(Sheet& sheet, Point corner,
                    const std::function<void(std::size_t i, Point from, Point to)>& swatch) const {
    const double letter = style_.size_px;
    for (std::size_t i = 0; i < names_.size(); ++i) {
        const double x = corner.x + places_[i].x, y = corner.y + places_[i].y + letter / 2;
        swatch(i, {x, y}, {x + k_swatch * letter, y});
        sheet.text(names_[i], {x + (k_swatch + k_gap) * letter, y}, style_, Across::left, Upright::middle);
    }
}

}  // namespace frana::render
