// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

namespace frana {

/// The thickness of the release: a number, a column of the perimeter, a raster, the difference of two DTMs, the DTM
/// minus a slip surface (a raster of its elevation, or one fitted to the perimeter), or the sum of the depths of solids
/// and fluid.
struct ThicknessSpec {
    enum class Kind { number, attribute, raster, difference, slip_surface, phases };
    Kind kind = Kind::number;
    double metres = 0;      ///< number
    std::string attribute;  ///< attribute: the column's name
    std::string raster;     ///< raster, slip surface: the file; difference: the DTM before the failure; phases: solids
    std::string post;       ///< difference: the DTM after the failure; phases: fluid

    /// Whether the thickness comes from rasters alone: no perimeter is needed.
    [[nodiscard]] bool by_raster() const noexcept { return !raster.empty(); }
    /// Whether the slip surface is fitted to each polygon.
    [[nodiscard]] bool fitted() const noexcept { return kind == Kind::slip_surface && raster.empty(); }
};

/// Reads "12.5", "attribute:NAME", "raster:FILE", "difference:PRE,POST", "slip-surface",
/// "slip-surface:FILE" or "phases:SOLIDS,FLUID"; none: invalid.
std::optional<ThicknessSpec> thickness_from_text(const std::string& text);
std::string text_of(const ThicknessSpec& thickness);

}  // namespace frana
