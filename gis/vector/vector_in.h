// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "core/error.h"
#include "core/geometry.h"
#include "core/words/sentence.h"
#include "gis/crs/crs_transform.h"

namespace frana::gis {

struct PolygonLayer {
    std::vector<PolygonFeature> features;  ///< in the target CRS
    std::vector<std::string> conditions;   ///< for each feature the SQL condition that it alone satisfies: "fid = 3"
    std::vector<std::string> unusable;     ///< for each feature why it has no parts; empty: it has some
    std::string crs_wkt;                   ///< of the file; empty: none
    std::string crs_label;                 ///< of the file, for messages
    std::string layer_name;
    TransformInfo transform;
    Bounds bounds;      ///< in the target CRS
    Bounds own_bounds;  ///< in the file's
    std::vector<Sentence> warnings;
};

/// Options for reading a vector file; an empty text leaves the choice to the file.
struct LayerChoice {
    std::string filter;  ///< SQL condition on the attributes ("kind = 'release'")
    std::string crs;     ///< WKT, replaces that of the file
    bool keep_unusable =
        false;  ///< features that are no area stay in their place, without parts; else they are refused

    [[nodiscard]] auto members() const { return std::tie(filter, crs, keep_unusable); }
};

/// Returns every polygon of a vector layer in the target CRS (empty: coordinates unchanged). `path` may name a layer:
/// "file.gpkg|layer=release". Curves become straight segments, heights are dropped, closed lines count as polygons,
/// long edges are curved as by the projection (to 1 mm). An outline that touches itself is repaired with a warning; one
/// that crosses itself is refused with the place. `where` names the key. Throws Error(input) with every feature's
/// problem: missing file, no CRS, empty layer, no polygon, crossing (unless choice.keep_unusable).
PolygonLayer read_polygons(const std::string& path, const std::string& target_crs_wkt, const Place& where,
                           const LayerChoice& choice = {});

/// Returns the names of the layers of a result's vector file that have a feature. Throws Error(input) if the file
/// cannot be read completely.
std::set<std::string> filled_layers(const std::string& file, const Place& where);

}  // namespace frana::gis
