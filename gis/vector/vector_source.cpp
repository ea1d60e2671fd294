// SPDX-License-Identifier: Apache-2.0
#include "gis/vector/vector_source.h"

#include <cpl_conv.h>
#include <cpl_vsi.h>

#include <algorithm>
#include <cctype>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "gis/access/file_access.h"
#include "gis/access/gdal_session.h"
#include "gis/access/table_in.h"
#include "gis/crs/crs.h"
#include "gis/vector/vector_out.h"

namespace frana::gis {
namespace {

std::string layer_names(GDALDataset& dataset) {
    std::string names;
    for (OGRLayer* layer : dataset.GetLayers()) {
        if (std::string(layer->GetName()) == k_style_table) continue;
        names += (names.empty() ? "" : ", ") + std::string(layer->GetName());
    }
    return names;
}

std::string attribute_names(OGRLayer& layer) {
    std::string names;
    const OGRFeatureDefn& fields = *layer.GetLayerDefn();
    for (int i = 0; i < fields.GetFieldCount(); ++i)
        names += (names.empty() ? "" : ", ") + std::string(fields.GetFieldDefn(i)->GetNameRef());
    return names.empty() ? "it has none" : names;
}

/// Curves count as the points that define them.
class PointCounter : public OGRDefaultConstGeometryVisitor {
  public:
    using OGRDefaultConstGeometryVisitor::visit;
    void visit(const OGRPoint*) override { ++count; }
    void visit(const OGRLineString* line) override { count += line->getNumPoints(); }
    void visit(const OGRCircularString* line) override { count += line->getNumPoints(); }
    void visit(const OGRLinearRing* ring) override { count += ring->getNumPoints(); }

    std::int64_t count = 0;
};

/// Whether a condition contains a query of the database, which may never end: SELECT outside quotes.
bool has_query(const std::string& condition) {
    char quote = 0;
    std::string word;
    for (const char c : condition + " ") {
        if (quote != 0) {
            if (c == quote) quote = 0;
            continue;
        }
        if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_') {
            word += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
            continue;
        }
        if (word == "SELECT") return true;
        word.clear();
        if (c == '\'' || c == '"' || c == '`') quote = c;
    }
    return false;
}

Error refused(const VectorSource& source, const AccessProblem& cause) {
    return {ErrorKind::input, Problem{cause.what, source.where, cause.value, "", cause.remedy}};
}

}  // namespace

VectorSource vector_source(const std::string& path, const Place& where) {
    constexpr const char* k_mark = "|layer=";
    const std::string prefix = where.empty() ? "" : where + ": ";
    const std::size_t mark = path.find(k_mark);
    if (mark == std::string::npos) return {path, "", prefix + path};
    return {path.substr(0, mark), path.substr(mark + std::string(k_mark).size()), prefix + path};
}

Error vector_error(const VectorSource& source, const std::string& what, const std::string& value,
                   const std::string& remedy) {
    if (const auto cause = pop_access_problem()) return refused(source, *cause);
    return {ErrorKind::input, Problem{what, source.where, value, "", remedy}};
}

GDALDatasetUniquePtr open_vector(const VectorSource& source, bool is_ours) {
    const GdalSession session;
    (void)pop_access_problem();
    if (const auto remedy = network_remedy(source.file))
        throw vector_error(source, "the file is read over the network", "", *remedy);
    GDALDatasetUniquePtr dataset(
        GDALDataset::Open(source.file.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR));
    if (dataset && is_ours && session.failed())
        throw vector_error(source, "the file is damaged: " + session.last_message(), "", "");
    if (dataset && !is_ours && std::string(dataset->GetDriverName()) == "CSV")
        refuse_surplus_fields(source.file, source.where);
    if (dataset) return dataset;
    VSIStatBufL status;
    if (VSIStatL(source.file.c_str(), &status) != 0) {
        throw vector_error(
            source, "the file does not exist", "",
            "Check the path: a scene's is relative to the scene file, an option's to the current folder");
    }
    throw vector_error(source, "the file is not a vector file that can be read: " + session.last_message(), "",
                       "Give a shapefile (with its .shx and .dbf), GeoPackage, GeoJSON or another file that OGR reads");
}

