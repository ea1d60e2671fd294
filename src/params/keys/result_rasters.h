// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/words/words.h"

namespace frana {

/// Classes of one quantity on maps, in films and in GIS styles: from 0 to the first bound, between neighbouring bounds,
/// and above the last; of these, as many as the values need.
struct QuantityClasses {
    std::string name;  ///< "max-depth"
    std::string unit;  ///< rasters of this unit have the classes of its first row, unless theirs names another
    std::vector<double> bounds;  ///< greater than 0, rising
};

/// The one list of fixed classes; ResultRaster::classes names its rows. Published thresholds, between and beyond them
/// steps of 1, 2, 5:
/// - depth: 0.5 and 2 m are the Swiss limits of flood intensity, 1 m that of debris flows (BWW, BRP, BUWAL 1997);
/// - velocity: 1 m/s is the Swiss limit of debris flows (the same), above 5 m/s a landslide is extremely rapid (Cruden
///   and Varnes 1996, Landslide types and processes, TRB special report 247);
/// - pressure: 3 and 30 kPa are the Swiss limits of avalanche zones (BFF and SLF 1984, Richtlinien zur
/// Beruecksichtigung
///   der Lawinengefahr), 1 and 10 kPa the Austrian ones (Richtlinie fuer die Gefahrenzonenplanung);
/// - flux: 0.5 and 2 m2/s are the Swiss limits of flood intensity;
/// - energy head: 1.5 m is the Austrian limit of the red zone of torrents;
/// - arrival: whole minutes after the first one, as warning times are given; no published steps are known.
const std::vector<QuantityClasses>& quantity_classes();

/// Returns {0, 0.5, ..., infinity}; empty for a name that is not in the list.
std::vector<double> fixed_classes(const std::string& quantity);

struct OutputSpec;
struct SceneSpec;

/// Word of output.rasters for both components of the stress in the plane; the others are names of rasters.
inline constexpr const char* k_plane_stress = "plane_stress";
bool asks_for_plane_stress(const OutputSpec& output);
/// Whether output.rasters has any other word.
bool asks_for_intensity(const OutputSpec& output);

/// The rasters that other code asks for by name.
struct RasterName {
    static constexpr const char *arrival_time = "arrival_time", *bed = "bed", *cohesion_ratio = "cohesion_ratio",
                                *deposited_depth = "deposited_depth", *dtm = "dtm",
                                *elevation_change = "elevation_change", *eroded_depth = "eroded_depth",
                                *final_depth = "final_depth", *hazard_degree = "hazard_degree",
                                *hit_count = "hit_count", *jump_height = "jump_height", *max_depth = "max_depth",
                                *max_flux = "max_flux", *max_head = "max_head",
                                *max_momentum_flux = "max_momentum_flux", *max_pressure = "max_pressure",
                                *max_velocity = "max_velocity", *outside_depth = "outside_depth",
                                *plane_stress_xx = "plane_stress_xx", *plane_stress_yy = "plane_stress_yy",
                                *sensitivity = "sensitivity", *solid_depth = "solid_depth", *strain = "strain",
                                *uncertainty = "uncertainty", *worst_source = "worst_source";
};

/// A raster that a result may contain as NAME.tif, or as one NAME_VALUE.tif for each of some values. The one list, from
/// which follow: the files written with their texts and styles, the maps that can be drawn, the names that output.maps
/// and --map accept, the files that --overwrite may replace, and the explanations in share/doc/results.md.
struct ResultRaster {
    enum class Kind {
        given,    ///< known before the flow starts
        flow,     ///< computed from the flow
        classes,  ///< bytes, each value with a label and a colour
        frame     ///< in frames/ only: NAME_0012.tif
    };
    std::string name;  ///< "max_depth"
    Kind kind = Kind::flow;
    std::string title;        ///< "Maximum depth"
    std::string description;  ///< of the band: "Maximum flow depth over time, vertical"
    std::string unit;         ///< "m"
    std::string palette;      ///< empty: of the ground; has no style and is drawn only on request
    /// Classes 1, 2, 5, 10, ... instead of equal ones: for values that are small over most of the area.
    bool progressive = false;
    std::string command = "run";  ///< that writes it
    std::string when;             ///< "with `[entrainment]`"; empty: always
    /// Whether the scene produces it; null: every scene does.
    bool (*is_produced_by)(const SceneSpec& scene) = nullptr;
    bool if_it_happens = false;    ///< not in every result of such a scene
    bool only_asked = false;       ///< output.maps = on does not draw it
    bool of_depth = false;         ///< a depth times something else
    bool in_frames = false;        ///< also at every frame
    bool is_surface = false;       ///< thickness: a view shows the surface of the flow
    bool has_view = false;         ///< output.maps may name its view: NAME_3d
    bool by_value = false;         ///< one for each value (a threshold, a key), which takes the place of {} in texts
    const char* joint = "_";       ///< between the name and the value
    bool with_study = false;       ///< of many runs: a map of it is drawn at once; `frana render` draws the others
    bool zero_is_blank = false;    ///< 0 is a value, and nothing is drawn there
    bool is_flow_depth = false;    ///< measured as output.depth says; its description has k_vertical
    bool of_ground = false;        ///< a thickness of the ground: vertical, whatever output.depth says
    bool is_probability = false;   ///< of an event
    bool of_scenario = false;      ///< its value is the name of a region's scenario
    bool of_scheme = false;        ///< classes of hazard.scheme
    std::vector<double> bounds{};  ///< of its classes, whatever the scene; empty: those of `classes`
    std::string asked_by{};        ///< word of output.rasters; empty: none is needed
    std::string classes{};         ///< row of quantity_classes() ; empty: from its values

