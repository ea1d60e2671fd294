// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ogrsf_frmts.h>

#include <functional>
#include <string>

#include "core/error.h"
#include "gis/access/file_access.h"
#include "gis/access/gdal_session.h"

namespace frana::gis {

/// A vector file, optionally with a layer: "file.gpkg|layer=release".
struct VectorSource {
    std::string file;
    std::string layer;  ///< empty: the only suitable one
    Place where;        ///< key and path, for messages
};

VectorSource vector_source(const std::string& path, const Place& where);

/// Returns the problem of a source as Error(input); an access refused while it was read is the cause and is reported
/// instead.
Error vector_error(const VectorSource& source, const std::string& what, const std::string& value,
                   const std::string& remedy);

/// Throws Error(input): missing, or nothing that OGR reads; for a file written by frana also if OGR reads only part of
/// it.
GDALDatasetUniquePtr open_vector(const VectorSource& source, bool is_ours = false);

/// Throws Error(input) if reading its features caused a problem or a refused access.
void require_sound(const GdalSession& session, const VectorSource& source,
                   const std::string& remedy = "Export it again");

/// Counts the features and vertices of a layer. Views and archives can be unbounded: beyond what any map needs,
/// Error(input).
class VertexCount {
  public:
    explicit VertexCount(const VectorSource& source) : source_(source) {}
    /// Counts one more feature; `geometry` may be null.
    void add(const OGRGeometry* geometry);

  private:
    const VectorSource& source_;
    std::int64_t features_ = 0, vertices_ = 0;
};

using LayerTest = std::function<bool(OGRLayer&)>;

/// Returns the layer that the source names, or the only suitable one; `wanted` describes it ("areas"). Throws
/// Error(input) with the names of the layers.
OGRLayer& choose_layer(GDALDataset& dataset, const VectorSource& source, const LayerTest& suits,
                       const std::string& wanted);

/// GDAL reads a shapefile with a damaged .dbf as one without attributes: Error(input) instead.
void check_attribute_table(GDALDataset& dataset, OGRLayer& layer, const VectorSource& source);

/// Keeps the features that satisfy an SQL condition on the attributes. Throws Error(input) if it is invalid or no
/// feature satisfies it.
void filter_features(OGRLayer& layer, const VectorSource& source, const std::string& condition);

/// Returns the WKT2:2019 of a layer's CRS as declared by the file; "" if it declares none. GDAL interprets a GeoJSON
/// with a "crs" that it does not understand as degrees of WGS 84: Error(input) instead, with the name, where it comes
/// before the features.
/// @param key of the scene that overrides the file's CRS; empty: there is none
std::string declared_crs(GDALDataset& dataset, OGRLayer& layer, const VectorSource& source,
                         const std::string& key = {});

/// Returns the remedy for a file whose CRS is missing or wrong.
std::string crs_remedy(const VectorSource& source, const std::string& key = {});

}  // namespace frana::gis
