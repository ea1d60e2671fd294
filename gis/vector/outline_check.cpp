// SPDX-License-Identifier: Apache-2.0
#include "gis/vector/outline_check.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <sstream>
#include <utility>
#include <vector>

#include "gis/access/gdal_session.h"

namespace frana::gis {
namespace {

/// Thrown without a verdict: edges touch, or rounding hides whether they do.
struct Doubt {};

/// West before east, south before north: the order of points in the sweep.
bool earlier(Point a, Point b) {
    return a.x < b.x || (a.x == b.x && a.y < b.y);
}

/// Returns the side of a point from the line a to b: +1 left, -1 right; 0 if rounding hides it.
int side(Point a, Point b, Point p) {
    const double left = (b.x - a.x) * (p.y - a.y), right = (b.y - a.y) * (p.x - a.x);
    const double turn = left - right;
    // Five differences and two products, each with a relative rounding error of 1.1e-16.
    const double rounding = 1e-15 * (std::abs(left) + std::abs(right));
    if (!(std::abs(turn) > rounding)) return 0;
    return turn > 0 ? 1 : -1;
}

int certain(int known_side) {
    if (known_side == 0) throw Doubt{};
    return known_side;
}

struct Edge {
    Point first, last;  // in the order of the sweep
};

bool same(Point a, Point b) {
    return a.x == b.x && a.y == b.y;
}

/// Returns which of two edges on the sweep line is further south; they meet at most in an end.
bool further_south(const Edge& a, const Edge& b) {
    if (same(a.first, b.first)) return certain(side(a.first, a.last, b.last)) > 0;
    if (earlier(a.first, b.first)) return certain(side(a.first, a.last, b.first)) > 0;
    return certain(side(b.first, b.last, a.first)) < 0;
}

Point meeting(const Edge& a, const Edge& b) {
    const Point d{a.last.x - a.first.x, a.last.y - a.first.y}, e{b.last.x - b.first.x, b.last.y - b.first.y};
    const double t = ((b.first.x - a.first.x) * e.y - (b.first.y - a.first.y) * e.x) / (d.x * e.y - d.y * e.x);
    return {a.first.x + t * d.x, a.first.y + t * d.y};
}

class Sweep {
  public:
    explicit Sweep(const Polygon& polygon) : status_(South{this}) {
        add(polygon.outer);
        for (const Ring& hole : polygon.holes) add(hole);
        places_.resize(edges_.size(), status_.end());
        std::vector<std::size_t> order(vertices_.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::sort(order.begin(), order.end(),
                  [&](std::size_t a, std::size_t b) { return earlier(vertices_[a].place, vertices_[b].place); });
        for (std::size_t k = 0; k < order.size() && !crossing; ++k) {
            const Vertex& vertex = vertices_[order[k]];
            if (k > 0 && same(vertex.place, vertices_[order[k - 1]].place)) throw Doubt{};  // rings touch
            for (const std::size_t e : {vertex.before, vertex.after})
                if (same(edges_[e].last, vertex.place)) leave(e);
            for (const std::size_t e : {vertex.before, vertex.after})
                if (same(edges_[e].first, vertex.place)) enter(e);
        }
    }

    std::optional<Point> crossing;

  private:
    struct South {
        const Sweep* sweep;
        bool operator()(std::size_t a, std::size_t b) const {
            return a != b && further_south(sweep->edges_[a], sweep->edges_[b]);
        }
    };
    using Status = std::set<std::size_t, South>;
    struct Vertex {
        Point place;
        std::size_t before, after;  // its edges
    };

    void add(const Ring& ring) {
        const std::size_t first = edges_.size(), n = ring.size();
        for (std::size_t i = 0; i < n; ++i) {
            const Point a = ring[i], b = ring[(i + 1) % n];
            edges_.push_back(earlier(a, b) ? Edge{a, b} : Edge{b, a});
            vertices_.push_back({a, first + (i + n - 1) % n, first + i});
        }
    }

    void enter(std::size_t e) {
        const auto at = status_.insert(e).first;
        places_[e] = at;
        if (at != status_.begin()) compare(*std::prev(at), e);
        if (std::next(at) != status_.end()) compare(e, *std::next(at));
    }

    void leave(std::size_t e) {
        const auto at = places_[e], next = std::next(at);
        if (at != status_.begin() && next != status_.end()) compare(*std::prev(at), *next);
        status_.erase(at);
    }

    void compare(std::size_t one, std::size_t other) {
        const Edge &a = edges_[one], &b = edges_[other];
        if (same(a.first, b.first) || same(a.last, b.last) || same(a.first, b.last) || same(a.last, b.first)) {
            // Neighbours along the ring meet only in their vertex unless one lies on the other: collinear, and both on
            // the same side of it.
            if (same(a.first, b.first)) (void)certain(side(a.first, a.last, b.last));
            if (same(a.last, b.last)) (void)certain(side(a.last, a.first, b.first));
            return;
        }
        // Apart if both ends of either are on one side of the other.
        const int b_first = side(a.first, a.last, b.first), b_last = side(a.first, a.last, b.last);
        if (b_first * b_last > 0) return;
        const int a_first = side(b.first, b.last, a.first), a_last = side(b.first, b.last, a.last);
        if (a_first * a_last > 0) return;
        (void)certain(a_first * a_last * b_first * b_last);
        crossing = meeting(a, b);
    }

    std::vector<Edge> edges_;
    std::vector<Vertex> vertices_;
    Status status_;  // along the sweep line, from the south
    std::vector<Status::iterator> places_;
};

/// For rings that do not meet: whether each hole is inside the outline and in no other hole.
bool nested_once(const Polygon& polygon) {
    for (const Ring& hole : polygon.holes) {
        if (!contains(polygon.outer, hole.front())) return false;
        for (const Ring& other : polygon.holes)
            if (&other != &hole && contains(other, hole.front())) return false;
    }
    return true;
}

}  // namespace

OutlineVerdict sweep(const Polygon& polygon) {
    constexpr std::size_t k_most_holes = 100;  // each is tested against all others
    if (polygon.holes.size() > k_most_holes) return {};
    try {
        const Sweep swept(polygon);
        if (swept.crossing) return {false, swept.crossing};
        return {nested_once(polygon), std::nullopt};
    } catch (const Doubt&) {
        return {};
    }
}

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
    found.repairs.push_back(
        worded("the outline was repaired ({1}): area {2} before, {3} after, in its own units squared",
               {error_text, numeral(area_text(area_before)), numeral(area_text(area_after))}));
    for (auto& polygon : polygons) found.polygons.push_back(std::move(polygon));
}

/// For outlines of many vertices. GEOS compares all edges whose boxes overlap: with long spikes these are nearly all
/// pairs.
OutlineVerdict verdict_on(const OGRPolygon& polygon) {
    constexpr int k_many = 5000;
    const OGRLinearRing* outer = polygon.getExteriorRing();
    if (outer == nullptr || outer->getNumPoints() < k_many) return {};
    const std::optional<Polygon> ours = from_ogr(polygon);
    if (!ours || ours->holes.size() != static_cast<std::size_t>(polygon.getNumInteriorRings())) return {};
    return sweep(*ours);
}

}  // namespace

