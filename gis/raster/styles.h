// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/colour.h"
#include "core/words/words.h"
#include "gis/vector/vector_style.h"

namespace frana::gis {

/// One entry of a raster's colour scale. In a classed style `value` is the class's upper bound (for
/// whole-number classes: the class itself).
struct ColourStop {
    double value = 0;
    Rgb colour;
    std::string label;
    bool transparent = false;
    bool hatched = false;  ///< of polygons: lines of the colour with white between
};

enum class StyleKind {
    ramp,     ///< colours interpolated linearly between stops
    classed,  ///< one colour up to each stop's value
    exact,    ///< one colour for each stop's exact value
};

/// Returns classes bounds[0]..bounds[1], bounds[1]..bounds[2], ... in colours spread evenly over the palette, the first
/// class at its start and the last at its end, as on the maps. `bounds` as from nice_classes; the last may
/// be infinite.
/// @param words of the numbers in the labels
/// @param zero_is_blank a first, transparent class up to bounds[0]
std::vector<ColourStop> class_stops(const Palette& palette, const std::vector<double>& bounds, const std::string& unit,
                                    const Words& words = {}, bool zero_is_blank = false);

/// Writes NAME.qml (QGIS) and NAME.sld (OGC) beside NAME.tif; cells without data are transparent. Throws
/// Error(environment).
/// @param title in the SLD; empty: the file's name
void write_styles(const std::string& tif_path, const std::vector<ColourStop>& stops, const std::string& unit,
                  StyleKind kind, const std::string& title = "");

/// Returns the style of a polygon layer: one fill for each value of an integer attribute, half transparent.
StyleText polygon_style(const std::string& name, const std::string& title, const std::string& attribute,
                        const std::vector<ColourStop>& stops);

/// Returns the style of elevations: shaded relief.
StyleText relief_style(const std::string& name, const std::string& title);

/// Writes NAME.qml and NAME.sld beside a file NAME.*. Throws Error(environment).
void write_style(const std::string& path, const StyleText& style);

}  // namespace frana::gis
