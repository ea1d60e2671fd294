// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ogrsf_frmts.h>

#include <functional>
#include <string>

#include "core/error.h"
#include "gis/access/gdal_session.h"
#include "gis/access/local_files.h"

namespace frana::gis {

/// A vector file, of which a layer may be named: "file.gpkg|layer=release".
struct VectorSource {
    std::string file;
    std::string layer;  ///< empty: the only one that suits
    std::string where;  ///< key and path, for messages
};

VectorSource vector_source(const std::string& path, const std::string& where);

/// What is wrong with a source, as Error(input); a refusal while it was read is the cause and stands before.
Error vector_error(const VectorSource& source, const std::string& what, const std::string& value,
                   const std::string& remedy);

/// Throws Error(input): missing, or nothing that OGR reads; of a file that frana wrote also what OGR opens in
/// part.
GDALDatasetUniquePtr open_vector(const VectorSource& source, bool is_ours = false);

/// Throws Error(input) where reading its features met a problem or a refusal.
void require_sound(const GdalSession& session, const VectorSource& source,
                   const std::string& remedy = "Export it again");

/// Counts what a layer holds. Views and archives can hold without end: beyond what any map needs, Error(input).
class VertexCount {
  public:
    explicit VertexCount(const VectorSource& source) : source_(source) {}
    /// One more feature; `geometry` may be none.
    void add(const OGRGeometry* geometry);

  private:
    const VectorSource& source_;
    std::int64_t features_ = 0, vertices_ = 0;
};

using LayerTest = std::function<bool(OGRLayer&)>;

/// The layer that the source names, or the only one that suits; `wanted` says of what ("areas"). Throws
/// Error(input) with the names there are.
OGRLayer& choose_layer(GDALDataset& dataset, const VectorSource& source, const LayerTest& suits,
                       const std::string& wanted);

/// GDAL reads a shapefile with a damaged .dbf as one without attributes: Error(input) instead.
void check_attribute_table(GDALDataset& dataset, OGRLayer& layer, const VectorSource& source);

/// Keeps the features that satisfy an SQL condition on the attributes. Throws Error(input): not understood,
/// or none.
void filter_features(OGRLayer& layer, const VectorSource& source, const std::string& condition);

}  // namespace frana::gis
