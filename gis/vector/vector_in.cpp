// SPDX-License-Identifier: Apache-2.0
#include "gis/vector/vector_in.h"

#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

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

Polyline line_of(const OGRLineString& from) {
    Polyline line;
    for (const OGRPoint& point : from) line.push_back({point.getX(), point.getY()});
    return line;
}

void add_parts(const OGRGeometry& geometry, MixedShape& shape) {
    switch (wkbFlatten(geometry.getGeometryType())) {
        case wkbPoint: {
            const OGRPoint& point = *geometry.toPoint();
            if (!point.IsEmpty()) shape.points.push_back({point.getX(), point.getY()});
            return;
        }
        case wkbLineString:
            if (Polyline line = line_of(*geometry.toLineString()); !line.empty())
                shape.lines.push_back(std::move(line));
            return;
        case wkbPolygon:
        case wkbTriangle:
            if (auto polygon = from_ogr(*geometry.toPolygon())) shape.areas.push_back(std::move(*polygon));
            return;
        case wkbMultiPoint:
        case wkbMultiLineString:
        case wkbMultiPolygon:
        case wkbGeometryCollection:
            for (const OGRGeometry* part : *geometry.toGeometryCollection()) add_parts(*part, shape);
            return;
        case wkbPolyhedralSurface:
        case wkbTIN:
            for (const OGRPolygon* part : *geometry.toPolyhedralSurface()) add_parts(*part, shape);
            return;
        default:
            return;
    }
}

MixedShape shape_of(const OGRFeature& feature) {
    MixedShape shape;
    if (const OGRGeometry* const geometry = feature.GetGeometryRef())
        add_parts(*std::unique_ptr<OGRGeometry>(geometry->getLinearGeometry()), shape);
    return shape;
}

/// The line of a feature; parts that join are merged.
Polyline one_line_of(const OGRFeature& feature, const VectorSource& source) {
    const std::string name = "feature " + std::to_string(feature.GetFID());
    const OGRGeometry* geometry = feature.GetGeometryRef();
    if (!geometry || geometry->IsEmpty()) throw vector_error(source, name + " has no geometry", "", "Draw a line");
    std::unique_ptr<OGRGeometry> straight(geometry->getLinearGeometry());
    if (wkbFlatten(straight->getGeometryType()) == wkbMultiLineString)
        straight.reset(OGRGeometryFactory::forceToLineString(straight.release()));
    if (wkbFlatten(straight->getGeometryType()) != wkbLineString) {
        const bool parts = wkbFlatten(straight->getGeometryType()) == wkbMultiLineString;
        throw vector_error(source, name + (parts ? " has parts that do not join" : " is not a line"),
                           straight->getGeometryName(), "Draw one line per inflow");
    }
    return line_of(*straight->toLineString());
}

/// @param with_nulls whether a column without a value is NaN or an empty text; else it is left out
void read_attributes(const OGRFeature& from, bool with_nulls, Feature& feature) {
    const OGRFeatureDefn& fields = *from.GetDefnRef();
    for (int i = 0; i < fields.GetFieldCount(); ++i) {
        const bool is_given = from.IsFieldSetAndNotNull(i);
        if (!is_given && !with_nulls) continue;
        const OGRFieldDefn& field = *fields.GetFieldDefn(i);
        const OGRFieldType type = field.GetType();
        if (type == OFTInteger || type == OFTInteger64 || type == OFTReal)
            feature.numbers[field.GetNameRef()] = is_given ? from.GetFieldAsDouble(i) : std::nan("");
        else
            feature.texts[field.GetNameRef()] = is_given ? from.GetFieldAsString(i) : "";
    }
}

/// The place of a column; -1: none is asked for.
int column_of(OGRLayer& layer, const VectorSource& source, const std::string& column) {
    if (column.empty()) return -1;
    OGRFeatureDefn& fields = *layer.GetLayerDefn();
    const int index = fields.GetFieldIndex(column.c_str());
    if (index >= 0) return index;
    std::string names;
    for (int i = 0; i < fields.GetFieldCount(); ++i)
        names += (names.empty() ? "" : ", ") + std::string(fields.GetFieldDefn(i)->GetNameRef());
    throw vector_error(source, "the layer has no such column", column,
                       names.empty() ? "It has no attributes" : "Its columns are " + names);
}

