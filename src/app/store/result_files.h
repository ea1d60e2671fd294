// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/json.h"

namespace frana::app {

/// Returns none if the file does not exist, is not accessible, or is not JSON. Throws Error(environment) for a read
/// error of the disk.
std::optional<Json> read_json_file(const std::string& path);

/// Returns the value at a pointer ("/runout/drop_m"); none if there is none of this type: double, std::int64_t, bool,
/// std::string.
template <class T>
std::optional<T> value_in(const Json& json, const std::string& pointer);

enum class FileKind { text, table, vector, raster, style, picture, page, animation, working };

/// A file that frana writes to a result directory. The one list of files that a result's manifest may name, that may be
/// replaced, that an unfinished folder may contain, and that documents and tests refer to.
struct ResultFile {
    /// Pattern of the path inside the result: "*" matches any text within a name.
    std::string pattern;
    FileKind kind;
    std::string written_by;  ///< the first command that writes it: "run", "render"

    /// Drawn from the result's other files; can be redrawn.
    [[nodiscard]] bool is_drawn() const noexcept { return kind == FileKind::picture || kind == FileKind::animation; }
};

/// Returns all of them; rasters are those of the table of rasters (params/keys/result_rasters.h), each drawn one with
/// its styles.
const std::vector<ResultFile>& result_files();

/// Returns the row of a path inside a result, also while that file is being written ("max_depth.partial123.tif"); null
/// for files that frana does not write.
const ResultFile* existing_file(const std::string& path);

/// Returns whether a path inside a result is that of a file left unfinished by a killed process.
bool is_leftover(const std::string& path);

/// The endings of the styles beside a raster or vector file.
inline constexpr const char* k_style_endings[] = {".qml", ".sld"};

// Names of files, defined only here.
inline constexpr const char* k_manifest_file = "manifest.json";
inline constexpr const char* k_scene_file = "scene.ini";
inline constexpr const char* k_summary_file = "summary.json";
/// What the scene read: places and checksums.
inline constexpr const char* k_inputs_file = "inputs.json";
inline constexpr const char* k_log_file = "log.txt";
inline constexpr const char *k_report_file = "report.html", *k_map_page_file = "map.html";
inline constexpr const char* k_series_file = "timeseries.csv";
inline constexpr const char* k_outlines_file = "extent.gpkg";
/// A QGIS project that shows the result.
inline constexpr const char* k_project_file = "result.qgz";
inline constexpr const char* k_profile_table = "profiles.csv";
inline constexpr const char* k_profile_lines = "profiles.gpkg";
inline constexpr const char* k_gauge_table = "gauges.csv";
inline constexpr const char* k_section_table = "sections.csv";
inline constexpr const char* k_gauge_places = "gauges.gpkg";
inline constexpr const char* k_exposure_table = "exposure.csv";
inline constexpr const char* k_exposure_file = "exposure.gpkg";
inline constexpr const char* k_hazard_zones_file = "hazard_zones.gpkg";
inline constexpr const char* k_degree_zones_file = "hazard_degree_zones.gpkg";
/// Of a scenario: scenario_intensity_NAME_zones.gpkg.
inline constexpr const char *k_scenario_intensity = "scenario_intensity_", *k_zones_ending = "_zones.gpkg";
/// Item of a raster's metadata: why its values are a lower bound.
inline constexpr const char* k_lower_bound_item = "LOWER_BOUND";
/// Items of a raster's metadata, numbered from 1: the limits of the intensities behind its classes.
inline constexpr const char* k_limit_item = "HAZARD_LIMIT_";
/// The name of the scheme for scenes and for readers, and its texts in other languages as JSON.
inline constexpr const char *k_scheme_item = "HAZARD_SCHEME", *k_scheme_title_item = "HAZARD_SCHEME_TITLE",
                            *k_scheme_words_item = "HAZARD_WORDS";
/// Of mu.tif and xi.tif: the table's title, its source, and where that was read; absent if it was not.
inline constexpr const char *k_friction_item = "FRICTION_TABLE", *k_friction_source_item = "FRICTION_SOURCE",
                            *k_friction_read_item = "FRICTION_SOURCE_READ_AT";
/// Of those of a study: whose they are, and the keys by which they differ between its runs.
inline constexpr const char *k_friction_of_item = "FRICTION_OF", *k_friction_varied_item = "FRICTION_VARIED_BY";
inline constexpr const char* k_comparison_file = "comparison.json";
inline constexpr const char* k_comparison_curve = "comparison_curve.csv";
inline constexpr const char* k_comparison_outline = "comparison.gpkg";  ///< that of a survey given to `frana compare`
/// Of a map of probability.
inline constexpr const char* k_animation_file = "animation.mp4";
inline constexpr const char* k_frame_folder = "frames";
/// Beside it in a result that is being built: the frames before they were cut to a part of the map, and while they are.
inline constexpr const char* k_whole_frames = "frames.whole";
inline constexpr const char* k_cut_frames = "frames.cut";
inline constexpr const char* k_frame_list = "frames/frames.csv";
/// Whose styles all frames of a quantity share: frames/depth.qml, .sld.
inline std::string frame_style(const std::string& quantity) {
    return std::string(k_frame_folder) + "/" + quantity;
}
/// File of a raster of params/keys/result_rasters.h.
inline std::string raster_file(const std::string& name) {
    return name + ".tif";
}
inline constexpr const char* k_study_file = "study.ini";
inline constexpr const char* k_region_file = "region.ini";
inline constexpr const char* k_member_table = "members.csv";
inline constexpr const char* k_member_outlines = "members.gpkg";
inline constexpr const char* k_sensitivity_table = "sensitivity.csv";
inline constexpr const char* k_hazard_curves = "hazard_curves.csv";
inline constexpr const char* k_disaggregation = "disaggregation.csv";
/// Layer of k_outlines_file: the cells that a study reaches with at least the probability of a quantile of
/// params/keys/result_rasters.h.
inline std::string probability_layer(const std::string& quantile) {
    return "probability_" + quantile;
}
/// Of a study: the maps of single members, if it keeps them.
inline constexpr const char* k_member_folder = "members";
/// Of a calibration.
inline constexpr const char* k_posterior_table = "posterior.csv";
inline constexpr const char* k_calibration_file = "calibration.json";
inline constexpr const char* k_best_scene = "best.ini";
/// The same of one of several events.
inline std::string best_scene_of(const std::string& event) {
    return "best_" + event + ".ini";
}
/// In the folder in which the result of a study is being built: a record of each member, and what they belong to.
inline constexpr const char* k_record_folder = "records";
inline constexpr const char* k_record_identity = "records/study.txt";
/// Of a complete study that may be extended: both in one file.
inline constexpr const char* k_joined_records = "records.frana";
/// In the folder in which a result is being built, from the beginning.
inline constexpr const char* k_building_file = "being_built.json";
/// In the folder in which a result is being built: pictures for report.html alone.
inline constexpr const char* k_page_folder = "report_pictures";
/// In an older result that is being replaced, until its user's files are in the new one.
inline constexpr const char* k_replaced_file = "being_replaced.json";

}  // namespace frana::app
