// SPDX-License-Identifier: Apache-2.0
#include "render/map/map_ground.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "render/canvas/image.h"
#include "render/canvas/page.h"
#include "render/map/legend.h"
#include "render/map/map2d.h"
#include "render/map/map_body.h"
#include "render/map/map_lines.h"

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

/// Writes the names of places beside them where there is room, and those of lines beyond their ends, or beside them;
/// a line's name that would cover other letters everywhere is where it covers least. Call before the contours, whose
/// labels avoid them.
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

constexpr double k_whole_pixel = 1e-6;
constexpr int k_least_frame = 80;  // px

void include(std::optional<Bounds>& all, const Bounds& one) {
    if (!all) {
        all = one;
        return;
    }
    *all = {std::min(all->west, one.west), std::min(all->south, one.south), std::max(all->east, one.east),
            std::max(all->north, one.north)};
}

/// Moves an interval of fixed length into limits, or to their middle if it is longer.
void keep_within(double& from, double& to, double least, double most) {
    const double length = to - from;
    from = length >= most - least ? (least + most - length) / 2 : std::clamp(from, least, most - length);
    to = from + length;
}

/// Returns the grid with the CRS of a map.
const GridSpec& map_grid(const MapSpec& spec) {
    return (spec.layer != nullptr ? spec.layer : spec.extent != nullptr ? spec.extent : spec.terrain)->grid;
}

/// The least box in coordinates of the page.
Bounds box_of(Ring points, const MapTurn& turn) {
    for (Point& p : points) p = turn.page(p);
    return bounds(MultiPolygon{{std::move(points), {}}});
}

/// Corners of the first and the last cell with a value of each row.
void add_ends(const Raster& raster, Ring& points) {
    const GridSpec& grid = raster.grid;
    std::map<std::int64_t, std::pair<std::int64_t, std::int64_t>> ends;
    raster.values.for_each_stored([&](std::size_t cell, double value) {
        if (std::isnan(value)) return;
        const auto at = static_cast<std::int64_t>(cell), column = at % grid.columns;
        const auto [row, is_new] = ends.try_emplace(at / grid.columns, column, column);
        row->second = {std::min(row->second.first, column), std::max(row->second.second, column)};
    });
    for (const auto& [row, columns] : ends) {
        const double north = grid.north - static_cast<double>(row) * grid.cell_size;
        for (const Point corner :
             corners({grid.west + static_cast<double>(columns.first) * grid.cell_size, north - grid.cell_size,
                      grid.west + static_cast<double>(columns.second + 1) * grid.cell_size, north}))
            points.push_back(corner);
    }
}

/// The flow and the outlines: points that together lie as far out as they do. Empty without either.
Ring content_points(const MapSpec& spec) {
    Ring points;
    for (const Raster* raster : {spec.extent, spec.layer}) {
        if (raster == nullptr || (raster == spec.layer && !spec.layer_frames_map)) continue;
        add_ends(*raster, points);
    }
    for (const Outline& outline : spec.outlines)
        for (const Polygon& polygon : outline.polygons)
            if (outline.frames_map) points.insert(points.end(), polygon.outer.begin(), polygon.outer.end());
    return points;
}

/// The flow and the outlines in coordinates of the page; none without either.
std::optional<Bounds> content(const MapSpec& spec) {
    if (spec.turn.deg != 0) {
        const Ring points = content_points(spec);
        return points.empty() ? std::nullopt : std::optional(box_of(points, spec.turn));
    }
    std::optional<Bounds> shown;
    for (const Raster* raster : {spec.extent, spec.layer}) {
        if (raster == nullptr || (raster == spec.layer && !spec.layer_frames_map)) continue;
        if (const auto data = data_bounds(*raster)) include(shown, *data);
    }
    for (const Outline& outline : spec.outlines) {
        if (outline.frames_map && !outline.polygons.empty()) include(shown, bounds(outline.polygons));
    }
    return shown;
}

}  // namespace

MapTurn turn_along_content(const MapSpec& spec, std::optional<bool> upright) {
    const Raster* const flow = spec.extent != nullptr ? spec.extent : spec.layer;
    if (flow == nullptr) return {};
    double n = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;  // moments of the cells' places
    flow->values.for_each_stored([&](std::size_t cell, double value) {
        if (std::isnan(value)) return;
        const auto at = static_cast<std::int64_t>(cell);
        const auto east = static_cast<double>(at % flow->grid.columns),
                   north = -static_cast<double>(at / flow->grid.columns);
        n += 1;
        x += east;
        y += north;
        xx += east * east;
        xy += east * north;
        yy += north * north;
    });
    if (!(n > 1)) return {};
    const double axis = std::atan2(2 * (xy - x * y / n), xx - yy - (x * x - y * y) / n) / 2;
    const double level = std::round(axis * 180 / std::numbers::pi);  // anticlockwise from east
    if (!upright.value_or(std::abs(level) > 45)) return MapTurn(level);
    return MapTurn(level > 0 ? level - 90 : level + 90);
}

