// SPDX-License-Identifier: Apache-2.0
#include "app/commands/writing_forecast.h"

#include <algorithm>
#include <cmath>

#include "app/pictures/animation.h"
#include "params/grammar/picture_text.h"
#include "params/keys/result_rasters.h"

namespace frana::app {
namespace {

// Processor time of the sample with and without each part, beside other work; meant to be right within a factor of two.
// Pictures by their size, per million pixels; the libraries that draw are loaded once.
constexpr double k_loading_s = 0.7, k_picture_s = 0.11, k_film_picture_s = 0.04, k_drawn_bytes = 0.42e6,
                 k_film_picture_bytes = 9e3;
// Rasters, per cell that is stored and not nodata, compressed; the ground fills the whole map.
constexpr double k_cell_s = 60e-9, k_raster_cell_bytes = 3, k_ground_bytes = 2.6;
// Vector layers, tables, charts, the report's text; a row of timeseries.csv.
constexpr double k_rest_s = 0.8, k_rest_bytes = 0.45e6, k_row_bytes = 130;
// Flows spread to about so many times their release.
constexpr double k_usual_spread = 10;
// Pictures of a run besides its maps: comparison and charts; and of a study: charts.
constexpr double k_charts = 3, k_study_charts = 4;
// Rasters that a run writes besides dtm and bed, and a study for each threshold or quantity.
constexpr double k_rasters = 6, k_bands = 2;

double megapixels(const Size& size) {
    return static_cast<double>(size.width) * size.height / 1e6;
}

/// Adds pictures of a scene's maps, each once more in the report as a smaller one.
void add_pictures(const OutputSpec& output, double count, double cells, WritingForecast& forecast) {
    const double size = megapixels(size_from_text(output.map_size).value_or(Size{}));
    forecast.seconds += k_loading_s + count * (size * k_picture_s + cells * k_cell_s);
    forecast.disk_bytes += count * static_cast<double>(output.map_formats.size()) * size * k_drawn_bytes;
    if (output.report) forecast.disk_bytes += std::min(count, k_charts) * size * k_drawn_bytes;
}

/// Number of the maps of output.maps = on that every run of the scene has.
double usual(const SceneSpec& scene) {
    double count = 0;
    for (const std::string& name : usual_maps()) {
        const ResultRaster& row = *find_result_raster(raster_of_map(name));
        const bool is_there = row.is_produced_by == nullptr || row.is_produced_by(scene);
        count += row.command == "run" && is_there && !row.if_it_happens ? 1 : 0;
    }
    return count;
}

double frames_of(const Prepared& prepared, const std::optional<TimeEstimate>& trial) {
    const double interval = prepared.scene.time.frame_interval;
    if (!(interval > 0)) return 0;
    const double end = trial && !trial->cut_short ? trial->trial_end : prepared.scene.time.end;
    return std::ceil(end / interval) + 1;
}

double reached_cells(const Prepared& prepared, const std::optional<TimeEstimate>& trial) {
    return trial ? trial->reached_cells : k_usual_spread * prepared.release.area_m2 / prepared.scene.grid.cell_area();
}

void add_film(const Prepared& prepared, const std::optional<TimeEstimate>& trial, WritingForecast& forecast) {
    const OutputSpec& output = prepared.spec.output;
    const double frames = frames_of(prepared, trial), cells = reached_cells(prepared, trial);
    if (output.frames) {
        forecast.seconds += frames * 2 * cells * k_cell_s;
        forecast.disk_bytes += frames * 2 * 0.5 * cells * k_raster_cell_bytes;
    }
    if (!output.animation) return;
    forecast.seconds += frames * k_film_picture_s;
    forecast.disk_bytes += frames * k_film_picture_bytes;
}

}  // namespace

WritingForecast forecast_writing(const Prepared& prepared, const RunEstimate& expected,
                                 const std::optional<TimeEstimate>& trial) {
    const OutputSpec& output = prepared.spec.output;
    const auto stored = static_cast<double>(expected.stored_cells);
    const double steps = trial ? trial->steps : prepared.scene.time.end / expected.first_step_seconds;
    WritingForecast forecast{k_rest_s + stored * k_rasters * k_cell_s,
                             k_rest_bytes + steps * k_row_bytes + 2 * stored * k_ground_bytes +
                                 k_rasters * reached_cells(prepared, trial) * k_raster_cell_bytes};
    const bool draws = output.maps.front() != "off";
    double maps = 0;
    if (draws) maps = output.maps.front() == "on" ? usual(prepared.spec) : static_cast<double>(output.maps.size());
    const double pictures = maps + (prepared.scar ? 1 : 0) + (draws && output.charts ? k_charts : 0);
    if (pictures > 0) add_pictures(output, pictures, stored, forecast);
    add_film(prepared, trial, forecast);
    return forecast;
}

WritingForecast forecast_study_writing(const StudyInput& input, const RunEstimate& member,
                                       const std::optional<TimeEstimate>& trial, int threads) {
    const OutputSpec& output = input.base.spec.output;
    const bool is_region = input.reading.study.per_polygon();
    const auto stored = static_cast<double>(member.stored_cells);
    // A map for each threshold; quantiles, mean and deviation of two quantities, arrivals, counts.
    const double maps = is_region
                            ? 6
                            : static_cast<double>(output.depth_thresholds.size() + output.velocity_thresholds.size() +
                                                  3 * std::size(k_study_quantiles) + 5 + input.table.keys.size());
    WritingForecast forecast{k_rest_s + stored * maps * k_bands * k_cell_s,
                             k_rest_bytes + 2 * stored * k_ground_bytes +
                                 maps * k_bands * reached_cells(input.base, trial) * k_raster_cell_bytes};
    if (output.maps.front() != "off") {
        const double charts = output.charts && !is_region ? k_study_charts : 0;
        add_pictures(output, maps + charts, stored, forecast);
    }
    if (is_region) return forecast;
    forecast.seconds += engine_seconds(member, trial) / threads;
    add_film(input.base, trial, forecast);
    return forecast;
}

WritingForecast forecast_event_writing(const Prepared& event, const RunEstimate& member) {
    const auto stored = static_cast<double>(member.stored_cells);
    WritingForecast forecast{k_rest_s + stored * k_cell_s, k_rest_bytes + stored * k_raster_cell_bytes};
    if (event.spec.output.maps.front() != "off") add_pictures(event.spec.output, 1 + k_study_charts, stored, forecast);
    return forecast;
}

}  // namespace frana::app
