// SPDX-License-Identifier: Apache-2.0
#include "render/map/legend.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/map/map_lines.h"

namespace frana::render {
namespace {

struct BoxSize {
    double width, height;
};

BoxSize swatch(const PageStyle& style) {
    return {2.0 * style.label.size_px, 1.35 * style.label.size_px};
}

double text_offset(const PageStyle& style) {
    return swatch(style).width + 0.6 * style.label.size_px;
}

std::string full_title(const LegendContent& content) {
    return content.unit.empty() ? content.title : content.title + " [" + content.unit + "]";
}

/// Draws continuous colours, each bound of the scale marked and numbered; open ends are half a swatch high. Returns the
/// y below them.
double draw_ramp(const ColourScale& scale, const PageStyle& style, Point corner, Sheet& sheet,
                 std::vector<LegendEntry>& entries) {
    const std::vector<ColourClass>& classes = scale.classes();
    const BoxSize size = swatch(style);
    PageBox box{corner.x, corner.y, corner.x + size.width, corner.y};
    const auto mark = [&](double value, const char* sign) {
        const double y = box.bottom;
        const std::array<Point, 2> tick{{{box.right, y}, {box.right + style.length(6), y}}};
        sheet.line(tick, {style.line(1), k_ink});
        sheet.text(sign + scale.number_of(value), {corner.x + text_offset(style), y}, style.label, Across::left,
                   Upright::middle);
    };
    int bounded = 0;
    box.bottom += std::isinf(classes.back().upper) ? 0 : size.height / 2;
    const double top = box.bottom;
    for (auto one = classes.rbegin(); one != classes.rend(); ++one) {
        const bool open = std::isinf(one->lower) || std::isinf(one->upper);
        if (!std::isinf(one->upper) && (open || bounded++ % scale.slices() == 0)) {
            const bool greatest = std::isinf(classes.back().upper) && bounded == 1;
            mark(one->upper, open ? "< " : greatest ? "> " : "");
        }
        box.top = box.bottom;
        box.bottom += open ? size.height / 2 : size.height / scale.slices();
        sheet.fill(box, one->colour);
        entries.push_back({one->label, one->colour, box, one->lower, one->upper});
    }
    if (!std::isinf(classes.front().lower)) mark(classes.front().lower, "");
    sheet.frame({box.left, top, box.right, box.bottom}, {style.line(1), k_ink});
    return box.bottom + size.height / 2;
}

}  // namespace

std::vector<double> outline_dashes(const Outline& outline, double width_px) {
    if (!outline.dashed) return {};
    return {3.2 * width_px, 2.2 * width_px};
}

double legend_width(const LegendContent& content, const PageStyle& style, const Sheet& sheet, double most) {
    const Lettering& lettering = sheet.lettering();
    double width = 0;
    for (const double bound : content.scale->bounds())
        width =
            std::max(width, text_offset(style) + lettering.width("> " + content.scale->number_of(bound), style.label));
    for (const ColourClass& one : content.scale->classes()) {
        if (content.scale->slices() > 1) break;
        width = std::max(width, text_offset(style) + lettering.width(one.label, style.label));
    }
    for (const Outline& outline : *content.outlines) {
        width = std::max(width, text_offset(style) + lettering.width(outline.label, style.label));
    }
    for (const std::string& note : *content.notes) width = std::max(width, lettering.width(note, style.label));
    width = std::max(width, lettering.width(full_title(content), style.heading));
    return std::min(most, std::ceil(width) + 2);
}

double draw_legend(const LegendContent& content, const PageStyle& style, Point corner, double width, Sheet& sheet,
                   std::vector<LegendEntry>& entries) {
    const BoxSize size = swatch(style);
    const double line_height = Sheet::line_height(style.label);
    double y = corner.y;
    const auto labelled = [&](const std::string& label, double row_height) {
        // A label of several lines begins where a label of one line would be.
        double line_y = y + row_height / 2;
        for (const std::string& line : sheet.wrapped(label, style.label, width - text_offset(style))) {
            sheet.text(line, {corner.x + text_offset(style), line_y}, style.label, Across::left, Upright::middle);
            line_y += line_height;
        }
        y = std::max(y + row_height, line_y - line_height + row_height / 2);
    };

    const std::vector<ColourClass>& classes = content.scale->classes();
    if (!classes.empty()) {
        y = sheet.lines(sheet.wrapped(full_title(content), style.heading, width), {corner.x, y}, style.heading,
                        Across::left) +
            0.15 * style.heading.size_px;
        const bool apart = content.scale->categorical();  // ranges touch, categories are separated
        std::vector<const ColourClass*> order;
        for (const ColourClass& one : classes) order.push_back(&one);
        if (!apart) std::reverse(order.begin(), order.end());
        if (content.scale->slices() > 1) {
            order.clear();
            y = draw_ramp(*content.scale, style, {corner.x, y}, sheet, entries);
        }
        for (const ColourClass* one : order) {
            const PageBox box{corner.x, y, corner.x + size.width, y + size.height};
            sheet.fill(box, one->colour);
            sheet.frame(box, {style.line(1), k_ink});
            entries.push_back({one->label, one->colour, box, one->lower, one->upper});
            labelled(one->label, size.height);
            if (apart) y += 0.4 * size.height;
        }
        y += 1.4 * style.gap;
    }
    for (const Outline& outline : *content.outlines) {
        if (outline.label.empty()) continue;
        const double line = style.line(outline.width_px);
        const std::array<Point, 2> ends{
            {{corner.x, y + size.height / 2}, {corner.x + size.width, y + size.height / 2}}};
        if (!outline.polygons.empty() || !outline.lines.empty())
            sheet.line(ends, {line, outline.colour, 1, outline_dashes(outline, line)});
        else
            draw_place(sheet, style, {corner.x + size.width / 2, y + size.height / 2}, outline.colour);
        labelled(outline.label, size.height);
        y += 0.2 * size.height;
    }
    if (!content.outlines->empty()) y += style.gap;
    for (const std::string& note : *content.notes) {
        y = sheet.lines(sheet.wrapped(note, style.label, width), {corner.x, y}, style.label, Across::left);
    }
    return y;
}

}  // namespace frana::render
