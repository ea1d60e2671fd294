// SPDX-License-Identifier: Apache-2.0
#include "app/calibrate/calibration_maps.h"

#include <algorithm>

#include "analysis/trace.h"
#include "app/compare/comparison_input.h"
#include "app/ensemble/map_writer.h"
#include "app/input/scene_language.h"
#include "app/pictures/map_source.h"
#include "app/pictures/result_reader.h"
#include "app/publish/publish_rasters.h"
#include "app/store/result_files.h"
#include "app/store/saved_work.h"
#include "app/text/number_text.h"
#include "app/text/today.h"
#include "gis/crs/crs.h"
#include "gis/raster/rasterize.h"
#include "study/study_maps.h"

namespace frana::app {
namespace {

constexpr Rgb k_best_colour{200, 60, 20};

/// The part of a grid round the cells that a member reached, with a margin.
CellWindow window_of(const study::FinishedMembers& members, const GridSpec& grid) {
    constexpr std::int64_t k_margin = 16;
    const CellWindow reached = study::reached_window(members, grid);
    const std::int64_t top = std::clamp<std::int64_t>(reached.row - k_margin, 0, grid.rows),
                       left = std::clamp<std::int64_t>(reached.column - k_margin, 0, grid.columns),
                       bottom = std::clamp<std::int64_t>(reached.row + reached.rows + k_margin, top, grid.rows),
                       right =
                           std::clamp<std::int64_t>(reached.column + reached.columns + k_margin, left, grid.columns);
    return {top, left, bottom - top, right - left};
}

/// One event under the posterior.
struct EventGround {
    const StudyInput& study;
    const EventRuns& runs;
    const study::EventSpec& event;
    double threshold;
    study::FinishedMembers members;
    CellWindow window;
};

EventGround ground_of(const CalibrationInput& input, const CalibrationRuns& runs, const CalibrationResult& result,
                      std::size_t e) {
    const StudyInput& study = input.spec().refine == 0 ? input.coarse[e] : input.own[e];
    EventGround ground{study, runs.last().events[e], input.spec().events[e], observed_threshold(study.base.spec), {},
                       {}};
    for (std::size_t i = 0; i < result.weights.size(); ++i) {
        if (!(result.weights[i] > 0)) continue;
        ground.members.records.push_back(record_file(ground.runs.records, i));
        ground.members.weights.push_back(result.weights[i]);
    }
    ground.window = window_of(ground.members, study.base.scene.grid);
    return ground;
}

MapSource source_of(const EventGround& ground, const CalibrationResult& result) {
    const Prepared& base = ground.study.base;
    const OutputSpec& output = base.spec.output;
    MapSource source;
    source.style.words = words_of(base.spec);
    source.title = output.title.value_or(ground.event.name);
    const auto number = [&](double value) { return source.style.words.number(number_text(value, 3)); };
    source.subtitle = source.style.words("{1} runs weighted by the surveys, effective number {2}",
                                         {std::to_string(ground.members.size()), number(result.effective)});
    source.notes = {source.style.words("Deeper than {1} m counts", {number(ground.threshold)})};
    source.terrain = part_of(base.scene.terrain, ground.window);
    const GridSpec& grid = source.terrain.grid;
    source.crs_label = gis::crs_name(grid.crs_wkt);
    source.convergence_deg =
        gis::meridian_convergence_deg(grid.crs_wkt, {(grid.west + grid.east()) / 2, (grid.south() + grid.north) / 2});
    source.longitude_latitude = longitude_latitude(grid.crs_wkt);
    for (std::size_t i = 0; i < base.scene.release.size(); ++i) {
        const PolygonFeature outline = release_outline(base.scene.release[i], i);
        source.release.insert(source.release.end(), outline.parts.begin(), outline.parts.end());
    }
    source.scar = surveyed(base).survey.scar;
    if (const auto best = study::read_record(record_file(ground.runs.records, result.best))) {
        const Raster depth = best->raster(study::Quantity::depth, grid);
        source.marks.push_back({source.style.words("Best run"), gis::polygonise(trace_mask(depth, ground.threshold)),
                                k_best_colour, 1.8, true});
    }
    if (const auto size = size_from_text(output.map_size)) source.style.size = *size;
    source.style.formats = output.map_formats;
    source.style.attribution = output.map_attribution.value_or("");
    source.style.author = output.map_author.value_or("");
    source.style.organisation = output.map_organisation.value_or("");
    source.style.date = date_on_maps(output.map_date, today());
    return source;
}

}  // namespace

bool publish_calibration_maps(const CalibrationInput& input, const CalibrationRuns& runs,
                              const CalibrationResult& result, const ResultDirectory& directory, RunLog& log) {
    bool good = true;
    for (std::size_t e = 0; e < input.events(); ++e) {
        const EventGround ground = ground_of(input, runs, result, e);
        if (ground.window.rows == 0 || ground.window.columns == 0) continue;
        const Prepared& base = ground.study.base;
        const std::string name = "posterior_" + ground.event.name;
        const study::QuantityMaps maps = study::quantity_maps(
            ground.members, study::Quantity::depth, part_of(base.scene.grid, ground.window), {ground.threshold});
        MapWriter(base, directory).write_probability(name, maps.probability.front(), maps.error.front());
        if (base.spec.output.maps.front() == "off") continue;
        directory.make_folder("maps");
        try {
            const MapSource source = source_of(ground, result);
            MapLayer layer =
                read_map_layer(directory.path(name + ".tif"), base.spec.output.classes, source.style.words);
            LayerDrawer drawer(source);
            if (base.spec.output.report) {
                directory.make_folder(k_page_folder);
                drawer.draw_for_page_too(directory.path(k_page_folder));
            }
            drawer.draw(layer, false, directory.path("maps/" + name));
            log.note("drew maps/" + name);
        } catch (const Error& error) {
            log.warn(worded("{1} could not be drawn: {2}", {"maps/" + name, std::string(error.what())}));
            good = false;
        }
    }
    return good;
}

}  // namespace frana::app
