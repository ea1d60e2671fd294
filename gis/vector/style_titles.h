// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "gis/vector/vector_style.h"

namespace frana::gis {

/// An attribute and what a GIS shows instead of its name.
using AttributeTitles = std::vector<std::pair<std::string, std::string>>;

/// Returns the style of a vector layer (style_of, polygon_style) with a title in the SLD and titles of the attributes
/// in the QML, which may name attributes that the layer does not have.
StyleText titled(StyleText style, const std::string& title, const AttributeTitles& attributes);

}  // namespace frana::gis
