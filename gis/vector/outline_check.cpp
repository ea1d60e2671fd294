// SPDX-License-Identifier: Apache-2.0
#include "gis/vector/outline_check.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

#include "gis/access/gdal_session.h"

namespace frana::gis {
namespace {

constexpr int k_deepest_split = 12;  // 4096 pieces of an edge

// Whether all points have coordinates possible on a map, so that areas and distances can be computed.
bool on_a_map(const OGRLineString& line) {
    for (int i = 0; i < line.getNumPoints(); ++i) {
        if (!(std::abs(line.getX(i)) <= k_furthest && std::abs(line.getY(i)) <= k_furthest)) return false;
    }
    return true;
}

std::unique_ptr<OGRLinearRing> to_ogr_ring(const Ring& ring) {
    auto made = std::make_unique<OGRLinearRing>();
    for (const Point& point : ring) made->addPoint(point.x, point.y);
    made->closeRings();
    return made;
}

Ring from_ogr_ring(const OGRLinearRing& ring) {
    Ring made;
    for (int i = 0; i < ring.getNumPoints(); ++i) {
        const Point point{ring.getX(i), ring.getY(i)};
        if (made.empty() || made.back().x != point.x || made.back().y != point.y) made.push_back(point);
    }
    if (made.size() > 1 && made.front().x == made.back().x && made.front().y == made.back().y) made.pop_back();
    return made;
}

void note_open(const OGRLineString& line, PolygonParts& parts) {
    ++parts.open_lines;
    const int last = line.getNumPoints() - 1;
    if (last < 0) return;
    const double gap = std::hypot(line.getX(last) - line.getX(0), line.getY(last) - line.getY(0));
    parts.widest_gap = std::max(parts.widest_gap, gap);
}

void add_line(const OGRLineString& line, PolygonParts& parts) {
    if (!on_a_map(line)) {
        ++parts.unbounded;
        return;
    }
    if (line.getNumPoints() >= 4 && line.get_IsClosed()) {
        auto ring = std::make_unique<OGRLinearRing>();
        for (int i = 0; i < line.getNumPoints(); ++i) ring->addPoint(line.getX(i), line.getY(i));
        auto polygon = std::make_unique<OGRPolygon>();
        polygon->addRingDirectly(ring.release());
        parts.polygons.push_back(std::move(polygon));
        ++parts.closed_lines;
        return;
    }
    note_open(line, parts);
}

void add_polygon(const OGRPolygon& polygon, PolygonParts& parts) {
    for (const OGRLinearRing* ring : polygon) {
        if (!on_a_map(*ring)) {
            ++parts.unbounded;
            return;
        }
        if (ring->get_IsClosed()) continue;
        // Not closed here: if points were lost, the shortest closing edge is not the outline.
        note_open(*ring, parts);
        return;
    }
    parts.polygons.emplace_back(polygon.clone());
}

void add_parts(const OGRGeometry& geometry, PolygonParts& parts) {
    if (geometry.IsEmpty()) return;
    switch (wkbFlatten(geometry.getGeometryType())) {
        case wkbPolygon:
        case wkbTriangle:
            add_polygon(*geometry.toPolygon(), parts);
            break;
        case wkbLineString:
            add_line(*geometry.toLineString(), parts);
            break;
        case wkbMultiPolygon:
        case wkbMultiLineString:
        case wkbGeometryCollection:
            for (const OGRGeometry* part : *geometry.toGeometryCollection()) add_parts(*part, parts);
            break;
        case wkbPolyhedralSurface:
        case wkbTIN:
            for (const OGRPolygon* part : *geometry.toPolyhedralSurface()) add_parts(*part, parts);
            break;
        default:
            ++parts.others;
            break;
    }
}

struct Bend {
    const CrsTransform& transform;
    double tolerance;

    /// Adds the points after a up to and with b.
    void follow(Point a, Point b, Point to_a, Point to_b, int depth, Ring& out) const {
        if (depth < k_deepest_split && away(a, b, to_a, to_b)) {
            const Point middle{(a.x + b.x) / 2, (a.y + b.y) / 2};
            const Point to_middle = transform(middle);
            follow(a, middle, to_a, to_middle, depth + 1, out);
            follow(middle, b, to_middle, to_b, depth + 1, out);
            return;
        }
        out.push_back(to_b);
    }

