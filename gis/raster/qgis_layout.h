// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/geometry.h"

namespace frana::gis {

/// A sheet of paper of a project of QGIS, with one map: heading, legend, values, scale, north, title block, sources.
struct ProjectLayout {
    std::string title;     ///< its name in QGIS, and the heading
    std::string subtitle;  ///< below the heading
    std::string sheet;     ///< "A4", "A3"
    bool portrait = false;
    Bounds window;                    ///< ground in the frame
    std::vector<std::string> layers;  ///< titles of the project's layers that it shows, the uppermost first
    std::vector<std::string> legend;  ///< what the legend calls each; empty: not in it
    std::vector<std::vector<std::string>> classes{};  ///< of each, as legend_labels() returns them
    std::string notes;                                ///< values, in lines
    std::string title_block;                          ///< author, date, in lines
    std::string logo{};                               ///< file of a picture
    std::string sources;                              ///< at the foot
    std::string thousands{" "};                       ///< sign between groups of three digits of the map's scale
};

/// Returns the labels of the classes of a layer's style, a QML document.
[[nodiscard]] std::vector<std::string> legend_labels(const std::string& qml);

/// Returns width and height of the map's frame [mm], the same on all these sheets of one paper: what the longest
/// texts and the longest legend leave.
[[nodiscard]] Point frame_of(const std::vector<ProjectLayout>& sheets);

/// A layer as the file of a project names it.
struct LayerReference {
    std::string id, title, source, provider;
};

/// Returns the element of one of the sheets. `crs`: the element of the project's CRS; `layers`: those of its layers.
[[nodiscard]] std::string layout_element(const std::vector<ProjectLayout>& sheets, std::size_t index,
                                         const std::vector<LayerReference>& layers, const std::string& crs);

}  // namespace frana::gis