std::optional<double> count_of(const OGRFeature& feature, int column, const VectorSource& source) {
    if (column < 0 || !feature.IsFieldSetAndNotNull(column)) return std::nullopt;
    const std::string text = feature.GetFieldAsString(column);
    char* end = nullptr;
    const double count = CPLStrtod(text.c_str(), &end);
    if (end == text.c_str() || *end != '\0' || !(count >= 0) || !std::isfinite(count))
        throw vector_error(source, "feature " + std::to_string(feature.GetFID()) + " has a count that is no number",
                           text, "Give numbers from 0, or another output.exposure-count");
    return count;
}

void require_crs(const VectorFile& file, const std::string& target, const VectorSource& source,
                 const std::string& key = {}) {
    if (file.crs_wkt.empty() && !target.empty())
        throw vector_error(source, "the file names no coordinate reference system", "",
                           crs_remedy(source, key) + ", or use terrain.crs = local throughout");
}

/// Reads the layers that choose(dataset) returns: calls take(feature) for each of their features.
template <class Choose, class Take>
void read_layers(const VectorSource& source, const std::string& target, VectorFile& file, const Choose& choose,
                 const Take& take) {
    const GdalSession session;
    const ReadingOnly reading;
    TimeLimit limit(source.where);
    const GDALDatasetUniquePtr dataset = open_vector(source);
    VertexCount vertices(source);
    for (OGRLayer* const layer : choose(*dataset)) {
        file.layer_name = layer->GetName();
        if (file.crs_wkt.empty()) file.crs_wkt = declared_crs(*dataset, *layer, source);
        layer->ResetReading();
        for (const auto& feature : *layer) {
            limit.again();
            vertices.add(feature->GetGeometryRef());
            take(*feature);
        }
    }
    require_sound(session, source);
    file.crs_label = file.crs_wkt.empty() ? "none" : crs_name(file.crs_wkt);
    require_crs(file, target, source);
}

/// Brings everything to the target CRS: each(visit) calls visit for every place, transform_all transforms them.
template <class Each, class TransformAll>
void transform_places(const VectorSource& source, const std::string& target, VectorFile& file, const Each& each,
                      const TransformAll& transform_all) {
    Bounds box{HUGE_VAL, HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
    each([&](const Point& p) {
        box = {std::min(box.west, p.x), std::min(box.south, p.y), std::max(box.east, p.x), std::max(box.north, p.y)};
    });
    if (box.west > box.east) return;
    file.own_bounds = box;
    try {
        const CrsTransform transform(target.empty() ? "" : file.crs_wkt, target, box);
        file.transform = transform.info();
        if (!transform.is_identity()) transform_all(transform);
    } catch (const Error& error) {
        const Problem& first = error.problems().front();
        throw vector_error(source, first.what, first.value, first.remedy);
    }
}

template <class Visit>
void for_each_place(MixedShape& shape, const Visit& visit) {
    for (Point& point : shape.points) visit(point);
    for (Polyline& line : shape.lines)
        for (Point& point : line) visit(point);
    for (Polygon& area : shape.areas) {
        for (Point& point : area.outer) visit(point);
        for (Ring& hole : area.holes)
            for (Point& point : hole) visit(point);
    }
}

void transform_features(const VectorSource& source, const std::string& target, FeatureLayer& layer) {
    transform_places(
        source, target, layer,
        [&](const auto& visit) {
            for (Feature& feature : layer.features) for_each_place(feature.shape, visit);
        },
        [&](const CrsTransform& transform) {
            const double tolerance = is_projected_in_metres(target) ? k_bend_tolerance : k_bend_tolerance_degrees;
            for (Feature& feature : layer.features) {
                for (Point& point : feature.shape.points) point = transform(point);
                for (Polyline& line : feature.shape.lines)
                    for (Point& point : line) point = transform(point);
                for (Polygon& area : feature.shape.areas) area = transformed(area, transform, tolerance);
            }
        });
}

}  // namespace

FeatureLayer read_features(const std::string& path, const std::string& target, const Place& where,
                           const std::string& name_column, const std::string& count_column) {
    const VectorSource source = vector_source(path, where);
    FeatureLayer layer;
    int name = -1, count = -1;
    const auto choose = [&](GDALDataset& dataset) {
        OGRLayer& from = choose_layer(
            dataset, source, [](OGRLayer& one) { return one.GetGeomType() != wkbNone; }, "points, lines or areas");
        check_attribute_table(dataset, from, source);
        name = column_of(from, source, name_column);
        count = column_of(from, source, count_column);
        return std::vector<OGRLayer*>{&from};
    };
    read_layers(source, target, layer, choose, [&](const OGRFeature& from) {
        Feature& feature = layer.features.emplace_back();
        feature.fid = from.GetFID();
        feature.shape = shape_of(from);
        feature.name =
            name >= 0 && from.IsFieldSetAndNotNull(name) ? from.GetFieldAsString(name) : std::to_string(from.GetFID());
        feature.count = count_of(from, count, source);
        read_attributes(from, true, feature);
    });
    if (layer.features.empty()) throw vector_error(source, "the layer is empty", layer.layer_name, "Draw a feature");
    transform_features(source, target, layer);
    return layer;
}

