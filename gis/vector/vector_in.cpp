// SPDX-License-Identifier: Apache-2.0
#include "gis/vector/vector_in.h"

#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/text.h"
#include "gis/access/file_access.h"
#include "gis/access/gdal_session.h"
#include "gis/crs/crs.h"
#include "gis/vector/outline_check.h"
#include "gis/vector/vector_source.h"

namespace frana::gis {
namespace {

constexpr double k_bend_tolerance = 1e-3;          // 1 mm if the target is in metres
constexpr double k_bend_tolerance_degrees = 1e-8;  // the same on the ground

constexpr const char* k_crs_key = "perimeter-crs";

constexpr std::size_t k_most_problems = 10;  // a layer of lines would have one per feature

/// Whether a layer can have areas: closed lines count, points do not.
bool may_contain_areas(OGRLayer& layer) {
    const OGRwkbGeometryType type = wkbFlatten(layer.GetGeomType());
    return type != wkbNone && type != wkbPoint && type != wkbMultiPoint;
}

void read_attributes(const OGRFeature& from, PolygonFeature& feature) {
    const OGRFeatureDefn& fields = *from.GetDefnRef();
    for (int i = 0; i < fields.GetFieldCount(); ++i) {
        if (!from.IsFieldSetAndNotNull(i)) continue;
        const OGRFieldDefn& field = *fields.GetFieldDefn(i);
        const OGRFieldType type = field.GetType();
        if (type == OFTInteger || type == OFTInteger64 || type == OFTReal) {
            feature.numbers[field.GetNameRef()] = from.GetFieldAsDouble(i);
        } else {
            feature.texts[field.GetNameRef()] = from.GetFieldAsString(i);
        }
    }
}

/// Returns one feature in its own CRS; adds to `problems` why it cannot be used ("crosses itself").
PolygonFeature read_feature(const OGRFeature& from, const VectorSource& source, Problems& problems,
                            CountedTexts& warnings) {
    PolygonFeature feature;
    read_attributes(from, feature);
    const std::string number = std::to_string(from.GetFID());
    const auto problem = [&](const std::string& what, const std::string& value, const std::string& remedy) {
        problems.add(Problem{what, source.where, value, "", remedy});
    };
    const OGRGeometry* geometry = from.GetGeometryRef();
    if (!geometry || geometry->IsEmpty()) {
        warnings.add("empty", worded("{1}: feature {2} has no geometry and was left out", {source.where.text, number}));
        return feature;
    }
    PolygonParts parts = polygon_parts(*geometry);
    if (parts.closed_lines > 0) {
        warnings.add("line",
                     worded("{1}: feature {2} is a closed line, taken as an area", {source.where.text, number}));
    }
    if (parts.unbounded > 0) {
        problem("has a coordinate that is non-finite or too large", "beyond " + shortest_text(k_furthest), "Redraw it");
        return feature;
    }
    if (parts.open_lines > 0) {
        problem("is a line that does not close", "a gap of " + shortest_text(parts.widest_gap) + " CRS units",
                "Close it, or draw it as a polygon");
        return feature;
    }
    if (parts.polygons.empty()) {
        problem(std::string("is not an area but a ") + geometry->getGeometryName(), "", "Give polygons");
        return feature;
    }
    OutlineCheck check = check_outline(std::move(parts.polygons));
    if (check.crossing) {
        problem("crosses itself", *check.crossing,
                "Redraw the outline there, so that inside and outside are unambiguous");
        return feature;
    }
    if (check.hole_outside) {
        problem("has a hole that lies outside its outline", *check.hole_outside,
                "Remove the hole, or draw it as a polygon of its own");
        return feature;
    }
    for (const Sentence& repair : check.repairs)
        warnings.add("repair", worded("{1}: feature {2}: {3}", {source.where.text, number, repair}));
    for (const auto& polygon : check.polygons) {
        if (auto part = from_ogr(*polygon); part && area(*part) > 0) feature.parts.push_back(std::move(*part));
    }
    if (feature.parts.empty()) problem("has no area", "", "Redraw it");
    return feature;
}

bool plausible(const std::string& crs, const Bounds& box) {
    OGRSpatialReference reference;
    if (reference.SetFromUserInput(crs.c_str()) != OGRERR_NONE || !reference.IsGeographic()) return true;
    // Longitudes may run to 360; detects metres labelled as degrees.
    return box.west >= -360 && box.east <= 360 && box.south >= -90.000001 && box.north <= 90.000001;
}

/// An edge longer than half a turn of longitude crosses the antimeridian; unchanged it would enclose the rest of the
/// Earth.
std::optional<std::string> long_way_round(const std::vector<PolygonFeature>& features, double turn) {
    if (turn == 0) return std::nullopt;
    for (const PolygonFeature& feature : features) {
        for (const Polygon& part : feature.parts) {
            for (std::size_t i = 0; i < part.outer.size(); ++i) {
                const Point a = part.outer[i], b = part.outer[(i + 1) % part.outer.size()];
                if (std::abs(a.x - b.x) > turn / 2)
                    return "from " + shortest_text(a.x) + ", " + shortest_text(a.y) + " to " + shortest_text(b.x) +
                           ", " + shortest_text(b.y);
            }
        }
    }
    return std::nullopt;
}

Bounds bounds_of(const std::vector<PolygonFeature>& features) {
    MultiPolygon all;
    for (const PolygonFeature& feature : features) {
        for (const Polygon& part : feature.parts) all.push_back({part.outer, {}});
    }
    return bounds(all);
}

/// The condition that a feature alone satisfies, in the layer's own words.
std::string condition_of(OGRLayer& layer, const OGRFeature& feature) {
    const std::string column = layer.GetFIDColumn();
    return (column.empty() ? "FID" : column) + " = " + std::to_string(feature.GetFID());
}

/// Why a feature is no area, in one line.
std::string reason_of(const Problems& problems) {
    if (problems.list().empty()) return "no geometry";
    const Problem& first = problems.list().front();
    return "the polygon " + first.what + (first.value.empty() ? "" : " (" + first.value + ")");
}

/// Reads features, conditions, what is unusable, and warnings.
void read_features(OGRLayer& layer, const VectorSource& source, bool keep_unusable, TimeLimit& limit,
                   PolygonLayer& read) {
    Problems problems;
    CountedTexts counted;
    std::int64_t n_read = 0, n_areas = 0, unreported = 0;
    VertexCount vertices(source);
    layer.ResetReading();
    for (const auto& from : layer) {
        ++n_read;
        limit.again();
        vertices.add(from->GetGeometryRef());
        Problems of_this;
        PolygonFeature feature = read_feature(*from, source, of_this, counted);
        if (!keep_unusable) {
            for (Problem problem : of_this.list()) {
                problem.what = "feature " + std::to_string(from->GetFID()) + " " + problem.what;
                problems.list().size() < k_most_problems ? problems.add(problem) : void(++unreported);
            }
            if (feature.parts.empty()) continue;
        }
        n_areas += feature.parts.empty() ? 0 : 1;
        read.unusable.push_back(feature.parts.empty() ? reason_of(of_this) : "");
        read.features.push_back(std::move(feature));
        read.conditions.push_back(condition_of(layer, *from));
    }
    if (unreported > 0)
        problems.add(Problem{std::to_string(unreported) + " more features have problems", source.where, "", "", ""});
    problems.throw_if_any();
    read.warnings = counted.texts();
    if (n_read == 0) throw vector_error(source, "the layer is empty", layer.GetName(), "Draw at least one polygon");
    if (n_areas == 0) throw vector_error(source, "the layer contains no polygon", layer.GetName(), "Draw at least one");
}

}  // namespace

PolygonLayer read_polygons(const std::string& path, const std::string& target_crs_wkt, const Place& where,
                           const LayerChoice& choice) {
    const GdalSession session;
    const ReadingOnly reading;
    const VectorSource source = vector_source(path, where);
    TimeLimit limit(source.where);
    const GDALDatasetUniquePtr dataset = open_vector(source);
    OGRLayer& layer = choose_layer(*dataset, source, may_contain_areas, "areas");
    check_attribute_table(*dataset, layer, source);
    if (!choice.filter.empty()) filter_features(layer, source, choice.filter);
    const std::string crs = choice.crs.empty() ? declared_crs(*dataset, layer, source, k_crs_key) : choice.crs;
    if (crs.empty() && !target_crs_wkt.empty()) {
        throw vector_error(source, "the file names no coordinate reference system", "",
                           crs_remedy(source, k_crs_key) + ", or use terrain.crs = local throughout");
    }
    PolygonLayer read;
    read.layer_name = layer.GetName();
    read.crs_wkt = crs;
    read.crs_label = crs.empty() ? "none" : crs_name(crs);
    read_features(layer, source, choice.keep_unusable, limit, read);
    require_sound(session, source);
    const Bounds own = bounds_of(read.features);
    if (!target_crs_wkt.empty() && !plausible(crs, own)) {
        throw vector_error(source, "the coordinates are not degrees though the file's CRS is in degrees",
                           shortest_text(own.west) + ", " + shortest_text(own.south),
                           "It states " + read.crs_label + ". " + crs_remedy(source, k_crs_key));
    }
    if (const auto place = long_way_round(read.features, target_crs_wkt.empty() ? 0 : longitude_turn(crs))) {
        throw vector_error(source, "an edge goes round the Earth the long way", *place,
                           "Split the outline at the antimeridian, or continue its longitudes beyond 180");
    }
    const CrsTransform transform(target_crs_wkt.empty() ? "" : crs, target_crs_wkt, own);
    read.transform = transform.info();
    read.own_bounds = own;
    const double tolerance = is_projected_in_metres(target_crs_wkt) ? k_bend_tolerance : k_bend_tolerance_degrees;
    try {
        for (PolygonFeature& feature : read.features) {
            for (Polygon& part : feature.parts) part = transformed(part, transform, tolerance);
        }
    } catch (const Error& error) {
        throw vector_error(source, error.problems().front().what, error.problems().front().value,
                           error.problems().front().remedy);
    }
    read.bounds = bounds_of(read.features);
    return read;
}

std::set<std::string> filled_layers(const std::string& file, const Place& where) {
    const GdalSession session;
    const VectorSource source = vector_source(file, where);
    const GDALDatasetUniquePtr dataset = open_vector(source, true);
    std::set<std::string> names;
    for (OGRLayer* const layer : dataset->GetLayers())
        if (layer->GetFeatureCount() > 0) names.insert(layer->GetName());
    // OGR reports no error if it cannot read the list of layers.
    if (session.failed() || dataset->GetLayerCount() == 0)
        throw vector_error(source, "cannot be read completely: " + session.last_message(), "", "The file is damaged");
    return names;
}

}  // namespace frana::gis
