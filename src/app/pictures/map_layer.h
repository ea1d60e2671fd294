// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/raster.h"
#include "core/words/words.h"
#include "params/keys/result_rasters.h"
#include "render/map/map2d.h"

namespace frana::app {

/// A note on maps of maxima where flow leaves the ground.
inline constexpr const char* k_high_flights = worded("What flies higher above the ground than a house is not shown");

/// Returns the title of a raster of this row: "Probability, depth > 0.5 m" for probability_depth_0.5.
std::string raster_title(const ResultRaster& row, const std::string& name, const Words& words);

/// Puts the label of a class, as files contain it in English, into a language: "High intensity: depth > 1 m and speed >
/// 1 m/s", "Hit: simulated and observed". Parts that no table has stay as they are.
std::string class_label(const std::string& english, const Words& words);

/// Returns words with the texts of the hazard scheme that a raster's metadata contain.
Words words_of_scheme(const std::map<std::string, std::string>& metadata, const Words& words);

/// Returns the name of its hazard scheme that readers of a map know: "Switzerland, debris flows", where it was written
/// without one that for scenes: "swiss-debris-flow"; empty: none.
std::string scheme_title(const std::map<std::string, std::string>& metadata, const Words& words);

/// A raster of a file, ready to be drawn: nothing is computed from it.
struct MapLayer {
    std::string name;              ///< of the picture's file: "max_depth", "depth_t12.5"
    std::string title;             ///< "Maximum depth"
    std::string legend_title{};    ///< "Maximum depth, vertical" (or "normal to the bed"); empty: the title
    bool is_normal_depth = false;  ///< measured normal to the bed: it does not give the surface
    std::string unit;
    std::string palette = "depth";
    std::vector<double> classes;                 ///< bounds, the last may be infinite; empty: from the values
    std::vector<render::ClassLabel> categories;  ///< of a raster of classes
    Raster values;
    std::optional<render::Dots> dots;        ///< drawn instead of the values, which then only specify place and range
    bool is_ground = false;                  ///< values of all the ground, of which a map shows what the flow reached
    bool is_surface = false;                 ///< thickness: a view shows the surface of the flow
    std::optional<double> time;              ///< of a raster at one instant [s]
    std::string source;                      ///< "max_depth.tif, band 1"
    std::vector<std::string> notes;          ///< beside the map, below those of the result
    bool notes_alone = false;                ///< omits those of the result
    std::vector<render::Outline> exposed{};  ///< features of the result by whether the values reach them
};

/// Reads the first band of a raster. How it is drawn depends on the known names of frana's own files and on the file's
/// texts (description, unit, classes with colours, TIME_S); `classes`: as the scene chose them. `foreign`: a file of
/// another program, in which a value of 0 means no flow. `values`: the file's where they are in memory. Throws
/// Error(input).
MapLayer read_map_layer(const std::string& path, const Words& words, bool foreign = false,
                        std::optional<Raster> values = std::nullopt);

/// Returns what a map of a result's own raster must say itself, since maps are passed on without the log: the meaning
/// of a scheme's classes and the source of their limits; that high flights are not shown.
std::vector<std::string> needed_notes(const std::string& path, const Words& words);

/// Whose friction a study shows, and by which keys ("a, b"; empty: none) it differs between the runs.
/// @param of k_central_friction or k_largest_friction
std::vector<std::string> study_friction_notes(const std::string& of, const std::string& varied, const Words& words);
inline constexpr const char *k_central_friction = "central scene", *k_largest_friction = "largest source";

/// Returns the name of the map of probability that a file contains, whatever the file's own name; none for others.
/// Throws Error(input) if it cannot be read.
std::optional<std::string> probability_name(const std::string& path);

/// Returns the greatest values of frames of one quantity, coloured as its maximum over time. Throws Error(input).
MapLayer read_greatest_layer(const std::vector<std::string>& paths, const Words& words);

/// Gives the last class no upper end: particles are faster than the nodes whose values define the classes.
void open_above(MapLayer& layer);

/// Returns the areas of a comparison or hazard map, one line per class: "Hit: 12 300 m²".
std::vector<std::string> class_areas(const MapLayer& layer, const Words& words);

}  // namespace frana::app
