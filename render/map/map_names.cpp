// SPDX-License-Identifier: Apache-2.0
#include "render/map/map_names.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace frana::render {
namespace {

/// A possible place of a name.
struct Try {
    Point at;
    Across across;
    Upright upright;
};

double common_area(const PageBox& a, const PageBox& b) {
    const double width = std::min(a.right, b.right) - std::max(a.left, b.left),
                 height = std::min(a.bottom, b.bottom) - std::max(a.top, b.top);
    return width > 0 && height > 0 ? width * height : 0;
}

/// The area of other letters under a name, or more than any if it would not be inside the frame.
double covered(const PageBox& box, const Sheet& sheet, const PageBox& frame) {
    if (!box.inside(frame)) return std::numeric_limits<double>::infinity();
    double area = 0;
    for (const TextBox& text : sheet.texts()) area += common_area(text.box, box);
    return area;
}

/// Writes a name at the first of these places that is free, or, if it `must` be written, where it covers least.
void write(Sheet& sheet, const std::string& name, const std::vector<Try>& tries, const TextStyle& style,
           const PageBox& frame, bool must) {
    const Try* best = nullptr;
    double least = std::numeric_limits<double>::infinity();
    for (const Try& one : tries) {
        const double area =
            covered(sheet.lettering().place(name, one.at, style, one.across, one.upright).box, sheet, frame);
        if (!(area < least)) continue;
        least = area;
        best = &one;
        if (area == 0) break;
    }
    if (best != nullptr && (must || least == 0)) sheet.text(name, best->at, style, best->across, best->upright);
}

std::vector<Try> beside_place(Point at, double away) {
    return {{{at.x + away, at.y}, Across::left, Upright::middle},
            {{at.x - away, at.y}, Across::right, Upright::middle},
            {{at.x, at.y - away}, Across::centre, Upright::baseline},
            {{at.x, at.y + away}, Across::centre, Upright::top}};
}

/// Beyond one end of a line that comes from another point.
Try beyond(Point end, Point from, double away) {
    const double length = std::max(std::hypot(end.x - from.x, end.y - from.y), 1e-9);
    const Point along{(end.x - from.x) / length, (end.y - from.y) / length};
    const Point at{end.x + away * along.x, end.y + away * along.y};
    if (std::fabs(along.x) > std::fabs(along.y))
        return {at, along.x > 0 ? Across::left : Across::right, Upright::middle};
    return {at, Across::centre, along.y > 0 ? Upright::top : Upright::baseline};
}

/// The ends of the line's part inside the frame, then beside them and its middle.
std::vector<Try> beside_line(const Polyline& line, const MapFrame& frame, double away) {
    const PageBox box = frame.box();
    Polyline inside;
    constexpr int k_parts = 32;  // of each of its pieces
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const Point a = frame.page(line[i]), b = frame.page(line[i + 1]);
        for (int k = i == 0 ? 0 : 1; k <= k_parts; ++k) {
            const Point p{a.x + (b.x - a.x) * k / k_parts, a.y + (b.y - a.y) * k / k_parts};
            if (p.x > box.left && p.x < box.right && p.y > box.top && p.y < box.bottom) inside.push_back(p);
        }
    }
    if (inside.size() < 2) return {};
    std::vector<Try> tries{beyond(inside.back(), inside[inside.size() - 2], away), beyond(inside[0], inside[1], away)};
    const bool level = std::fabs(inside.back().x - inside[0].x) > std::fabs(inside.back().y - inside[0].y);
    for (const Point at : {inside.back(), inside.front(), inside[inside.size() / 2]}) {
        std::vector<Try> more = beside_place(at, away);
        if (level) std::rotate(more.begin(), more.begin() + 2, more.end());  // above and below first
        tries.insert(tries.end(), more.begin(), more.end());
    }
    return tries;
}

}  // namespace

void draw_names(Sheet& sheet, const PageStyle& style, const MapFrame& frame, const std::vector<Outline>& outlines) {
    TextStyle letters = style.small;
    letters.colour = k_ink;
    letters.halo_px = std::max(1.5, style.length(2.5));
    const double away = 0.8 * style.label.size_px, near = 0.5 * style.label.size_px;
    for (const Outline& outline : outlines) {
        for (const NamedPlace& one : outline.places)
            if (!one.name.empty())
                write(sheet, one.name, beside_place(frame.page(one.place), away), letters, frame.box(), false);
    }
    for (const Outline& outline : outlines) {
        letters.colour = outline.colour;
        for (std::size_t i = 0; i < std::min(outline.lines.size(), outline.names.size()); ++i)
            if (!outline.names[i].empty())
                write(sheet, outline.names[i], beside_line(outline.lines[i], frame, near), letters, frame.box(), true);
    }
}

}  // namespace frana::render
