// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/geometry.h"
#include "gis/crs/crs_transform.h"

namespace frana::gis {

/// One line of a vector layer with its text attributes.
struct LineInput {
    Polyline line;
    std::map<std::string, std::string> texts;
};

struct LineInputLayer {
    std::vector<LineInput> features;  ///< in the target CRS
    std::string crs_wkt;              ///< of the file; empty: none
    std::string crs_label;            ///< of the file, for messages
    Bounds own_bounds;                ///< in the file's CRS
    TransformInfo transform;
};

/// Returns every line of a vector layer in the target CRS (empty: coordinates unchanged); "FILE|layer=NAME" selects one
/// of several layers. A line of several parts that join end to end is one line; curves become straight segments,
/// heights are dropped. `where` names the key. Throws Error(input): missing file, no CRS, no lines, parts that do not
/// join.
LineInputLayer read_lines(const std::string& path, const std::string& target_crs_wkt, const std::string& where);

}  // namespace frana::gis
