// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "core/grid_spec.h"

namespace frana {

/// A closed ring; the last point is not repeated. At least three points.
using Ring = std::vector<Point>;
using Polyline = std::vector<Point>;

/// An outline with its holes, in map coordinates of the working CRS.
struct Polygon {
    Ring outer;
    std::vector<Ring> holes;
};
using MultiPolygon = std::vector<Polygon>;

/// Areas, lines and points.
struct MixedShape {
    MultiPolygon areas;
    std::vector<Polyline> lines;
    std::vector<Point> points;

    [[nodiscard]] bool empty() const noexcept { return areas.empty() && lines.empty() && points.empty(); }
};

/// One feature of a vector layer, in map coordinates.
struct Feature {
    MixedShape shape;                       ///< empty: without geometry
    std::map<std::string, double> numbers;  ///< NaN: none
    std::map<std::string, std::string> texts;
    std::string name{};             ///< of the name column, else its number in the file
    std::optional<double> count{};  ///< of the column of counts
    std::int64_t fid = 0;           ///< in its file
};

/// Returns the area of a ring [m2], positive for either orientation.
double area(const Ring& ring);
/// Returns the area of a polygon [m2]: outer ring minus its holes.
double area(const Polygon& polygon);
double area(const MultiPolygon& polygons);

/// Returns whether a point is inside (even-odd rule, holes excluded). Points exactly on an edge belong to one side
/// only, so that neighbours sharing an edge never count a point twice.
bool contains(const Ring& ring, Point point);
bool contains(const Polygon& polygon, Point point);
bool contains(const MultiPolygon& polygons, Point point);

/// Returns whether all of a box is inside another; edges may touch. A point is a box without sides.
inline bool is_within(const Bounds& box, const Bounds& other) noexcept {
    return box.west >= other.west && box.east <= other.east && box.south >= other.south && box.north <= other.north;
}
/// Returns whether two boxes have no area in common.
inline bool are_apart(const Bounds& a, const Bounds& b) noexcept {
    return a.east <= b.west || a.west >= b.east || a.north <= b.south || a.south >= b.north;
}

/// Returns polygons with every point moved.
template <class Move>
MultiPolygon moved(MultiPolygon polygons, const Move& move) {
    for (Polygon& polygon : polygons) {
        for (Point& p : polygon.outer) p = move(p);
        for (Ring& hole : polygon.holes)
            for (Point& p : hole) p = move(p);
    }
    return polygons;
}

/// A map turned on its page. Coordinates of the page are metres to the right and upwards; not turned they are those of
/// the map.
struct MapTurn {
    double deg = 0;  ///< direction of grid north, clockwise from straight up on the page
    double c = 1, s = 0;

    MapTurn() = default;
    explicit MapTurn(double degrees)
        : deg(degrees),
          c(degrees == 0 ? 1 : std::cos(degrees * std::numbers::pi / 180)),
          s(degrees == 0 ? 0 : std::sin(degrees * std::numbers::pi / 180)) {}
    [[nodiscard]] Point page(Point map) const { return {map.x * c + map.y * s, map.y * c - map.x * s}; }
    [[nodiscard]] Point map(Point page) const { return {page.x * c - page.y * s, page.y * c + page.x * s}; }
    /// Whether eastings vary more than northings along a level line of the page.
    [[nodiscard]] bool east_is_level() const { return std::fabs(c) >= std::fabs(s); }
};

/// Returns the corners of a box, from the south-western one to the east.
inline Ring corners(const Bounds& box) {
    return {{box.west, box.south}, {box.east, box.south}, {box.east, box.north}, {box.west, box.north}};
}
/// Returns the smallest rectangle around all outer rings; all zero if there is none.
Bounds bounds(const MultiPolygon& polygons);

/// Returns "west 527000.00, south 5093000.00, east 528500.00, north 5094350.00", to the centimetre (1e-7 for degrees).
std::string extent_text(const Bounds& bounds, bool degrees = false);

/// `contains` for many points: the edges are sorted into bands by y, so that a point is compared only with the edges of
/// its band. The result equals that of `contains` for every point.
class InsideTest {
  public:
    explicit InsideTest(const MultiPolygon& polygons);

    [[nodiscard]] bool operator()(Point point) const;

  private:
    struct Edge {
        Point a, b;
        std::uint32_t polygon, ring;  // ring 0 is the outer one
    };

    [[nodiscard]] std::size_t band(double y) const;

    double south_ = 0, north_ = 0, height_ = 1;
    std::vector<Edge> edges_;            // by polygon and ring
    std::vector<std::size_t> begins_;    // of each band in `listed_`, and the end of the last
    std::vector<std::uint32_t> listed_;  // edges that cross each band, in their order
};

struct Segment {
    Point from, to;  // never equal
};

/// Finds the segment nearest to a point among many with a tree of bounding boxes, halved at the medians of the
/// segments. The distance equals that of comparing with every segment, to the bit.
class NearestSegment {
  public:
    NearestSegment() = default;
    explicit NearestSegment(std::vector<Segment> segments);

    [[nodiscard]] const std::vector<Segment>& segments() const noexcept { return segments_; }
    /// Returns the square of the distance; infinite if there is no segment.
    [[nodiscard]] double square_of_distance(Point point) const;

  private:
    struct Box {
        Bounds bounds;
        std::size_t first, last;              // segments
        std::array<std::size_t, 2> halves{};  // child boxes; both 0: none
    };

    std::size_t build(std::size_t first, std::size_t last);
    void search(std::size_t box, Point point, double& nearest) const;

    std::vector<Segment> segments_;
    std::vector<Box> boxes_;
};

}  // namespace frana
