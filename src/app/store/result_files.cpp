// SPDX-License-Identifier: Apache-2.0
#include "app/store/result_files.h"

#include <fnmatch.h>

#include <cerrno>
#include <cstring>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/files.h"
#include "gis/vector/vector_out.h"
#include "params/keys/output_parameters.h"
#include "params/keys/result_rasters.h"

namespace frana::app {
namespace {

// A file that does not exist or is not accessible counts as absent; a read error of the disk is a problem.
bool is_not_there(int reason) {
    return reason == ENOENT || reason == ENOTDIR || reason == EISDIR || reason == EACCES || reason == EPERM ||
           reason == ELOOP || reason == ENAMETOOLONG || reason == EINVAL;
}

}  // namespace

std::optional<Json> read_json_file(const std::string& path) {
    std::string text;
    const int reason = read_blocks(path, [&](std::string_view bytes) { text += bytes; });
    if (is_not_there(reason)) return std::nullopt;
    if (reason != 0)
        throw Error(ErrorKind::environment, Problem{std::string("cannot be read: ") + std::strerror(reason), path, "",
                                                    "", system_remedy(reason)});
    Json json = Json::parse(text, nullptr, false);
    return json.is_discarded() ? std::nullopt : std::optional(std::move(json));
}

template <class T>
std::optional<T> value_in(const Json& json, const std::string& pointer) {
    const Json::json_pointer place(pointer);
    if (!json.contains(place)) return std::nullopt;
    const Json& value = json[place];
    const bool is_of_type = std::is_same_v<T, bool>           ? value.is_boolean()
                            : std::is_same_v<T, std::int64_t> ? value.is_number_integer()
                            : std::is_same_v<T, double>       ? value.is_number()
                                                              : value.is_string();
    return is_of_type ? std::optional(value.get<T>()) : std::nullopt;
}

template std::optional<bool> value_in(const Json&, const std::string&);
template std::optional<double> value_in(const Json&, const std::string&);
template std::optional<std::int64_t> value_in(const Json&, const std::string&);
template std::optional<std::string> value_in(const Json&, const std::string&);

namespace {

class Table {
  public:
    Table& by(const std::string& command) {
        command_ = command;
        return *this;
    }
    Table& add(FileKind kind, std::initializer_list<std::string> patterns) {
        for (const std::string& pattern : patterns) rows_.push_back({pattern, kind, command_});
        return *this;
    }
    Table& add_styles(const std::string& file) {
        for (const char* ending : k_style_endings) add(FileKind::style, {file.substr(0, file.rfind('.')) + ending});
        return *this;
    }
    /// Adds a GeoPackage of zones, their style, and their files in the other formats of output.formats.
    Table& add_zones(const std::string& file) {
        add(FileKind::vector, {file}).add_styles(file);
        const std::string stem = file.substr(0, file.rfind('.'));
        for (const char* ending : gis::k_shapefile_endings) add(FileKind::vector, {stem + ending});
        return add(FileKind::vector, {stem + ".kmz", stem + ".dxf"});
    }
    /// Adds the rasters written by the command.
    Table& add_rasters() {
        for (const ResultRaster& row : result_rasters()) {
            if (row.command != command_) continue;
            if (row.in_result()) add(FileKind::raster, {row.stem_pattern() + ".tif"});
            // Elevations are not drawn as a map, but have the style of relief.
            if (row.in_result() && (row.is_drawn() || row.kind == ResultRaster::Kind::given))
                add_styles(row.stem_pattern() + ".tif");
            if (row.in_frames || row.kind == ResultRaster::Kind::frame)
                add(FileKind::raster, {std::string(k_frame_folder) + "/" + row.name + "_*.tif"})
                    .add_styles(frame_style(row.name) + ".tif");
        }
        return *this;
    }
    /// Adds a picture in every format of output.map-formats.
    Table& add_page(const std::string& stem) {
        for (const std::string& format : picture_formats()) add(FileKind::picture, {stem + "." + format});
        return *this;
    }
    [[nodiscard]] std::vector<ResultFile> rows() const { return rows_; }

