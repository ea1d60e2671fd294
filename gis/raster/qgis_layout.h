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
    std::string notes;                ///< values, in lines
    std::string title_block;          ///< author, date, in lines
    std::string logo{};               ///< file of a picture
    std::string sources;              ///< at the foot
};

/// Returns width and height of the map's frame [mm]; a long subtitle leaves it less.
[[nodiscard]] Point frame_of(const ProjectLayout& layout);

/// A layer as the file of a project names it.
struct LayerReference {
    std::string id, title, source, provider;
    std::vector<std::string> classes{};  ///< labels of a raster's colours, as its style has them
};

/// Returns the element of a layout. `crs`: the element of the project's CRS; `number`: of the layout, from 1; `layers`:
/// those of layout.layers.
[[nodiscard]] std::string layout_element(const ProjectLayout& layout, const std::vector<LayerReference>& layers,
                                         const std::string& crs, int number);

}  // namespace frana::gis
