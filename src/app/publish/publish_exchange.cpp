// SPDX-License-Identifier: Apache-2.0
#include "app/publish/publish_exchange.h"

#include <algorithm>
#include <cmath>

#include "analysis/ground_statistics.h"
#include "analysis/trace.h"
#include "app/input/scene_language.h"
#include "app/store/layers.h"
#include "app/store/provenance.h"
#include "app/store/result_files.h"
#include "app/text/file_stems.h"
#include "app/text/number_text.h"
#include "gis/raster/frames_out.h"
#include "gis/raster/raster_in.h"
#include "gis/raster/raster_out.h"
#include "gis/raster/styles.h"

namespace frana::app {
namespace {

bool has_format(const SceneSpec& spec, const char* format) {
    const std::vector<std::string>& formats = spec.output.formats;
    return std::find(formats.begin(), formats.end(), format) != formats.end();
}

/// Zero where there is ground but no flow, as in AvaFrame's own files.
Raster filled(const Raster& values, const Raster& terrain) {
    Raster raster = values;
    terrain.values.for_each_stored([&](std::size_t cell, double ground) {
        if (!std::isnan(ground) && std::isnan(std::as_const(raster).values[cell])) raster.values[cell] = 0;
    });
    return raster;
}

/// With the classes of the result's own raster of that quantity; nothing is drawn where there was no flow.
void write_peak_style(const std::string& path, const Raster& raster, const PeakFile& file, const ClassSpec& classes,
                      const Words& words) {
    const ResultRaster& row = *find_result_raster(file.like);
    const std::vector<double> bounds = class_bounds(row, classes, maximum(raster));
    gis::write_styles(path, gis::class_stops(palette(row.palette), bounds, file.unit, words, true), file.unit,
                      gis::StyleKind::classed, file.text);
}

}  // namespace

std::string avaframe_name(const std::string& scene, const std::string& hash) {
    std::string release = shortened_name(scene), digits;
    std::replace(release.begin(), release.end(), '_', '-');
    for (const char c : hash)
        if (c != '-' && digits.size() < 10) digits += c;
    return release + "_" + digits + "_C_null_dfa";
}

void publish_avaframe(const Prepared& prepared, const RunResult& result, const ResultDirectory& directory,
                      RunLog& log) {
    if (prepared.spec.output.names != "avaframe") return;
    directory.make_folder(k_peak_folder);
    const auto origin = provenance(prepared);
    const std::string name =
        std::string(k_peak_folder) + "/" + avaframe_name(scene_name(prepared.spec), origin.at("SCENE_HASH"));
    const Raster thickness = result.depth_is_normal ? result.max_depth : normal_depth(result.max_depth, result.bed);
    const bool large = result.max_depth.values.is_tiled(), text_files = has_format(prepared.spec, "ascii");
    if (text_files && large)
        log.warn(worded(
            "the AvaFrame rasters are written as GeoTIFF: an ASCII grid would hold all {1} cells of the map, reached "
            "or not",
            {numeral(grouped(result.max_depth.grid.cell_count()))}));
    const Raster* const values_of[] = {&result.max_pressure, &thickness, &result.max_velocity};
    static_assert(std::size(values_of) == std::size(k_peak_files));
    for (std::size_t i = 0; i < std::size(k_peak_files); ++i) {
        const auto& [kind, text, unit, like] = k_peak_files[i];
        const Raster& values = *values_of[i];
        const Raster raster = filled(values, prepared.scene.terrain);
        const std::string stem = directory.path(name + "_" + kind);
        if (text_files && !large)
            gis::write_ascii_grid(stem + ".asc", raster);
        else
            gis::write_geotiff(stem + ".tif", raster, {kind, text, unit, origin});
        write_peak_style(stem + ".tif", raster, k_peak_files[i], prepared.spec.output.classes, words_of(prepared.spec));
    }
}

void publish_frame_stacks(const Prepared& prepared, const ResultDirectory& directory) {
    for (const auto& [word, file, format] : {std::tuple{"netcdf", k_netcdf_file, gis::StackFormat::netcdf},
                                             std::tuple{"zarr", k_zarr_folder, gis::StackFormat::zarr}}) {
        if (!has_format(prepared.spec, word)) continue;
        const std::vector<StoredFrame> frames = stored_frames(directory.path(k_frame_folder));
        std::vector<double> times;
        for (const StoredFrame& frame : frames) times.push_back(frame.time);
        gis::FrameStack stack(directory.path(file), format, prepared.scene.terrain.grid, times, provenance(prepared));
        for (std::size_t i = 0; i < frames.size(); ++i) {
            stack.add(i, gis::read_result_raster(frames[i].raster_file("depth")),
                      gis::read_result_raster(frames[i].raster_file("velocity")));
        }
        stack.close();
    }
}

}  // namespace frana::app