  private:
    std::string command_;
    std::vector<ResultFile> rows_;
};

std::vector<ResultFile> make_table() {
    Table table;
    table.by("run");
    table.add(FileKind::text, {k_scene_file, k_inputs_file, k_summary_file, k_log_file, k_manifest_file});
    table.add(FileKind::working, {k_building_file, k_replaced_file, "checkpoint/step_*.frana",
                                  std::string(k_page_folder) + "/*.png", std::string(k_page_folder) + "/*.svg"});
    for (const std::string folder : {k_whole_frames, k_cut_frames}) {
        for (const char* ending : {".tif", ".gpkg"})
            table.add(FileKind::working, {folder + "/*_[0-9][0-9][0-9][0-9]*" + ending});
        table.add(FileKind::working, {folder + "/frames.csv"});
    }
    table.add_rasters();
    table.add(FileKind::vector, {k_outlines_file, k_profile_lines, k_gauge_places, k_exposure_file});
    table.add_zones(k_hazard_zones_file);
    table.add(FileKind::table, {k_series_file, k_profile_table, k_gauge_table, k_section_table, k_exposure_table});
    table.add(FileKind::page, {k_report_file, k_map_page_file});
    table.add(FileKind::style, {k_project_file});
    table.add(FileKind::table, {k_frame_list});
    table.add(FileKind::vector, {"frames/particles_*.gpkg"});
    table.by("compare");
    table.add(FileKind::text, {k_comparison_file})
        .add(FileKind::table, {k_comparison_curve})
        .add(FileKind::vector, {k_comparison_outline});
    table.add_rasters().add_page("comparison");
    table.by("ensemble");
    table.add(FileKind::text, {k_study_file, std::string(k_member_folder) + "/member_*/scene.ini"});
    const std::string records = std::string(k_record_folder) + "/records_*.frana";
    table.add(FileKind::working, {k_record_identity, records, std::string(k_record_folder) + "/*/" + records});
    table.add(FileKind::table,
              {k_member_table, k_sensitivity_table, k_hazard_curves, k_disaggregation, k_joined_records});
    table.add(FileKind::vector, {k_member_outlines});
    table.add_rasters().add(FileKind::raster, {std::string(k_member_folder) + "/member_*/*.tif"});
    table.by("batch");
    table.add(FileKind::text, {k_region_file}).add_zones(k_degree_zones_file);
    table.add_zones(std::string(k_scenario_intensity) + "*" + k_zones_ending).add_rasters();
    table.by("calibrate");
    table.add(FileKind::table, {k_posterior_table, k_member_table});
    table.add(FileKind::text, {k_calibration_file, k_best_scene, best_scene_of("*")});
    table.add_rasters();
    table.by("render");
    table.add_page("maps/*");
    table.add_page("charts/*");
    table.add(FileKind::animation, {k_animation_file, "animation.gif"});
    return table.rows();
}

bool matches(const ResultFile& row, const std::string& path) {
    return ::fnmatch(row.pattern.c_str(), path.c_str(), FNM_PATHNAME) == 0;
}

const ResultFile* row_of(const std::string& path) {
    for (const ResultFile& row : result_files())
        if (matches(row, path)) return &row;
    return nullptr;
}

}  // namespace

const std::vector<ResultFile>& result_files() {
    static const std::vector<ResultFile> k_table = make_table();
    return k_table;
}

const ResultFile* existing_file(const std::string& path) {
    if (const ResultFile* row = row_of(path)) return row;
    const auto made = file_in_making(path);
    return made ? row_of(made->name) : nullptr;
}

bool is_leftover(const std::string& path) {
    const auto made = file_in_making(path);
    return made && made->abandoned && row_of(made->name) != nullptr;
}

}  // namespace frana::app