FeatureLayer read_lines(const std::string& path, const std::string& target, const Place& where) {
    const VectorSource source = vector_source(path, where);
    FeatureLayer layer;
    const auto choose = [&](GDALDataset& dataset) {
        return std::vector<OGRLayer*>{&choose_layer(
            dataset, source, [](OGRLayer&) { return true; }, "lines")};
    };
    read_layers(source, target, layer, choose, [&](const OGRFeature& from) {
        Feature& feature = layer.features.emplace_back();
        feature.fid = from.GetFID();
        feature.shape.lines.push_back(one_line_of(from, source));
        read_attributes(from, true, feature);
    });
    if (layer.features.empty()) throw vector_error(source, "the layer is empty", layer.layer_name, "Draw a line");
    transform_features(source, target, layer);
    return layer;
}

ValuedPoints read_valued_points(const std::string& path, const std::vector<std::string>& names, const Place& where) {
    const VectorSource source = vector_source(path, where);
    VectorFile file;
    ValuedPoints points;
    points.columns.resize(names.size());
    std::vector<int> fields;
    const auto choose = [&](GDALDataset& dataset) {
        OGRLayer& layer = choose_layer(
            dataset, source, [](OGRLayer& one) { return wkbFlatten(one.GetGeomType()) == wkbPoint; }, "points");
        for (const std::string& name : names) fields.push_back(column_of(layer, source, name));
        return std::vector<OGRLayer*>{&layer};
    };
    read_layers(source, "", file, choose, [&](const OGRFeature& feature) {
        const OGRGeometry* geometry = feature.GetGeometryRef();
        if (geometry == nullptr || geometry->IsEmpty()) return;
        const OGRPoint& point = *geometry->toPoint();
        points.places.push_back({point.getX(), point.getY()});
        for (std::size_t k = 0; k < fields.size(); ++k)
            points.columns[k].push_back(feature.GetFieldAsDouble(fields[k]));
    });
    return points;
}

namespace {

std::string name_of(const OGRFeature& feature, std::size_t before) {
    for (const char* field : {"name", "NAME", "Name", "id"}) {
        const int index = feature.GetFieldIndex(field);
        if (index >= 0 && feature.IsFieldSetAndNotNull(index))
            if (std::string name = feature.GetFieldAsString(index); !name.empty()) return name;
    }
    return std::to_string(before + 1);
}

}  // namespace

Marks read_marks(const std::string& path, const std::string& target, const Place& where) {
    const VectorSource source = vector_source(path, where);
    Marks marks;
    const auto choose = [&](GDALDataset& dataset) {
        std::vector<OGRLayer*> layers;
        for (OGRLayer* const layer : dataset.GetLayers())
            if (source.layer.empty() || source.layer == layer->GetName()) layers.push_back(layer);
        if (layers.empty() && !source.layer.empty())
            throw vector_error(source, "the file has no such layer", source.layer, "Name one of its layers");
        return layers;
    };
    read_layers(source, target, marks, choose, [&](const OGRFeature& feature) {
        const MixedShape shape = shape_of(feature);
        for (const Point& place : shape.points) marks.points.push_back({name_of(feature, marks.points.size()), place});
        for (const Polyline& line : shape.lines)
            if (line.size() >= 2) marks.lines.push_back({name_of(feature, marks.lines.size()), line});
        marks.polygons += shape.areas.empty() ? 0 : 1;
    });
    if (marks.points.empty() && marks.lines.empty() && marks.polygons == 0)
        throw vector_error(source, "the file contains no point and no line", "", "Draw at least one");
    const auto each = [&](const auto& visit) {
        for (NamedPoint& point : marks.points) visit(point.place);
        for (NamedLine& line : marks.lines)
            for (Point& place : line.line) visit(place);
    };
    transform_places(source, target, marks, each,
                     [&](const CrsTransform& transform) { each([&](Point& p) { p = transform(p); }); });
    return marks;
}

