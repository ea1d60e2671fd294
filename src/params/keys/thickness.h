// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace frana {

template <class Spec>
struct ParameterOf;
struct SceneSpec;

/// A way to give the thickness of the release that has a word. From its row, the only place that names it, follow how
/// release.thickness is read, written and described, how its files are read and what they contradict. Besides: its
/// place in that key's sentence (thickness.cpp) and, unless `metres` says it, the code in
/// app/input/prepare_release.cpp.
struct ThicknessKind {
    const char* word;
    const char* operands;           ///< after the colon, as users are shown them: "PRE,POST"
    bool from_files = true;         ///< the operands are rasters; false: a column of the perimeter
    bool elevations = false;        ///< of elevations, whose difference is vertical; false: of thicknesses
    bool below_dtm = false;         ///< the DTM is above the rasters and is read with them
    bool without_operands = false;  ///< the word alone is a value as well: a slip surface fitted to each polygon
    bool phases = false;            ///< depths of solids and of fluid, whose sum is the thickness
    bool as_in_file = false;        ///< the values of one file, whose volume is released
    /// From the elevation of the DTM (only if `below_dtm`) and the value of each file in a cell. Null: not so simple.
    double (*metres)(double dtm, std::span<const double> files) = nullptr;
};

/// How the thickness of the release is given.
struct ThicknessSpec {
    const ThicknessKind* kind = nullptr;  ///< null: one number
    double metres = 0;                    ///< that number
    std::vector<std::string> names{};     ///< the column, or the files

    /// Whether the thickness comes from rasters alone: no perimeter is needed.
    [[nodiscard]] bool by_raster() const noexcept { return kind != nullptr && kind->from_files && !names.empty(); }
    /// Whether the slip surface is fitted to each polygon.
    [[nodiscard]] bool fitted() const noexcept { return kind != nullptr && names.empty(); }
    [[nodiscard]] bool in_phases() const noexcept { return kind != nullptr && kind->phases; }
    [[nodiscard]] bool as_in_file() const noexcept { return kind != nullptr && kind->as_in_file; }
};

/// Returns "a number greater than 0, attribute:NAME, ...".
std::string thickness_forms();
std::string text_of(const ThicknessSpec& thickness);
/// Returns the key release.thickness.
ParameterOf<SceneSpec> thickness_parameter();

}  // namespace frana
