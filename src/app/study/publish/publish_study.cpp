// SPDX-License-Identifier: Apache-2.0
#include "app/study/publish/publish_study.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <utility>

#include "analysis/trace.h"
#include "app/pictures/charts.h"
#include "app/publish/publish_hazard.h"
#include "app/publish/publish_project.h"
#include "app/store/recorded_inputs.h"
#include "app/store/result_directory.h"
#include "app/store/result_files.h"
#include "app/store/scene_identity.h"
#include "app/store/vector_layers.h"
#include "app/study/plan/read_study.h"
#include "app/study/plan/study_input.h"
#include "app/study/pool/member_runs.h"
#include "app/study/pool/study_result.h"
#include "app/study/publish/map_writer.h"
#include "app/study/statistics/study_maps.h"
#include "app/text/text_file.h"
#include "core/text.h"
#include "gis/raster/footprint.h"
#include "gis/vector/vector_out.h"
#include "params/grammar/value_text.h"
#include "params/keys/output_parameters.h"
#include "params/keys/result_rasters.h"

namespace frana::app::study {
namespace {

/// The finished members of one scenario.
FinishedMembers members_of(const StudyInput& input, const StudyResult& result, const std::string& scenario) {
    FinishedMembers members;
    members.store = result.finished.store;
    for (std::size_t i = 0; i < result.finished.size(); ++i) {
        if (input.slope_of(result.finished_at[i]).scenario != scenario) continue;
        members.records.push_back(result.finished.records[i]);
        members.columns.push_back(result.finished.columns[i]);
    }
    return members;
}

std::vector<HazardArea> write_degree(const StudyInput& input, const Raster& degree, const ResultDirectory& directory) {
    const auto scheme = hazard_scheme_of(input.base.spec);
    const ProcessMatrix& matrix = *scheme->matrix_of(input.base.spec.hazard.process);
    ClassMap map{
        RasterName::hazard_degree, "Degree of hazard",       degree_classes(matrix.degrees), *scheme, matrix.source,
        k_degree_zones_file,       intensity_limits(*scheme)};
    return publish_classes(degree, map, provenance(input.base), input.base.spec, directory);
}

void write_reached(const StudyInput& input, const Raster& depth, const ResultDirectory& directory) {
    const double threshold = input.base.spec.output.trace_threshold;
    std::vector<gis::ShapeLayer> layers = known_outlines(input);
    layers.push_back({"trace", {}});
    Feature reached;
    reached.shape.areas = gis::polygonise(trace_mask(depth, threshold));
    reached.numbers["threshold_m"] = threshold;
    if (!reached.shape.areas.empty()) layers.back().features.push_back(std::move(reached));
    write_result_shapes(directory.path(k_outlines_file), depth.grid.crs_wkt, layers, words_of(input.base.spec));
}

/// Of a large map, whose elevations are read where somebody asks for them.
void read_ground_under(const Raster& depth, Raster& terrain) {
    if (!terrain.values.is_tiled()) return;
    depth.values.for_each_stored(
        [&](std::size_t cell, double) { static_cast<void>(std::as_const(terrain).values[cell]); });
}

/// Writes the rasters one after the other, so that memory contains few at once. Returns the depth.
/// @param scenario in names of files; empty: all slopes
Raster write_union(const StudyInput& input, const FinishedMembers& members, const GridSpec& grid,
                   const std::string& scenario, const ResultDirectory& directory) {
    const MapWriter writer(input.base, directory);
    const std::string ending = scenario.empty() ? "" : "_" + scenario, count = scenario.empty() ? "" : "scenario_",
                      value = scenario.empty() ? "union_" : "scenario_";
    Raster depth;
    {
        DepthUnion maps = depth_union(members, grid);
        writer.write(value + RasterName::max_depth + ending, maps.depth);
        writer.write(count + RasterName::hit_count + ending, maps.hits);
        writer.write(count + RasterName::worst_source + ending, maps.worst);
        depth = std::move(maps.depth);
    }
    writer.write(value + RasterName::max_velocity + ending, greatest_of(members, Quantity::velocity, grid));
    writer.write(value + RasterName::max_pressure + ending, greatest_of(members, Quantity::pressure, grid));
    writer.write(value + RasterName::arrival_time + ending, earliest_arrival(members, grid));
    return depth;
}

/// @param name of a scenario in names of files
void write_scenario(const StudyInput& input, const FinishedMembers& members, const GridSpec& grid,
                    const std::string& name, const ResultDirectory& directory) {
    write_union(input, members, grid, name, directory);
    const auto scheme = hazard_scheme_of(input.base.spec);
    if (!scheme) return;
    const std::string raster = k_scenario_intensity + name;
    ClassMap map{raster,         scheme->heading,         scheme->classes,         *scheme,
                 scheme->source, raster + k_zones_ending, scheme->minimum_labels()};
    publish_classes(greatest_of(members, Quantity::intensity, grid), map, provenance(input.base), input.base.spec,
                    directory);
}

/// Writes the terrain and the rasters of a region: the union of all slopes, how many reach each cell, which is the
/// worst; the same of each scenario, and the degree of hazard where it has return periods. Adds the area of the union
/// and those of the degrees to the facts.
void publish_unions(StudyInput& input, const StudyResult& result, const ResultDirectory& directory, StudyFacts& facts) {
    const RegionSpec& region = *input.reading.study.region;
    {
        const Raster depth = write_union(input, result.finished, result.grid, "", directory);
        read_ground_under(depth, input.base.scene.terrain);
        publish_study_ground(input, directory);
        write_reached(input, depth, directory);
        facts.reached_threshold = input.base.spec.output.trace_threshold;
        facts.reached_m2 = {masked_area(trace_mask(depth, facts.reached_threshold))};
    }
    std::vector<std::optional<double>> periods;
    for (const std::size_t member : result.finished_at) periods.push_back(input.slope_of(member).return_period);
    if (region.degrees)
        facts.degrees =
            write_degree(input, worst_degree(result.finished, periods, result.grid, *region.degrees), directory);
    if (!region.has_scenarios()) return;
    for (const auto& [name, stem, years] : scenarios_of(input))
        if (const auto members = members_of(input, result, name); members.size() > 0)
            write_scenario(input, members, result.grid, stem, directory);
}

/// Writes the terrain of a region with a frequency, and what any event reaches.
void publish_sources(StudyInput& input, const StudyResult& result, const ResultDirectory& directory) {
    const DepthUnion all = depth_union(result.finished, result.grid);
    MapWriter(input.base, directory).write(RasterName::hit_count, all.hits);
    read_ground_under(all.depth, input.base.scene.terrain);
    publish_study_ground(input, directory);
    write_reached(input, all.depth, directory);
}

namespace fs = std::filesystem;

/// Cells beyond those that a member reached, where the maps of a large terrain end.
constexpr std::int64_t k_margin = 32;

/// Puts the maps on one grid. That of the central member where it is not large and contains all that any member
/// reached; otherwise the part of the terrain round all of them.
void choose_grid(StudyInput& input, StudyResult& result, RunLog& log) {
    const GridSpec& grid = input.base.scene.grid;
    const CellWindow reached = reached_window(result.finished, grid);
    const bool is_inside = reached.row >= 0 && reached.column >= 0 && reached.row + reached.rows <= grid.rows &&
                           reached.column + reached.columns <= grid.columns;
    if (is_inside && !input.base.scene.terrain.values.is_tiled()) {
        result.grid = grid;
        return;
    }
    const CellWindow window{reached.row - k_margin, reached.column - k_margin, reached.rows + 2 * k_margin,
                            reached.columns + 2 * k_margin};
    SceneReading reading = input.central;
    reading.session.reads.reset();  // nobody reads this part again
    const Bounds part = part_of(grid, window).bounds(), file = input.base.ground.file.bounds;
    const bool same_crs = input.base.ground.file.crs_wkt == grid.crs_wkt;  // then no more than there is
    reading.scene.terrain.bounds = !same_crs ? part
                                             : Bounds{std::max(part.west, file.west), std::max(part.south, file.south),
                                                      std::min(part.east, file.east), std::min(part.north, file.north)};
    RunLog silent(true);
    Warnings unused;
    Problems problems;
    std::optional<TerrainInput> ground = prepare_terrain(reading, {silent, unused}, problems);
    problems.throw_if_any();
    input.base.scene.terrain = std::move(ground->terrain);
    input.base.scene.grid = result.grid = input.base.scene.terrain.grid;
    log.note("maps are on the part of the terrain round the cells that a member reached: " +
             extent_text(result.grid.bounds()));
}

/// A member with its row of the table as attributes.
Feature member_feature(const StudyInput& input, const StudyResult& result, const MemberRecord& member,
                       MultiPolygon parts) {
    Feature feature;
    feature.shape.areas = std::move(parts);
    for (const MemberCell& one : member_row(input, result, member)) {
        if (one.name == "engine_seconds") continue;  // the same study is the same file
        if (!one.is_number)
            feature.texts[one.name] = one.text;
        else if (const auto number = number_from_text(one.text))
            feature.numbers[one.name] = *number;
    }
    return feature;
}

/// A slope with the row of its only member, or with how often it fails.
Feature slope_feature(const StudyInput& input, const StudyResult& result, std::size_t number) {
    const Slope& slope = input.slopes[number];
    if (!result.rates) return member_feature(input, result, result.members[number], slope.outline);
    Feature feature;
    feature.shape.areas = slope.outline;
    feature.texts = {{"name", slope.name}, {"group", slope.group}, {"reason", slope.problem}};
    if (const auto& rate = slope.frequency.rate)
        feature.numbers = {{"annual_rate", rate->value}, {"annual_rate_deviation", rate->deviation}};
    feature.numbers["source"] = static_cast<double>(number);
    return feature;
}

/// Writes the outlines of what finished members reach, each in a raster no larger than that; of a region also every
/// release polygon, with the status of its slope.
void write_member_outlines(const StudyInput& input, const StudyResult& result, const std::string& path) {
    gis::ShapeLayer traces{"members", {}}, slopes{"slopes", {}};
    for (std::size_t i = 0; i < result.finished_at.size(); ++i) {
        const MemberRecord record = require_record(result.finished.records[i]);
        const CellWindow window = record.reached(result.grid);
        if (window.rows == 0) continue;
        const Raster depth = record.raster(Quantity::depth, part_of(result.grid, window));
        MultiPolygon trace = gis::polygonise(trace_mask(depth, input.base.spec.output.trace_threshold));
        if (trace.empty()) continue;
        traces.features.push_back(
            member_feature(input, result, result.members[result.finished_at[i]], std::move(trace)));
    }
    for (std::size_t i = 0; i < input.slopes.size(); ++i) slopes.features.push_back(slope_feature(input, result, i));
    std::vector<gis::ShapeLayer> layers;
    if (!input.slopes.empty()) layers.push_back(std::move(slopes));
    layers.push_back(std::move(traces));
    write_result_shapes(path, result.grid.crs_wkt, layers, words_of(input.base.spec));
}

void write_kept_members(const StudyInput& input, const StudyResult& result, const ResultDirectory& directory) {
    for (std::size_t i = 0; i < result.members.size(); ++i) {
        const MemberRecord& member = result.members[i];
        if (const Keep keep = input.spec().keep; keep != Keep::all && (keep == Keep::none || member.finished()))
            continue;
        char name[40];
        std::snprintf(name, sizeof name, "%s/member_%07zu", k_member_folder, member.member);
        directory.make_folder(name);
        write_member(input, member.member, require_record(result.all.records[i]), result.grid, directory, name);
    }
}

bool warn_of_failures(const std::vector<MemberRecord>& runs, const std::string& table, Findings found) {
    const std::size_t failed = failed_of(runs);
    if (failed == 0) return false;
    const auto first =
        std::find_if(runs.begin(), runs.end(), [](const MemberRecord& member) { return !member.failure.empty(); });
    found.warn(worded("{1} of {2} runs failed, first member {3}: {4}. See {5}",
                      {std::to_string(failed), std::to_string(runs.size()), std::to_string(first->member),
                       first->failure.c_str(), table}));
    return static_cast<double>(failed) > k_most_failed * static_cast<double>(runs.size());
}

void warn_of_error(const StudyInput& input, const StudyResult& result, const StudyFacts& facts, Findings found) {
    if (const auto& rare = facts.rare_place) {
        if (rare->hits < k_least_hits)
            found.warn(
                worded("{3}: only {1} of {2} members, probability too low: raise study.samples",
                       {std::to_string(rare->hits), std::to_string(result.finished_at.size()), rare->event.gauge}));
    }
    const auto& until = input.reading.study.until;
    if (until && facts.error.largest() > *until)
        found.warn(
            worded("study.until = {1} is not reached with all members: raise study.samples", {shortest_text(*until)}));
}

}  // namespace

StudyOutcome tell_of_runs(const StudyInput& input, const std::vector<MemberRecord>& runs, const std::string& table,
                          StudyFacts& facts, RunLog& log) {
    StudyOutcome outcome;
    facts.troubles = troubles_of(runs, input.spec().region.has_value());
    outcome.has_troubles = facts.troubles.any();
    Warnings known;
    for (const StudyInput* one : input.studies()) known += one->base.scene.warnings;
    facts.warnings = (known += input.warnings) += facts.warnings;
    if (facts.troubles.any()) {
        log.tell({headline(facts.troubles)});
        facts.warnings.insert(facts.warnings.begin(), headline(facts.troubles));
    }
    outcome.too_many_failed = warn_of_failures(runs, table, {log, facts.warnings});
    facts.warnings += log.tell(kinds_of_warnings(runs, facts.warnings, input.spec().is_calibration() ? table : ""));
    return outcome;
}

void write_study_file(const StudyInput& input, const ResultDirectory& directory) {
    const StudySpec& study = input.spec();
    std::vector<NamedFile> files;
    for (const StudyInput* one : input.studies())
        for (NamedFile& file : named_files(one->base.spec)) files.push_back(std::move(file));
    static_cast<void>(with_files(study, [&](const std::string& key, const std::string& path) {
        files.push_back({key, path});
        return path;
    }));
    write_text_file(directory.path(study.region ? k_region_file : k_study_file),
                    study_text(seen_from(study, directory.target())));
    write_text_file(directory.path(k_inputs_file), recorded_inputs(files, directory.target()));
}

StudyOutcome publish_study(StudyInput& input, std::size_t members, std::size_t computed, int threads,
                           const Stopwatch& since_start, const ResultDirectory& directory, RunLog& log) {
    StudyResult result = read_study_result(input, directory.folder(), members);
    StudyFacts facts;
    const Findings found{log, facts.warnings};
    const bool is_region = input.reading.study.region.has_value();
    const StudyOutcome outcome = tell_of_runs(input, result.members, k_member_table, facts, log);
    input.base.tags = {
        {"VARIED", joined(input.table.keys, ", ")},
        {"RUNS", std::to_string(result.finished_at.size()) + " of " + std::to_string(result.members.size())}};
    if (facts.troubles.any()) input.base.tags[k_lower_bound_item] = headline(facts.troubles).text();
    if (const auto scheme = common_scheme(input)) input.base.tags["SCHEME"] = word_of(*scheme, k_schemes);
    facts.threads = threads;
    facts.computed = computed;
    std::vector<FigureSensitivity> figures;
    const Bounds map = input.base.scene.grid.bounds();
    if (!result.finished_at.empty()) {
        choose_grid(input, result, log);
        // First of all: what it doubts stands on every map.
        facts.scheme_check = check_scheme(input, result.members, result.weights(), threads);
        if (facts.scheme_check)
            for (const auto& [name, value] : rows_of(*facts.scheme_check))
                log.info(worded("{1}: {2}", {name, value}).text());
        const auto warn_first = [&](const Sentence& doubt) {
            const Warning first{doubt, true};
            log.tell({first});
            facts.warnings.insert(facts.warnings.begin(), first);
            input.base.scene.warnings += Warnings{first};
        };
        if (const auto doubt = facts.scheme_check ? warning_of(*facts.scheme_check, is_region) : std::nullopt)
            warn_first(*doubt);
        if (const auto& all = result.rates) {
            const auto unknown = std::count_if(all->sources().begin(), all->sources().end(),
                                               [](const Source& source) { return !(source.rate.value > 0); });
            if (unknown > 0)
                warn_first(worded("annual rates lack {1} slopes: their rates are unknown",
                                  {numeral(std::to_string(unknown))}));
        }
        if (is_region && result.rates) {
            publish_sources(input, result, directory);
        } else if (is_region) {
            publish_unions(input, result, directory, facts);
        } else {
            publish_study_ground(input, directory);
            figures = sensitivities(input, result);
            publish_study_maps(input, result, directory, facts);
            facts.rare_place = rare_place_of(input, result);
            warn_of_error(input, result, facts, found);
        }
        publish_rates(input, result, directory, facts);
        write_member_outlines(input, result, directory.path(k_member_outlines));
        facts.exposure = publish_study_exposure(input, result, map, directory);
        if (facts.exposure) log.info(exposure_sentence(*facts.exposure, ReachedBy::any_run));
    }
    write_study_file(input, directory);  // after the central scene's own inputs
    write_text_file(directory.path(k_member_table), members_csv(input, result));
    if (!is_region) write_text_file(directory.path(k_sensitivity_table), sensitivity_csv(input, figures));
    write_kept_members(input, result, directory);
    // Maps show what the summary says; what drawing adds to it comes at the end.
    write_text_file(directory.path(k_summary_file), study_summary_json(input, result, facts));
    if (!result.finished_at.empty()) {
        draw_study(input, result, figures, directory, found);
        publish_project(directory.folder(), input.base.spec.output.title.value_or(scene_name(input.base.spec)) +
                                                (is_region ? ", region" : ", study"));
    }
    facts.wall_seconds = since_start.seconds();
    if (input.base.spec.output.report) write_study_report(input, result, facts, directory);
    write_text_file(directory.path(k_summary_file), study_summary_json(input, result, facts));
    write_text_file(directory.path(k_log_file), log.text());
    return outcome;
}

}  // namespace frana::app::study