    /// Checked at two places, so that an S-shaped edge does not count as straight.
    [[nodiscard]] bool away(Point a, Point b, Point to_a, Point to_b) const {
        for (const double t : {0.5, 0.25}) {
            const Point to = transform(Point{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
            const double straight_x = to_a.x + t * (to_b.x - to_a.x), straight_y = to_a.y + t * (to_b.y - to_a.y);
            if (std::hypot(to.x - straight_x, to.y - straight_y) > tolerance) return true;
        }
        return false;
    }
};

Ring transformed_ring(const Ring& ring, const CrsTransform& transform, double tolerance) {
    Ring out;
    const Bend bend{transform, tolerance};
    Point a = ring.back(), to_a = transform(a);
    for (const Point& b : ring) {
        const Point to_b = transform(b);
        bend.follow(a, b, to_a, to_b, 0, out);
        a = b;
        to_a = to_b;
    }
    return out;
}

}  // namespace

std::unique_ptr<OGRPolygon> to_ogr(const Polygon& polygon) {
    auto made = std::make_unique<OGRPolygon>();
    made->addRingDirectly(to_ogr_ring(polygon.outer).release());
    for (const Ring& hole : polygon.holes) made->addRingDirectly(to_ogr_ring(hole).release());
    return made;
}

std::unique_ptr<OGRMultiPolygon> to_ogr(const MultiPolygon& polygons) {
    auto made = std::make_unique<OGRMultiPolygon>();
    for (const Polygon& polygon : polygons) made->addGeometryDirectly(to_ogr(polygon).release());
    return made;
}

std::optional<Polygon> from_ogr(const OGRPolygon& polygon) {
    const OGRLinearRing* outer = polygon.getExteriorRing();
    if (!outer) return std::nullopt;
    Polygon made;
    made.outer = from_ogr_ring(*outer);
    if (made.outer.size() < 3) return std::nullopt;
    for (int i = 0; i < polygon.getNumInteriorRings(); ++i) {
        Ring hole = from_ogr_ring(*polygon.getInteriorRing(i));
        if (hole.size() >= 3) made.holes.push_back(std::move(hole));
    }
    return made;
}

PolygonParts polygon_parts(const OGRGeometry& geometry) {
    PolygonParts parts;
    const std::unique_ptr<OGRGeometry> straight(geometry.getLinearGeometry());
    if (straight) add_parts(*straight, parts);
    return parts;
}

Polygon transformed(const Polygon& polygon, const CrsTransform& transform, double tolerance) {
    if (transform.is_identity()) return polygon;
    Polygon made;
    made.outer = transformed_ring(polygon.outer, transform, tolerance);
    for (const Ring& hole : polygon.holes) made.holes.push_back(transformed_ring(hole, transform, tolerance));
    return made;
}

namespace {

// GEOS's messages for a ring that crosses itself or its hole, and for a hole that is none; with any other problem the
// interior is still well defined.
const std::string k_crossing = "Self-intersection", k_outside = "Hole lies outside shell";
const std::string k_place = " at or near point ";

/// Returns GEOS's message about a geometry; empty if it is valid.
std::string geometry_error(const OGRGeometry& geometry) {
    const GdalSession session;
    if (geometry.IsValid()) return {};
    const std::string message = session.last_message();
    return message.empty() ? "unsound" : message;
}

std::string place_text(double x, double y) {
    std::ostringstream text;
    text.precision(12);
    text << "at " << x << ", " << y;
    return text.str();
}

std::string place_in(const std::string& error_text) {
    const std::size_t start = error_text.find(k_place);
    if (start == std::string::npos) return {};
    std::istringstream numbers(error_text.substr(start + k_place.size()));
    double x = 0, y = 0;
    if (!(numbers >> x >> y)) return {};
    return place_text(x, y);
}

std::string area_text(double area) {
    std::ostringstream text;
    text.precision(6);
    text << area;
    return text.str();
}

/// GDAL's repair, in which every region counts once.
void repair(const OGRGeometry& geometry, const std::string& error_text, double area_before, OutlineCheck& found) {
    const GdalSession session;
    const std::unique_ptr<OGRGeometry> repaired(geometry.MakeValid());
    std::vector<std::unique_ptr<OGRPolygon>> polygons;
    if (repaired) polygons = polygon_parts(*repaired).polygons;
    double area_after = 0;
    for (const auto& polygon : polygons) area_after += polygon->get_Area();
    found.repairs.push_back(worded("outline repaired ({1}): area {2} before, {3} after",
                                   {error_text, numeral(area_text(area_before)), numeral(area_text(area_after))}));
    for (auto& polygon : polygons) found.polygons.push_back(std::move(polygon));
}

}  // namespace

OutlineCheck check_outline(std::vector<std::unique_ptr<OGRPolygon>> polygons) {
    OutlineCheck found;
    for (auto& polygon : polygons) {
        const std::string error_text = geometry_error(*polygon);
        const bool outside = error_text.rfind(k_outside, 0) == 0;
        if (outside || error_text.rfind(k_crossing, 0) == 0) {
            found.polygons.clear();
            (outside ? found.hole_outside : found.crossing) = place_in(error_text);
            return found;
        }
        if (error_text.empty()) {
            found.polygons.push_back(std::move(polygon));
        } else {
            repair(*polygon, error_text, polygon->get_Area(), found);
        }
    }
    if (found.polygons.size() < 2) return found;
    OGRMultiPolygon together;
    double sum = 0;
    for (const auto& polygon : found.polygons) {
        together.addGeometry(polygon.get());
        sum += polygon->get_Area();
    }
    const std::string error_text = geometry_error(together);
    if (error_text.empty()) return found;
    found.polygons.clear();
    const GdalSession session;
    const std::unique_ptr<OGRGeometry> united(together.UnionCascaded());
    if (united) found.polygons = polygon_parts(*united).polygons;
    double area_after = 0;
    for (const auto& polygon : found.polygons) area_after += polygon->get_Area();
    found.repairs.push_back(worded("overlapping parts united ({1}): area {2} before, {3} after",
                                   {error_text, numeral(area_text(sum)), numeral(area_text(area_after))}));
    return found;
}

}  // namespace frana::gis
