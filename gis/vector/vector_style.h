// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

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

}  // namespace frana::gis