Bounds required_window(const MapSpec& spec) {
    const auto turned = [&](const Bounds& box) { return box_of(corners(box), spec.turn); };
    if (spec.window) return turned(*spec.window);
    if (const auto shown = content(spec)) return *shown;
    return turned(spec.terrain != nullptr ? spec.terrain->grid.bounds() : map_grid(spec).bounds());
}

Bounds map_window(const MapSpec& spec, int frame_width, int frame_height) {
    const Bounds required = required_window(spec);
    Bounds window = required;
    if (!spec.window && content(spec)) {
        constexpr double k_margin = 0.14, k_least_cells = 20;
        const double side = std::max({window.width(), window.height(), k_least_cells * map_grid(spec).cell_size});
        const double margin = k_margin * side;
        window = {window.west - margin, window.south - margin, window.east + margin, window.north + margin};
    }
    const double aspect = static_cast<double>(frame_width) / frame_height;
    const double width = std::max(window.width(), window.height() * aspect), height = width / aspect;
    const double x = (window.west + window.east) / 2, y = (window.south + window.north) / 2;
    window = {x - width / 2, y - height / 2, x + width / 2, y + height / 2};
    window = window_at_scale(spec.print, required, window, frame_width, frame_height);
    if (!spec.window && spec.terrain != nullptr && spec.turn.deg == 0) {
        const Bounds ground = spec.terrain->grid.bounds();
        keep_within(window.west, window.east, ground.west, ground.east);
        keep_within(window.south, window.north, ground.south, ground.north);
    }
    return window;
}

void keep_to_ground(const MapSpec& spec, MapFrame& frame) {
    if (spec.window || spec.terrain == nullptr || spec.turn.deg != 0) return;
    std::optional<Bounds> ground = spec.terrain->grid.bounds();
    include(ground, required_window(spec));
    const double metre = frame.metres_per_pixel();
    const auto keep = [metre](int& pixels, double& from, double& to, double least, double most) {
        const int needed = static_cast<int>(std::ceil((most - least) / metre - k_whole_pixel));
        if (needed >= pixels) return;
        pixels = std::max(needed, k_least_frame);
        from = (least + most - pixels * metre) / 2;
        to = from + pixels * metre;
    };
    keep(frame.width, frame.window.west, frame.window.east, ground->west, ground->east);
    keep(frame.height, frame.window.south, frame.window.north, ground->south, ground->north);
}

namespace {

void cover_outside(Sheet& sheet, const PageBox& page, const PageBox& map) {
    const Rgb paper{255, 255, 255};
    sheet.fill(PageBox{page.left, page.top, page.right, map.top}, paper);
    sheet.fill(PageBox{page.left, map.bottom, page.right, page.bottom}, paper);
    sheet.fill(PageBox{page.left, map.top, map.left, map.bottom}, paper);
    sheet.fill(PageBox{map.right, map.top, page.right, map.bottom}, paper);
}

bool same(const MapFrame& a, const MapFrame& b) {
    return a.left == b.left && a.top == b.top && a.width == b.width && a.height == b.height &&
           a.turn.deg == b.turn.deg && a.window.west == b.window.west && a.window.south == b.window.south &&
           a.window.east == b.window.east && a.window.north == b.window.north;
}

}  // namespace

const MapGround& ground_for(const MapSpec& spec, const MapFrame& frame, std::shared_ptr<const MapGround>& kept) {
    if (kept && kept->terrain == spec.terrain && same(kept->frame, frame)) return *kept;
    const bool contours = spec.terrain != nullptr && spec.contours;
    kept =
        std::make_shared<MapGround>(MapGround{frame, spec.terrain, ground_picture(frame, spec.terrain, spec.background),
                                              contours ? find_contours(frame, *spec.terrain) : Contours{}});
    return *kept;
}

void draw_lines(Sheet& sheet, const PageStyle& style, const MapSpec& spec, const MapGround& ground) {
    const MapFrame& frame = ground.frame;
    draw_names(sheet, style, frame, spec.outlines);
    draw_contours(sheet, style, frame, ground.contours, spec.extent != nullptr ? spec.extent : spec.layer,
                  spec.outlines, spec.words);
    draw_outlines(sheet, style, frame, spec.outlines);
    cover_outside(sheet, {0, 0, static_cast<double>(spec.width), static_cast<double>(spec.height)}, frame.box());
    draw_coordinates(sheet, style, frame, !map_grid(spec).crs_wkt.empty(), spec.words);
    if (spec.longitude_latitude) draw_graticule(sheet, style, frame, spec.longitude_latitude, spec.words);
    sheet.frame(frame.box(), {style.line(2), k_ink, 1, {}});
}

}  // namespace frana::render
