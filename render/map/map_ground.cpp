// SPDX-License-Identifier: Apache-2.0
#include "render/map/map_ground.h"

#include <algorithm>
#include <cmath>

#include "render/map/graticule.h"
#include "render/map/map_lines.h"
#include "render/map/map_names.h"
#include "render/map/map_window.h"

namespace frana::render {
namespace {

bool same(Point a, Point b) {
    return a.x == b.x && a.y == b.y;
}

bool same(const Polyline& a, const Polyline& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](Point p, Point q) { return same(p, q); });
}

bool same(const Outline& a, const Outline& b) {
    const auto same_lines = [](const auto& x, const auto& y) {
        return std::equal(x.begin(), x.end(), y.begin(), y.end(),
                          [](const Polyline& p, const Polyline& q) { return same(p, q); });
    };
    return a.label == b.label && a.colour == b.colour && a.width_px == b.width_px && a.dashed == b.dashed &&
           a.names == b.names && same_lines(a.lines, b.lines) &&
           std::equal(a.polygons.begin(), a.polygons.end(), b.polygons.begin(), b.polygons.end(),
                      [&](const Polygon& p, const Polygon& q) {
                          return same(p.outer, q.outer) && same_lines(p.holes, q.holes);
                      }) &&
           std::equal(
               a.places.begin(), a.places.end(), b.places.begin(), b.places.end(),
               [](const NamedPlace& p, const NamedPlace& q) { return p.name == q.name && same(p.place, q.place); });
}

bool same(const MapFrame& a, const MapFrame& b) {
    return a.left == b.left && a.top == b.top && a.width == b.width && a.height == b.height &&
           a.window.west == b.window.west && a.window.south == b.window.south && a.window.east == b.window.east &&
           a.window.north == b.window.north;
}

/// The cells that the raster, or all rasters of a series, may colour.
const Raster* coloured(const MapSpec& spec) {
    if (spec.extent == nullptr) return spec.layer;
    if (spec.layer == nullptr) return spec.extent;
    if (!spec.extent->grid.same_cells(spec.layer->grid)) return spec.layer;
    bool beyond = false;
    spec.layer->values.for_each_stored([&](std::size_t cell, double value) {
        beyond = beyond || (!std::isnan(value) && std::isnan(spec.extent->values[cell]));
    });
    return beyond ? spec.layer : spec.extent;
}

void cover_outside(Sheet& sheet, const PageBox& page, const PageBox& map) {
    const Rgb paper{255, 255, 255};
    sheet.fill(PageBox{page.left, page.top, page.right, map.top}, paper);
    sheet.fill(PageBox{page.left, map.bottom, page.right, page.bottom}, paper);
    sheet.fill(PageBox{page.left, map.top, map.left, map.bottom}, paper);
    sheet.fill(PageBox{map.right, map.top, page.right, map.bottom}, paper);
}

void draw_lines(const MapSpec& spec, const PageStyle& style, MapGround& ground) {
    Sheet sheet(ground.width, ground.height);
    const MapFrame& frame = ground.frame;
    draw_names(sheet, style, frame, spec.outlines);
    if (spec.terrain != nullptr && spec.contours)
        ground.contour_interval =
            draw_contours(sheet, style, frame, *spec.terrain, ground.kept_clear, spec.outlines, spec.words);
    draw_outlines(sheet, style, frame, spec.outlines);
    cover_outside(sheet, {0, 0, static_cast<double>(ground.width), static_cast<double>(ground.height)}, frame.box());
    draw_coordinates(sheet, style, frame, !map_grid(spec).crs_wkt.empty(), spec.words);
    if (spec.longitude_latitude) draw_graticule(sheet, style, frame, spec.longitude_latitude, spec.words);
    sheet.frame(frame.box(), {style.line(2), k_ink, 1, {}});
    ground.texts = sheet.texts();
    ground.above = sheet.take();
}

void draw_face(const MapSpec& spec, MapGround& ground) {
    const MapFrame frame = ground.frame.alone();
    ground.face = Image(frame.width, frame.height, k_no_terrain);
    if (spec.background) {
        paint_background(ground.face, frame, spec.background);
    } else if (spec.terrain != nullptr) {
        paint_relief(ground.face, frame, *spec.terrain);
    }
}

}  // namespace

const MapGround& ground_for(const MapSpec& spec, const MapFrame& frame, double density,
                            std::shared_ptr<const MapGround>& kept) {
    const Raster* clear = coloured(spec);
    const auto fits = [&](const MapGround& one) {
        return one.width == spec.width && one.height == spec.height && one.density == density &&
               one.least_letters == spec.least_letters && same(one.frame, frame) && one.terrain == spec.terrain &&
               one.kept_clear == clear && one.language == spec.words.language() &&
               std::equal(one.outlines.begin(), one.outlines.end(), spec.outlines.begin(), spec.outlines.end(),
                          [](const Outline& a, const Outline& b) { return same(a, b); });
    };
    if (kept && fits(*kept)) return *kept;
    auto ground = std::make_shared<MapGround>(MapGround{spec.width,
                                                        spec.height,
                                                        density,
                                                        spec.least_letters,
                                                        frame,
                                                        spec.terrain,
                                                        clear,
                                                        spec.outlines,
                                                        {},
                                                        {},
                                                        {},
                                                        0,
                                                        spec.words.language()});
    draw_lines(spec, PageStyle(spec.width, spec.height, density, spec.least_letters), *ground);
    draw_face(spec, *ground);
    kept = std::move(ground);
    return *kept;
}

}  // namespace frana::render