    /// Whether it has a style file, and is among the maps that `frana render` draws by default.
    [[nodiscard]] bool is_drawn() const noexcept { return !palette.empty(); }
    /// Whether it is in the result's own folder.
    [[nodiscard]] bool in_result() const noexcept { return kind != Kind::frame && command != "converge"; }
    /// "probability_depth_*" where it is by_value, otherwise the name.
    [[nodiscard]] std::string stem_pattern() const { return by_value ? of_value("*") : name; }
    [[nodiscard]] std::string of_value(const std::string& value) const { return name + joint + value; }
};

const std::vector<ResultRaster>& result_rasters();

/// A quantile that a study maps, also the least probability of an outline.
struct StudyQuantile {
    double fraction;
    const char* name;  ///< after the name of the row: quantile_max_depth_05
};
inline constexpr StudyQuantile k_study_quantiles[] = {{0.05, "05"}, {0.5, "50"}, {0.95, "95"}};

/// Returns null for other names. Those of a value ("probability_depth_0.5") have the row of them all.
const ResultRaster* find_result_raster(const std::string& name);
/// Returns the title or description of a raster of this row: {} replaced by the value in its name, 05 as 5.
std::string text_for(const ResultRaster& row, const std::string& text, const std::string& name);

/// In the description of a depth or thickness; with output.depth = normal, that of a flow's depth is the other.
inline constexpr const char* k_vertical = worded("vertical");
inline constexpr const char* k_normal = worded("normal to the bed");
/// Returns text_for(row, row.description, name), with the direction in which depths are measured.
std::string description_of(const ResultRaster& row, const std::string& name, const OutputSpec& output);
/// The same; `direction`: k_vertical or k_normal.
std::string directed_description(const ResultRaster& row, const std::string& name, const std::string& direction);
/// Returns k_vertical, k_normal, or nothing for what is no depth, from the description of a band.
std::string depth_direction(const std::string& description);

/// Ending of the name of a map that is a perspective view.
inline constexpr const char* k_view_ending = "_3d";
/// Returns "max_depth" for "max_depth_3d"; other names unchanged.
std::string raster_of_map(const std::string& map);

/// Returns the maps drawn with output.maps = on, if the result contains their rasters.
std::vector<std::string> usual_maps();
/// Returns the names that output.maps accepts.
std::vector<std::string> map_names();

}  // namespace frana
