// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/colour.h"

namespace frana::gis {

/// A style as QGIS (QML) and OGC programs (SLD) read it; empty: none.
struct StyleText {
    std::string qml, sld;
};

/// How a layer of outlines, lines or points is drawn: areas are not filled, so that rasters below remain visible.
struct VectorLook {
    Rgb colour{40, 40, 40};
    double width_mm = 0.5;  ///< of lines; diameter of points
    bool dashed = false;
    std::string label{};  ///< attribute written beside each feature; empty: none
};

enum class Shape { area, line, point };

/// @param name of the layer, in the SLD
StyleText style_of(const std::string& name, Shape shape, const VectorLook& look);

/// Returns the QML document round a renderer, so that all styles have the same head.
std::string qml_document(const std::string& content, bool has_labels = false);
/// The same for a named layer of SLD rules.
std::string sld_document(const std::string& name, const std::string& title, const std::string& rules);

/// The look of the features with one value of a number attribute.
struct ValueLook {
    double value = 0;  ///< NaN: of all other features, last
    std::string label;
    VectorLook look;
};

/// Returns a style that tells features apart by an attribute.
StyleText style_of(const std::string& name, Shape shape, const std::string& attribute,
                   const std::vector<ValueLook>& looks);

/// An attribute and what a GIS shows instead of its name.
using AttributeTitles = std::vector<std::pair<std::string, std::string>>;

/// Returns the style of a vector layer (style_of, polygon_style) with a title in the SLD and titles of the attributes
/// in the QML, which may name attributes that the layer does not have.
StyleText titled(StyleText style, const std::string& title, const AttributeTitles& attributes);

}  // namespace frana::gis
