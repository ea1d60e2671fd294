// SPDX-License-Identifier: Apache-2.0
#include "app/store/result_files.h"

#include <fnmatch.h>

#include "app/store/layers.h"
#include "core/file_aside.h"

namespace frana::app {
namespace {

constexpr const char* k_all_below = "/**";

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
    Table& add_raster(const std::string& name, bool styled = true) {
        add(FileKind::raster, {name + ".tif"});
        return styled ? add(FileKind::style, {name + ".qml", name + ".sld"}) : *this;
    }
    /// In every format of output.map-formats.
    Table& add_picture(const std::string& stem) {
        return add(FileKind::picture, {stem + ".png", stem + ".pdf", stem + ".tif"});
    }
    [[nodiscard]] std::vector<ResultFile> rows() const { return rows_; }

  private:
    std::string command_;
    std::vector<ResultFile> rows_;
};

std::vector<ResultFile> make_table() {
    Table table;
    table.by("run");
    table.add(FileKind::text, {"scene.ini", "summary.json", "log.txt", k_manifest_file});
    table.add(FileKind::working, {k_building_file, k_replaced_file, "checkpoint/step_*.frana",
                                  "checkpoint/reserve", std::string(k_page_folder) + "/*.png"});
    for (const Layer& layer : all_layers()) table.add_raster(layer.name);
    table.add_raster("release").add_raster("hazard");
    for (const char* plain : {"dtm", "bed", "max_flux", "max_head"}) table.add_raster(plain, false);
    table.add(FileKind::vector, {"extent.gpkg", "profiles.gpkg", "gauges.gpkg", "hazard_zones.gpkg"});
    table.add(FileKind::style, {"hazard_zones.qml", "hazard_zones.sld"});
    table.add(FileKind::table, {"timeseries.csv", "profiles.csv", "gauges.csv", "sections.csv"});
    table.add(FileKind::page, {"report.html"});
    table.add(FileKind::table, {"frames/frames.csv", "frames/particles.pvd"});
    table.add(FileKind::raster, {"frames/depth_*.tif", "frames/velocity_*.tif"});
    for (const Layer& layer : all_layers()) table.add(FileKind::raster, {"frames/" + layer.name + "_*.tif"});
    table.add(FileKind::vector, {"frames/particles_*.gpkg", "frames/particles_*.vtp"});
    table.add(FileKind::stack, {"frames.nc", std::string("frames.zarr") + k_all_below});
    for (const char* kind : {"ppr", "pft", "pfv"}) {
        const std::string stem = std::string("peakFiles/*_C_null_dfa_") + kind;
        table.add(FileKind::raster, {stem + ".tif", stem + ".asc"}).add(FileKind::text, {stem + ".prj"});
    }
    table.by("compare");
    table.add(FileKind::text, {"comparison.json"}).add(FileKind::table, {"comparison_curve.csv"});
    table.add_raster("comparison").add(FileKind::picture, {"comparison.png", "comparison.pdf"});
    table.by("render");
    table.add_picture("maps/*");
    table.add(FileKind::picture, {"charts/*.png", "charts/*.pdf", "plates/*.png", "plates/*.pdf"});
    table.add(FileKind::film, {"animation.mp4", "animation.gif"});
    return table.rows();
}

bool matches(const ResultFile& row, const std::string& path) {
    if (!row.pattern.ends_with(k_all_below))
        return ::fnmatch(row.pattern.c_str(), path.c_str(), FNM_PATHNAME) == 0;
    return path.starts_with(row.pattern.substr(0, row.pattern.size() - 2));
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

const ResultFile* known_file(const std::string& path) {
    if (const ResultFile* row = row_of(path)) return row;
    const auto made = file_in_making(path);
    return made ? row_of(made->name) : nullptr;
}

bool is_leftover(const std::string& path) {
    const auto made = file_in_making(path);
    return made && made->abandoned && row_of(made->name) != nullptr;
}

}  // namespace frana::app
