// SPDX-License-Identifier: Apache-2.0
#include "gis/vector/generalise.h"

#include <ogrsf_frmts.h>

#include <algorithm>
#include <memory>

#include "gis/access/gdal_session.h"
#include "gis/vector/outline_check.h"

namespace frana::gis {
namespace {

using Geometry = std::unique_ptr<OGRGeometry>;
using Parts = std::vector<std::unique_ptr<OGRPolygon>>;

/// GEOS gave no answer.
struct Failure {};

Geometry sound(OGRGeometry* made) {
    Geometry geometry(made);
    if (!geometry) throw Failure{};
    if (!geometry->IsValid()) geometry.reset(geometry->MakeValid());
    if (!geometry) throw Failure{};
    auto areas = std::make_unique<OGRMultiPolygon>();  // GEOS refuses areas together with lines
    for (const auto& part : polygon_parts(*geometry).polygons) areas->addGeometry(part.get());
    return areas;
}

constexpr double k_nothing = 1e-6;  // [m2]: what rounding leaves
constexpr int k_passes = 3;         // what a piece leaves behind may be small itself
constexpr int k_arc = 8;            // segments of a quarter of a circle

Geometry buffered(const OGRGeometry& geometry, double distance) {
    return sound(geometry.Buffer(distance, k_arc));
}
Geometry both(const OGRGeometry& a, const OGRGeometry& b) {
    return sound(a.Union(&b));
}
Geometry without(const OGRGeometry& a, const OGRGeometry& b) {
    return sound(a.Difference(&b));
}
Parts parts_of(const OGRGeometry& geometry) {
    return polygon_parts(geometry).polygons;
}

double area_of(const OGRGeometry& geometry) {
    double sum = 0;
    for (const auto& part : parts_of(geometry)) sum += part->get_Area();
    return sum;
}

Geometry together(const Parts& parts) {
    OGRMultiPolygon all;
    for (const auto& part : parts) all.addGeometry(part.get());
    return all.IsEmpty() ? Geometry(all.clone()) : sound(all.UnionCascaded());
}

/// Without polygons and holes that are smaller.
Geometry without_small(const OGRGeometry& geometry, double least_area) {
    Parts kept;
    for (const auto& part : parts_of(geometry)) {
        auto filled = std::make_unique<OGRPolygon>();
        filled->addRing(part->getExteriorRing());
        for (int i = 0; i < part->getNumInteriorRings(); ++i)
            if (part->getInteriorRing(i)->get_Area() >= least_area) filled->addRing(part->getInteriorRing(i));
        if (filled->get_Area() >= least_area) kept.push_back(std::move(filled));
    }
    return together(kept);
}

/// The class of cells, as people would draw it.
Geometry drawn(const OGRGeometry& cells, const LeastZone& least) {
    const double half = least.width / 2;
    Geometry shape(cells.clone());
    if (half > 0) {
        shape = buffered(*buffered(*shape, half), -2 * half);  // closed, and the first half of opening it
        shape = buffered(*shape, half);
    }
    if (least.tolerance > 0) shape = sound(shape->SimplifyPreserveTopology(least.tolerance));
    return without_small(*shape, least.area);
}

/// Gives what is too narrow or too small of a zone to one of the higher zones: that with which it has most in common.
void raise_slivers(Geometry& zone, std::vector<Geometry>& higher, const LeastZone& least) {
    constexpr double k_negligible = 0.05,  // of the least area: corners that opening rounds
        k_touch = 0.01;                    // [m]
    Parts kept, slivers;
    const double half = least.width / 2;
    for (auto& part : parts_of(*zone)) {
        if (part->get_Area() < least.area) {
            slivers.push_back(std::move(part));
            continue;
        }
        const Geometry wide = half > 0 ? buffered(*buffered(*part, -half), half + k_touch) : Geometry(part->clone());
        for (const auto& thin : parts_of(*without(*part, *wide)))  // as far as the zones beside it
            if (thin->get_Area() > k_negligible * least.area)
                for (auto& piece : parts_of(*sound(buffered(*thin, 2 * k_touch)->Intersection(part.get()))))
                    slivers.push_back(std::move(piece));
        kept.push_back(std::move(part));
    }
    zone = together(kept);
    for (const auto& sliver : slivers) {
        const Geometry wider = buffered(*sliver, k_touch);
        double most = 10 * k_touch * k_touch;  // more than a corner has
        Geometry* taker = nullptr;
        for (Geometry& other : higher) {
            const Geometry edge = sound(wider->Intersection(other.get()));
            if (const double length = area_of(*edge); length > most) {
                most = length;
                taker = &other;
            }
        }
        if (taker == nullptr) {  // alone: at the edge of its own zone
            zone = both(*zone, *sliver);
            continue;
        }
        *taker = both(**taker, *sliver);
        zone = without(*zone, *sliver);
    }
}

}  // namespace

std::vector<MultiPolygon> generalised(const std::vector<MultiPolygon>& at_least, const LeastZone& least) {
    const GdalSession session;
    std::vector<MultiPolygon> zones(at_least.size());
    try {
        std::vector<Geometry> all;  // from the highest
        Geometry above(new OGRMultiPolygon);
        double reached = 0;  // [m2] of the cells of the higher classes
        for (auto cells = at_least.rbegin(); cells != at_least.rend(); ++cells) {
            Parts parts;
            for (const Polygon& polygon : *cells) parts.push_back(to_ogr(polygon));
            const Geometry own = together(parts);
            Geometry zone(new OGRMultiPolygon);
            if (const double area = area_of(*own); area > reached + k_nothing) {  // else no cell has this class
                reached = area;
                zone = without(*drawn(*both(*own, *above), least), *above);
                for (int pass = 0; pass < k_passes; ++pass) raise_slivers(zone, all, least);
            }
            all.push_back(std::move(zone));
            above = Geometry(new OGRMultiPolygon);
            for (Geometry& one : all) {
                // What stays small is left to the zone below, as small zones are that lie alone.
                Parts large = parts_of(*one);
                std::erase_if(large, [&](const auto& part) { return part->get_Area() < least.area; });
                one = together(large);
                above = both(*above, *one);
            }
        }
        for (std::size_t i = 0; i < all.size(); ++i)
            for (const auto& part : parts_of(*all[i]))
                if (auto polygon = from_ogr(*part); polygon && area(*polygon) > k_nothing)
                    zones[all.size() - 1 - i].push_back(std::move(*polygon));
    } catch (const Failure&) {
        return {};
    }
    return zones;
}

}  // namespace frana::gis
