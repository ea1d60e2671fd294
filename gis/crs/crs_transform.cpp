// SPDX-License-Identifier: Apache-2.0
#include "gis/crs/crs_transform.h"

#include <geodesic.h>
#include <proj.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <utility>

#include "core/error.h"
#include "core/grid_spec.h"
#include "gis/crs/crs.h"

namespace frana::gis {

// Types of a member of CrsTransform, hence in no anonymous namespace.
struct ProjDelete {
    void operator()(PJ_CONTEXT* context) const noexcept { proj_context_destroy(context); }
    void operator()(PJ* object) const noexcept { proj_destroy(object); }
    void operator()(PJ_OBJ_LIST* list) const noexcept { proj_list_destroy(list); }
    void operator()(PJ_OPERATION_FACTORY_CONTEXT* factory) const noexcept {
        proj_operation_factory_context_destroy(factory);
    }
};

template <class T>
using ProjPointer = std::unique_ptr<T, ProjDelete>;

/// A coordinate operation ready for use, x to the east (longitude in degrees) on both sides.
struct CoordinateOperation {
    ProjPointer<PJ> pj;
    TransformInfo info;
};

namespace {

constexpr double k_least_area_degrees = 0.005;  // some 500 m: small compared with any operation's area

ProjPointer<PJ> make_crs(PJ_CONTEXT* context, const std::string& wkt) {
    ProjPointer<PJ> crs(proj_create(context, wkt.c_str()));
    if (!crs) {
        throw Error(ErrorKind::input, Problem{"PROJ does not know this coordinate reference system", "", crs_name(wkt),
                                              "", "Name it by its EPSG code"});
    }
    return crs;
}

/// Returns the geographic CRS of a projected one where it is that of `to` but for the order of its axes, else null. The
/// operation to that is a formula, for which PROJ need not search its database.
ProjPointer<PJ> own_degrees(PJ_CONTEXT* context, const PJ* from, const PJ* to) {
    const PJ_TYPE type = proj_get_type(to);
    if (proj_get_type(from) != PJ_TYPE_PROJECTED_CRS || type != PJ_TYPE_GEOGRAPHIC_2D_CRS) return nullptr;
    ProjPointer<PJ> own(proj_crs_get_geodetic_crs(context, from));
    const bool same =
        own && proj_get_type(own.get()) == type &&
        proj_is_equivalent_to_with_ctx(context, own.get(), to, PJ_COMP_EQUIVALENT_EXCEPT_AXIS_ORDER_GEOGCRS) != 0;
    return same ? std::move(own) : nullptr;
}

ProjPointer<PJ_OBJ_LIST> operations(PJ_CONTEXT* context, const PJ* from, const PJ* to, std::optional<Bounds> degrees,
                                    PROJ_GRID_AVAILABILITY_USE grids) {
    const ProjPointer<PJ_OPERATION_FACTORY_CONTEXT> factory(proj_create_operation_factory_context(context, nullptr));
    proj_operation_factory_context_set_spatial_criterion(context, factory.get(),
                                                         PROJ_SPATIAL_CRITERION_PARTIAL_INTERSECTION);
    proj_operation_factory_context_set_grid_availability_use(context, factory.get(), grids);
    if (degrees) {
        // For an area without extent PROJ considers every operation equally near, including those for other countries.
        degrees->west -= k_least_area_degrees;
        degrees->south -= k_least_area_degrees;
        degrees->east += k_least_area_degrees;
        degrees->north += k_least_area_degrees;
        // PROJ represents an area across the antimeridian by west > east.
        if (degrees->east > 180) degrees->east -= 360;
        if (degrees->west < -180) degrees->west += 360;
        proj_operation_factory_context_set_area_of_interest(context, factory.get(), degrees->west, degrees->south,
                                                            degrees->east, degrees->north);
    }
    return ProjPointer<PJ_OBJ_LIST>(proj_create_operations(context, from, to, factory.get()));
}

/// Whether only formulas are involved (a projection and its inverse), no change of datum.
bool exact(PJ_CONTEXT* context, const PJ* operation) {
    if (proj_get_type(operation) == PJ_TYPE_CONVERSION) return true;
    if (proj_get_type(operation) != PJ_TYPE_CONCATENATED_OPERATION) return false;
    for (int i = 0; i < proj_concatoperation_get_step_count(context, operation); ++i) {
        const ProjPointer<PJ> step(proj_concatoperation_get_step(context, operation, i));
        if (!step || !exact(context, step.get())) return false;
    }
    return true;
}

ProjPointer<PJ> first_operation(PJ_CONTEXT* context, const ProjPointer<PJ_OBJ_LIST>& list) {
    const bool some = list && proj_list_get_count(list.get()) > 0;
    return ProjPointer<PJ>(some ? proj_list_get(context, list.get(), 0) : nullptr);
}

/// Returns the first grid file that an operation needs and that is not installed.
std::string missing_grid(PJ_CONTEXT* context, const PJ* operation) {
    for (int i = 0; i < proj_coordoperation_get_grid_used_count(context, operation); ++i) {
        const char* name = nullptr;
        int available = 0;
        if (proj_coordoperation_get_grid_used(context, operation, i, &name, nullptr, nullptr, nullptr, nullptr, nullptr,
                                              &available) &&
            !available && name) {
            return name;
        }
    }
    return {};
}

std::string name_of(const PJ* operation) {
    const char* name = proj_get_name(operation);
    return name ? name : "unnamed";
}

/// Returns a silent context that never uses the network: a run must not depend on it.
ProjPointer<PJ_CONTEXT> make_proj_context() {
    ProjPointer<PJ_CONTEXT> context(proj_context_create());
    proj_log_level(context.get(), PJ_LOG_NONE);
    proj_context_set_enable_network(context.get(), 0);
    return context;
}

/// Returns PROJ's best operation between two CRSs (WKT) among those whose grids are installed; `degrees` is the area of
/// interest in longitude and latitude. Throws Error(input) if there is none.
CoordinateOperation choose_operation(PJ_CONTEXT* context, const std::string& from_wkt, const std::string& to_wkt,
                                     std::optional<Bounds> degrees) {
    const ProjPointer<PJ> from = make_crs(context, from_wkt);
    ProjPointer<PJ> to = make_crs(context, to_wkt);
    if (ProjPointer<PJ> own = own_degrees(context, from.get(), to.get())) to = std::move(own);
    const ProjPointer<PJ> usable = first_operation(
        context,
        operations(context, from.get(), to.get(), degrees, PROJ_GRID_AVAILABILITY_DISCARD_OPERATION_IF_MISSING_GRID));
    CoordinateOperation chosen;
    if (usable) chosen.pj.reset(proj_normalize_for_visualization(context, usable.get()));
    if (!chosen.pj) {
        throw Error(ErrorKind::input, Problem{"there is no transformation between the two coordinate reference systems",
                                              "", crs_name(from_wkt) + " to " + crs_name(to_wkt), "",
                                              "Check that both are valid for this part of the world"});
    }
    chosen.info.operation = name_of(usable.get());
    const bool by_formula = exact(context, usable.get());
    chosen.info.accuracy_m = by_formula ? 0 : proj_coordoperation_get_accuracy(context, usable.get());
    if (by_formula) return chosen;
    const ProjPointer<PJ> wished =
        first_operation(context, operations(context, from.get(), to.get(), degrees, PROJ_GRID_AVAILABILITY_IGNORED));
    if (wished && !proj_coordoperation_is_instantiable(context, wished.get())) {
        const double accuracy = proj_coordoperation_get_accuracy(context, wished.get());
        chosen.info.needs_missing_grid =
            chosen.info.accuracy_m < 0 || (accuracy >= 0 && accuracy < chosen.info.accuracy_m);
        if (chosen.info.needs_missing_grid) {
            chosen.info.missing_grid = missing_grid(context, wished.get());
            chosen.info.missing_accuracy_m = accuracy;
        }
    }
    return chosen;
}

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
