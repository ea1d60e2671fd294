// SPDX-License-Identifier: Apache-2.0
#include "gis/vector/outline_check.h"

#include <cmath>
#include <sstream>

#include "gis/access/gdal_session.h"
#include "gis/vector/polygon_geometry.h"
#include "gis/vector/simple_outline.h"

namespace frana::gis {
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
