// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

namespace frana {

/// The source of a quantity: one number, a column of its vector layer, or a raster.
struct SourceSpec {
    enum class Kind { number, attribute, raster };
    Kind kind = Kind::number;
    double number = 0;  ///< number, in the key's unit
    std::string name;   ///< attribute: the column; raster: the file
};

/// Reads "12.5", "attribute:NAME" or "raster:FILE"; none: invalid.
std::optional<SourceSpec> source_from_text(const std::string& text);
std::string text_of(const SourceSpec& source);

}  // namespace frana