OutlineCheck check_outline(std::vector<std::unique_ptr<OGRPolygon>> polygons) {
    OutlineCheck found;
    for (auto& polygon : polygons) {
        const OutlineVerdict verdict = verdict_on(*polygon);
        if (verdict.crossing) {
            found.polygons.clear();
            found.crossing = place_text(verdict.crossing->x, verdict.crossing->y);
            return found;
        }
        const std::string error_text = verdict.sound ? std::string() : geometry_error(*polygon);
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
    found.repairs.push_back(
        worded("parts overlap or touch and were united ({1}): area {2} before, {3} after, in its own units squared",
               {error_text, numeral(area_text(sum)), numeral(area_text(area_after))}));
    return found;
}

double shared_area(const MultiPolygon& one, const MultiPolygon& other) {
    const Bounds a = bounds(one), b = bounds(other);
    if (a.east <= b.west || b.east <= a.west || a.north <= b.south || b.north <= a.south) return 0;
    const GdalSession session;
    const std::unique_ptr<OGRGeometry> both(to_ogr(one)->Intersection(to_ogr(other).get()));
    double area = 0;
    if (both) {
        for (const auto& polygon : polygon_parts(*both).polygons) area += polygon->get_Area();
    }
    return area;
}

}  // namespace frana::gis
