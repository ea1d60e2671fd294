// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/raster.h"
#include "render/map/map2d.h"

namespace frana::app {

/// A raster of a file, ready to be drawn as it is: nothing is computed from it.
struct MapLayer {
    std::string name;   ///< of the picture's file: "max_depth", "depth_t12.5"
    std::string title;  ///< "Maximum depth"
    std::string unit;
    std::string palette = "depth";
    std::vector<double> classes;                 ///< bounds; empty: chosen from the values
    std::vector<render::ClassLabel> categories;  ///< of a raster of classes
    Raster values;
    std::optional<render::Dots> dots;  ///< drawn instead of the values, which then only say where and how much
    bool is_surface = false;           ///< thickness: a view shows the surface of what flowed
    std::optional<double> time;        ///< of what it shows at one instant [s]
    std::string source;                ///< "max_depth.tif, band 1"
    std::vector<std::string> notes;    ///< beside the map, under the result's own
    bool notes_alone = false;          ///< without the result's
};

/// Reads the first band of a raster. What is known of frana's own files by their names, and what the file says
/// itself (description, unit, classes with colours, TIME_S), decides how it is drawn. `foreign`: a file of another
/// program, in which a value of 0 means that nothing flowed. Throws Error(input).
MapLayer read_map_layer(const std::string& path, bool foreign = false);

/// The greatest values of frames of one quantity, coloured as its maximum over time. Throws Error(input).
MapLayer read_greatest_layer(const std::vector<std::string>& paths);

/// A comparison's or hazard map's areas, one line a class: "Hit 12 300 m²".
std::vector<std::string> class_areas(const MapLayer& layer);

}  // namespace frana::app