void require_sound(const GdalSession& session, const VectorSource& source, const std::string& remedy) {
    if (const auto cause = pop_access_problem()) throw refused(source, *cause);
    if (session.failed()) throw vector_error(source, "the file is damaged: " + session.last_message(), "", remedy);
}

void VertexCount::add(const OGRGeometry* geometry) {
    constexpr std::int64_t k_most_features = 1'000'000, k_most_vertices = 20'000'000;
    if (++features_ > k_most_features)
        throw vector_error(source_, "the layer has too many features", "more than " + std::to_string(k_most_features),
                           "Cut it to the slope");
    if (geometry == nullptr) return;
    PointCounter counter;
    geometry->accept(&counter);
    vertices_ += counter.count;
    if (vertices_ > k_most_vertices)
        throw vector_error(source_, "the layer has too many vertices", "more than " + std::to_string(k_most_vertices),
                           "Simplify it, or cut it to the slope");
}

OGRLayer& choose_layer(GDALDataset& dataset, const VectorSource& source, const LayerTest& suits,
                       const std::string& wanted) {
    if (!source.layer.empty()) {
        if (OGRLayer* layer = dataset.GetLayerByName(source.layer.c_str())) return *layer;
        throw vector_error(source, "the file has no such layer", source.layer, "Its layers: " + layer_names(dataset));
    }
    OGRLayer* found = nullptr;
    for (OGRLayer* layer : dataset.GetLayers()) {
        if (!suits(*layer)) continue;
        if (found) {
            throw vector_error(source, "the file contains several layers", layer_names(dataset),
                               "Name one: \"" + source.file + "|layer=" + found->GetName() + "\"");
        }
        found = layer;
    }
    if (!found)
        throw vector_error(source, "the file contains no layer with " + wanted, layer_names(dataset), "Give " + wanted);
    return *found;
}

void check_attribute_table(GDALDataset& dataset, OGRLayer& layer, const VectorSource& source) {
    if (std::string(dataset.GetDriverName()) != "ESRI Shapefile" || layer.GetLayerDefn()->GetFieldCount() > 0) return;
    const std::string table = CPLResetExtension(source.file.c_str(), "dbf");
    VSIStatBufL status;
    if (VSIStatL(table.c_str(), &status) == 0)
        throw vector_error(source, "the attribute table is damaged", table,
                           "Export the shapefile again, or remove the .dbf");
}

void filter_features(OGRLayer& layer, const VectorSource& source, const std::string& condition) {
    const GdalSession session;
    if (has_query(condition)) {
        throw vector_error(source, "the filter contains a query", condition,
                           "Give a condition on the attributes: " + attribute_names(layer));
    }
    // Some drivers detect a problem only when the first feature is requested.
    if (layer.SetAttributeFilter(condition.c_str()) == OGRERR_NONE) {
        const OGRFeatureUniquePtr first(layer.GetNextFeature());
        if (first) return;
    }
    if (session.failed()) {
        throw vector_error(source, "the filter is not understood: " + session.last_message(), condition,
                           "A condition as in SQL on its attributes: " + attribute_names(layer));
    }
    throw vector_error(source, "no feature satisfies the filter", condition,
                       "Its attributes: " + attribute_names(layer));
}

