// SPDX-License-Identifier: Apache-2.0
#include "gis/vector/vector_source.h"

#include <cpl_conv.h>
#include <cpl_vsi.h>

#include <cctype>

#include "gis/access/access_problem.h"
#include "gis/access/gdal_session.h"
#include "gis/access/network.h"
#include "gis/vector/geopackage.h"

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

VectorSource vector_source(const std::string& path, const std::string& where) {
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

}  // namespace frana::gis
