// SPDX-License-Identifier: Apache-2.0
#include "gis/crs/crs_transform.h"

#include <geodesic.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

#include "core/error.h"
#include "gis/crs/coordinate_operation.h"
#include "gis/crs/crs.h"

namespace frana::gis {
namespace {

constexpr int k_points_per_edge = 21;

std::string text_of(Point point) {
    std::ostringstream text;
    text.precision(12);
    text << point.x << ", " << point.y;
    return text.str();
}

/// Returns points along a rectangle's edges.
std::vector<Point> rim(const Bounds& b) {
    std::vector<Point> points;
    for (int i = 0; i < k_points_per_edge; ++i) {
        const double t = static_cast<double>(i) / (k_points_per_edge - 1);
        const double x = b.west + t * b.width(), y = b.south + t * b.height();
        points.insert(points.end(), {{x, b.south}, {x, b.north}, {b.west, y}, {b.east, y}});
    }
    return points;
}

PJ_COORD transformed(PJ* operation, PJ_DIRECTION direction, Point from) {
    proj_errno_reset(operation);
    return proj_trans(operation, direction, proj_coord(from.x, from.y, 0, HUGE_VAL));
}

bool good(const PJ_COORD& coordinate) {
    return std::isfinite(coordinate.xy.x) && std::isfinite(coordinate.xy.y);
}

/// Whether an operation moves the points by less than a millimetre (1e-8 degrees). ETRS89 and WGS 84, for one, are
/// treated as the same, although their ellipsoids move a point by a tenth of a millimetre.
bool leaves_in_place(PJ* operation, const std::vector<Point>& points, bool degrees) {
    const double tolerance = degrees ? 1e-8 : 1e-3;
    return std::all_of(points.begin(), points.end(), [&](Point point) {
        const PJ_COORD to = transformed(operation, PJ_FWD, point);
        return good(to) && std::abs(to.xy.x - point.x) <= tolerance && std::abs(to.xy.y - point.y) <= tolerance;
    });
}

std::optional<Bounds> box(const std::vector<Point>& points) {
    constexpr double far = std::numeric_limits<double>::infinity();
    Bounds found{far, far, -far, -far};
    for (const Point& point : points) {
        found.west = std::min(found.west, point.x);
        found.east = std::max(found.east, point.x);
        found.south = std::min(found.south, point.y);
        found.north = std::max(found.north, point.y);
    }
    if (!std::isfinite(found.west) || !std::isfinite(found.south)) return std::nullopt;
    return found;
}

std::optional<Bounds> in_degrees(PJ_CONTEXT* context, const std::string& wkt, const std::vector<Point>& points) {
    const CoordinateOperation to_degrees = choose_operation(context, wkt, "OGC:CRS84", std::nullopt);
    std::vector<Point> found;
    for (const Point& point : points) {
        const PJ_COORD place = transformed(to_degrees.pj.get(), PJ_FWD, point);
        if (good(place)) found.push_back({place.xy.x, place.xy.y});
    }
    const std::optional<Bounds> plain = box(found);
    if (!plain || plain->width() <= 180) return plain;
    // Across the antimeridian the points are at both ends of the scale: from 0 to 360 they are one group.
    for (Point& point : found) point.x += point.x < 0 ? 360 : 0;
    const std::optional<Bounds> shifted = box(found);
    return shifted->width() < plain->width() ? shifted : plain;
}

}  // namespace

struct CrsTransform::Parts {
    ProjPointer<PJ_CONTEXT> context;
    CoordinateOperation operation;
    bool identity = true;
    double turn = 0;
    std::string names;  // "A to B", for messages

