// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace frana {

struct SceneSpec;

/// A raster that a result may hold as NAME.tif. The one list: what is written with which texts and styles,
/// what maps can be drawn, the names that output.maps and --map know, what --overwrite may replace, and what
/// share/doc/results.md explains follow from it.
struct ResultRaster {
    enum class Kind {
        given,    ///< known before anything flows
        flow,     ///< what the flow did
        classes,  ///< bytes, each value with a label and a colour
        frame     ///< in frames/ only: NAME_0012.tif
    };
    std::string name;  ///< "max_depth"
    Kind kind = Kind::flow;
    std::string title;        ///< "Maximum depth"
    std::string description;  ///< of the band: "Maximum flow depth over time, vertical"
    std::string unit;         ///< "m"
    std::string palette;      ///< empty: of the ground; has no style and is drawn only where it is named
    /// Classes 1, 2, 5, 10, ... rather than equal ones: for what is small over most of the area.
    bool progressive = false;
    std::string command = "run";  ///< that writes it
    std::string when;             ///< "with `[entrainment]`"; empty: always
    /// Whether a scene asks for what makes it; null: every one does.
    bool (*can_come)(const SceneSpec& scene) = nullptr;
    bool if_it_happens = false;  ///< not in every result of such a scene
    bool in_frames = false;      ///< also at every frame
    bool is_surface = false;     ///< thickness: a view shows the surface of what flowed
    bool has_view = false;       ///< output.maps = on draws a view as well as a map

    /// Whether it has a style beside it, and is among the maps that `frana render` draws of itself.
    [[nodiscard]] bool is_drawn() const noexcept { return !palette.empty(); }
    /// Whether it lies in the result's own folder.
    [[nodiscard]] bool in_result() const noexcept { return kind != Kind::frame && command != "converge"; }
};

const std::vector<ResultRaster>& result_rasters();

/// Null for other names.
const ResultRaster* find_result_raster(const std::string& name);

/// Ends the name of a map that is a view in perspective.
inline constexpr const char* k_view_ending = "_3d";
/// "max_depth" of "max_depth_3d"; other names as they are.
std::string raster_of_map(const std::string& map);

/// What output.maps = on draws, as far as a result has it.
std::vector<std::string> usual_maps();
/// The names that output.maps may list.
std::vector<std::string> map_names();

}  // namespace frana
