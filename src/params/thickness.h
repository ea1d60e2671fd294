// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

namespace frana {

/// How thick the release is: a number, a column of the perimeter, a raster, the difference of two DTMs.
struct ThicknessSpec {
    enum class Kind { number, attribute, raster, difference, slip_surface };
    Kind kind = Kind::number;
    double metres = 0;      ///< number
    std::string attribute;  ///< attribute: the column's name
    std::string raster;     ///< raster: the file; difference: the DTM before the failure
    std::string post;       ///< difference: the DTM after the failure
};

/// Reads "12.5", "attribute:NAME", "raster:FILE", "difference:PRE,POST" or "slip-surface"; none: not
/// understood.
std::optional<ThicknessSpec> thickness_from_text(const std::string& text);
std::string text_of(const ThicknessSpec& thickness);

}  // namespace frana