namespace {

constexpr const char* k_crs_key = "perimeter-crs";

constexpr std::size_t k_most_problems = 10;  // a layer of lines would have one per feature

/// Whether a layer can have areas: closed lines count, points do not.
bool may_contain_areas(OGRLayer& layer) {
    const OGRwkbGeometryType type = wkbFlatten(layer.GetGeomType());
    return type != wkbNone && type != wkbPoint && type != wkbMultiPoint;
}

/// Returns one feature in its own CRS; adds to `problems` why it cannot be used ("crosses itself").
Feature read_area(const OGRFeature& from, const VectorSource& source, Problems& problems, CountedTexts& warnings) {
    Feature feature;
    read_attributes(from, false, feature);
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
        if (auto part = from_ogr(*polygon); part && area(*part) > 0) feature.shape.areas.push_back(std::move(*part));
    }
    if (feature.shape.areas.empty()) problem("has no area", "", "Redraw it");
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
std::optional<std::string> long_way_round(const std::vector<Feature>& features, double turn) {
    if (turn == 0) return std::nullopt;
    for (const Feature& feature : features) {
        for (const Polygon& part : feature.shape.areas) {
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

/// Bounds of the outer rings.
Bounds bounds_of(const std::vector<Feature>& features) {
    MultiPolygon all;
    for (const Feature& feature : features)
        for (const Polygon& part : feature.shape.areas) all.push_back({part.outer, {}});
    return bounds(all);
}

/// What reading areas counts.
struct AreaCounts {
    Problems problems;
    CountedTexts warnings;
    std::int64_t read = 0, areas = 0, unreported = 0;
};

/// Adds a feature, its condition and what is unusable of it.
void add_area(OGRLayer& layer, const OGRFeature& from, const VectorSource& source, bool keep_unusable,
              AreaCounts& counts, PolygonLayer& to) {
    ++counts.read;
    Problems of_this;
    Feature feature = read_area(from, source, of_this, counts.warnings);
    const bool is_unusable = feature.shape.areas.empty();
    if (!keep_unusable) {
        for (Problem problem : of_this.list()) {
            problem.what = "feature " + std::to_string(from.GetFID()) + " " + problem.what;
            counts.problems.list().size() < k_most_problems ? counts.problems.add(problem) : void(++counts.unreported);
        }
        if (is_unusable) return;
    }
    counts.areas += is_unusable ? 0 : 1;
    to.unusable.push_back(is_unusable ? reason_of(of_this) : "");
    to.features.push_back(std::move(feature));
    to.conditions.push_back(condition_of(layer, from));
}

/// Throws Error(input) if the coordinates cannot be those of the CRS.
void require_plausible(const PolygonLayer& read, const VectorSource& source) {
    const Bounds own = bounds_of(read.features);
    if (!plausible(read.crs_wkt, own))
        throw vector_error(source, "the coordinates are not degrees though the file's CRS is in degrees",
                           shortest_text(own.west) + ", " + shortest_text(own.south),
                           "It states " + read.crs_label + ". " + crs_remedy(source, k_crs_key));
    if (const auto place = long_way_round(read.features, longitude_turn(read.crs_wkt)))
        throw vector_error(source, "an edge goes round the Earth the long way", *place,
                           "Split the outline at the antimeridian, or continue its longitudes beyond 180");
}

}  // namespace

PolygonLayer read_polygons(const std::string& path, const std::string& target, const Place& where,
                           const LayerChoice& choice) {
    const VectorSource source = vector_source(path, where);
    PolygonLayer read;
    AreaCounts counts;
    OGRLayer* layer = nullptr;
    const auto choose = [&](GDALDataset& dataset) {
        layer = &choose_layer(dataset, source, may_contain_areas, "areas");
        check_attribute_table(dataset, *layer, source);
        if (!choice.filter.empty()) filter_features(*layer, source, choice.filter);
        read.crs_wkt = choice.crs.empty() ? declared_crs(dataset, *layer, source, k_crs_key) : choice.crs;
        require_crs(read, target, source, k_crs_key);
        return std::vector<OGRLayer*>{layer};
    };
    read_layers(source, target, read, choose,
                [&](const OGRFeature& from) { add_area(*layer, from, source, choice.keep_unusable, counts, read); });
    if (counts.unreported > 0)
        counts.problems.add(
            Problem{std::to_string(counts.unreported) + " more features have problems", source.where, "", "", ""});
    counts.problems.throw_if_any();
    read.warnings = counts.warnings.texts();
    if (counts.areas == 0)
        throw vector_error(source, counts.read == 0 ? "the layer is empty" : "the layer contains no polygon",
                           read.layer_name, "Draw at least one polygon");
    if (!target.empty()) require_plausible(read, source);
    transform_features(source, target, read);
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