    [[nodiscard]] Point move(Point point, PJ_DIRECTION direction) const {
        if (identity) return point;
        const PJ_COORD moved = transformed(operation.pj.get(), direction, point);
        if (good(moved)) return {moved.xy.x, moved.xy.y};
        throw Error(ErrorKind::input, Problem{"a point cannot be transformed, " + names, "", text_of(point), "",
                                              "Check that the coordinate reference system is that of the coordinates"});
    }
};

CrsTransform::CrsTransform(const std::string& from_wkt, const std::string& to_wkt,
                           std::optional<Bounds> area_of_interest)
    : parts_(std::make_unique<Parts>()) {
    parts_->operation.info.operation = "none";
    if (from_wkt.empty() || to_wkt.empty()) return;
    const std::string from = horizontal_crs(from_wkt), to = horizontal_crs(to_wkt);
    if (from == to && !from.empty()) return;
    parts_->names = crs_name(from) + " to " + crs_name(to);
    parts_->turn = longitude_turn(from);
    parts_->context = make_proj_context();
    const std::vector<Point> points = area_of_interest ? rim(*area_of_interest) : std::vector<Point>{};
    std::optional<Bounds> degrees;
    if (area_of_interest) degrees = in_degrees(parts_->context.get(), from, points);
    parts_->operation = choose_operation(parts_->context.get(), from, to, degrees);
    PJ* operation = parts_->operation.pj.get();
    const bool in_degrees_already = proj_degree_input(operation, PJ_FWD) != 0;
    parts_->identity = !points.empty() && leaves_in_place(operation, points, in_degrees_already);
    if (parts_->identity && parts_->operation.info.accuracy_m == 0) parts_->operation.info.operation = "none";
}

CrsTransform::~CrsTransform() = default;
CrsTransform::CrsTransform(CrsTransform&&) noexcept = default;
CrsTransform& CrsTransform::operator=(CrsTransform&&) noexcept = default;

Point CrsTransform::operator()(Point from) const {
    return parts_->move(from, PJ_FWD);
}

Point CrsTransform::inverse(Point to) const {
    return parts_->move(to, PJ_INV);
}

bool CrsTransform::apply(std::span<double> x, std::span<double> y, bool backwards) const {
    if (parts_->identity) return true;
    bool all_good = true;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const PJ_COORD moved = transformed(parts_->operation.pj.get(), backwards ? PJ_INV : PJ_FWD, {x[i], y[i]});
        const bool this_good = good(moved);
        x[i] = this_good ? moved.xy.x : std::numeric_limits<double>::quiet_NaN();
        y[i] = this_good ? moved.xy.y : std::numeric_limits<double>::quiet_NaN();
        all_good = all_good && this_good;
    }
    return all_good;
}

Bounds CrsTransform::around(const Bounds& from) const {
    if (parts_->identity) return from;
    std::vector<Point> points = rim(from);
    for (Point& point : points) point = (*this)(point);
    return box(points).value_or(Bounds{});
}

const TransformInfo& CrsTransform::info() const noexcept {
    return parts_->operation.info;
}

double CrsTransform::source_turn() const noexcept {
    return parts_->turn;
}

bool CrsTransform::is_identity() const noexcept {
    return parts_->identity;
}

namespace {

// Long compared with the rounding of degrees, short compared with the curvature of any map.
constexpr double k_baseline = 100;  // [m]
constexpr double k_wgs84_a = 6378137, k_wgs84_f = 1 / 298.257223563;

}  // namespace

double MapScale::error() const noexcept {
    return std::max(std::abs(least - 1), std::abs(greatest - 1));
}

MapScale map_scale(const std::string& wkt, Point map) {
    if (wkt.empty()) return {};
    const CrsTransform to_degrees(wkt, "OGC:CRS84", Bounds{map.x, map.y, map.x, map.y});
    geod_geodesic ellipsoid;
    geod_init(&ellipsoid, k_wgs84_a, k_wgs84_f);
    MapScale scale{HUGE_VAL, 0};
    for (const Point half :
         {Point{0.5, 0}, Point{0, 0.5}, Point{M_SQRT1_2 / 2, M_SQRT1_2 / 2}, Point{M_SQRT1_2 / 2, -M_SQRT1_2 / 2}}) {
        const Point a = to_degrees({map.x - k_baseline * half.x, map.y - k_baseline * half.y});
        const Point b = to_degrees({map.x + k_baseline * half.x, map.y + k_baseline * half.y});
        double ground = 0;
        geod_inverse(&ellipsoid, a.y, a.x, b.y, b.x, &ground, nullptr, nullptr);
        scale.least = std::min(scale.least, k_baseline / ground);
        scale.greatest = std::max(scale.greatest, k_baseline / ground);
    }
    return scale;
}

}  // namespace frana::gis