namespace {

/// Returns the value of the "crs" that comes before the features and attributes of a GeoJSON file; empty: there is
/// none.
std::string crs_member(const std::string& path) {
    constexpr std::size_t k_head = 65536;
    const std::unique_ptr<VSILFILE, int (*)(VSILFILE*)> file(VSIFOpenL(path.c_str(), "rb"), &VSIFCloseL);
    std::string head(k_head, ' ');
    head.resize(file ? VSIFReadL(head.data(), 1, head.size(), file.get()) : 0);
    const std::size_t key = head.find("\"crs\"");
    for (const char* after : {"\"features\"", "\"properties\"", "\"geometry\""})
        if (head.find(after) < key) return {};
    const std::size_t from = key == std::string::npos ? key : head.find_first_not_of(" \t\r\n:", key + 5);
    if (from == std::string::npos) return {};
    std::size_t to = from;
    for (int depth = 0; to < head.size() && (depth > 0 || (head[to] != ',' && head[to] != '}')); ++to)
        depth += (head[to] == '{' ? 1 : 0) - (head[to] == '}' ? 1 : 0);
    const std::size_t last = head.find_last_not_of(" \t\r\n", to - 1);
    return head.substr(from, last + 1 - from);
}

/// Returns the CRS name that the member contains; none if its kind is unknown.
std::optional<std::string> name_in(const std::string& member) {
    const auto json = nlohmann::json::parse(member, nullptr, false);
    const auto at = [&](const char* pointer) -> std::optional<std::string> {
        const nlohmann::json::json_pointer place(pointer);
        if (!json.contains(place)) return std::nullopt;
        return json[place].is_string() ? json[place].get<std::string>() : json[place].dump();
    };
    const auto of = [&](const char* key) { return at((std::string("/properties/") + key).c_str()); };
    const std::string type = at("/type").value_or("");
    if (EQUAL(type.c_str(), "name")) return of("name");
    if (EQUAL(type.c_str(), "OGC")) return of("urn");
    if (EQUAL(type.c_str(), "EPSG")) {
        const auto code = of("code");
        return code ? std::optional<std::string>("EPSG:" + *code) : std::nullopt;
    }
    return std::nullopt;
}

bool is_link(const std::string& member) {
    return member.find("\"link\"") != std::string::npos || member.find("\"URL\"") != std::string::npos;
}

/// Whether a name is known and, if it is not at the top, whether it is that of the layer.
bool is_understood(const std::string& name, const OGRSpatialReference* layers, bool at_top) {
    const GdalSession session;
    OGRSpatialReference crs;
    const char* const access[] = {"ALLOW_NETWORK_ACCESS=NO", "ALLOW_FILE_ACCESS=NO", nullptr};
    if (name.empty() || crs.SetFromUserInput(name.c_str(), access) != OGRERR_NONE) return false;
    const char* const alike[] = {"CRITERION=EQUIVALENT_EXCEPT_AXIS_ORDER_GEOGCRS",
                                 "IGNORE_DATA_AXIS_TO_SRS_AXIS_MAPPING=YES", nullptr};
    return at_top || (layers != nullptr && crs.IsSame(layers, alike) != 0);
}

}  // namespace

std::string declared_crs(GDALDataset& dataset, OGRLayer& layer, const VectorSource& source, const std::string& key) {
    const OGRSpatialReference* const crs = layer.GetSpatialRef();
    const std::string driver = dataset.GetDriverName();
    const bool at_top = driver == "GeoJSON";  // OGR reads none of a sequence's
    const std::string member = at_top || driver == "GeoJSONSeq" ? crs_member(source.file) : "";
    if (member.empty() || (at_top && is_link(member))) return layer_crs(crs);  // GDAL follows a link, or it was refused
    if (member == "null") return {};                                           // GeoJSON's value for "unknown"
    const auto name = name_in(member);
    if (!name || !is_understood(*name, crs, at_top))
        throw vector_error(source, "the file's coordinate reference system is unknown", name.value_or(member),
                           crs_remedy(source, key));
    return layer_crs(crs);
}

std::string crs_remedy(const VectorSource& source, const std::string& key) {
    const std::string ending = source.file.substr(source.file.find_last_of('.') + 1);
    const bool is_shapefile = EQUAL(ending.c_str(), "shp") || EQUAL(ending.c_str(), "shz");
    return (is_shapefile ? "Correct or add its .prj file" : "Write the file again with the right one") +
           std::string(" (ogr2ogr -a_srs EPSG:...)") +
           (key.empty() ? "" : ", or state it in the scene (" + key + " = EPSG:...)");
}

}  // namespace frana::gis
