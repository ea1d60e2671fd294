// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace frana::app {

/// A scene to begin with, and what was found in its files.
struct SceneDraft {
    std::string dtm, perimeter;  ///< as the scene names them
    std::string thickness;       ///< empty: open
    std::string preset;          ///< empty: open
    std::string title;
    std::string cell_size;  ///< of the DTM [m]; empty: it is not in metres
    std::vector<std::string> about_dtm, about_crs, about_cells, about_unit, about_perimeter, about_thickness;
};

/// Reads the head of the DTM and the perimeter. Throws Error(input) if one cannot be read or they do not overlap.
SceneDraft draft_of(const std::string& dtm, const std::string& perimeter);

/// Returns the scene file; its comments are the sentences of the declarations.
std::string draft_text(const SceneDraft& draft);

}  // namespace frana::app
