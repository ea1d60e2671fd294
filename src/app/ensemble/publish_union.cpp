// SPDX-License-Identifier: Apache-2.0
#include "app/ensemble/publish_union.h"

#include <map>
#include <utility>

#include "analysis/trace.h"
#include "app/ensemble/map_writer.h"
#include "app/ensemble/study_files.h"
#include "app/input/scene_language.h"
#include "app/publish/publish_hazard.h"
#include "app/store/provenance.h"
#include "app/store/result_files.h"
#include "app/store/vector_layers.h"
#include "app/text/file_stems.h"
#include "gis/raster/rasterize.h"
#include "study/union_maps.h"

namespace frana::app {
namespace {

constexpr const char* k_matrix_source =
    "after the Swiss recommendations of 1997 (BWW, BRP, BUWAL), or as the region gives it";

/// The finished members, of a region those of one scenario.
std::vector<study::UnionMember> members_of(const StudyInput& input, const StudyResult& result,
                                           const std::optional<std::string>& scenario) {
    std::vector<study::UnionMember> members;
    for (std::size_t i = 0; i < result.finished_at.size(); ++i) {
        study::UnionMember member{result.members[result.finished_at[i]].member, result.finished.records[i], {}};
        if (!input.slopes.empty()) {
            const Slope& slope = input.slopes[member.number];
            if (scenario && slope.scenario != *scenario) continue;
            member.return_period = slope.return_period;
        }
        members.push_back(std::move(member));
    }
    return members;
}

std::vector<HazardArea> write_degree(const StudyInput& input, const Raster& degree, const ResultDirectory& directory) {
    const auto scheme = hazard_scheme_of(input.base.spec);
    const DegreeMatrix& matrix = input.reading.study.region->degrees;
    ClassMap map{"hazard_degree", "Degree of hazard",  degree_classes(matrix),   scheme->name,
                 k_matrix_source, k_degree_zones_file, intensity_limits(*scheme)};
    return publish_classes(degree, map, provenance(input.base), words_of(input.base.spec), directory);
}

void write_reached(const StudyInput& input, const Raster& depth, const ResultDirectory& directory) {
    const double threshold = input.base.spec.output.trace_threshold;
    std::vector<gis::OutlineLayer> layers = known_outlines(input);
    layers.push_back({"trace", {}});
    PolygonFeature reached;
    reached.parts = gis::polygonise(trace_mask(depth, threshold));
    reached.numbers["threshold_m"] = threshold;
    if (!reached.parts.empty()) layers.back().features.push_back(std::move(reached));
    write_result_outlines(directory.path(k_outlines_file), depth.grid.crs_wkt, layers, words_of(input.base.spec));
}

double covered_area(const Raster& depth, double threshold) {
    std::int64_t cells = 0;
    depth.values.for_each_stored([&](std::size_t, double value) { cells += value > threshold; });
    return static_cast<double>(cells) * depth.grid.cell_area();
}

/// Of a large map, whose elevations are read where somebody asks for them.
void read_ground_under(const Raster& depth, Raster& terrain) {
    if (!terrain.values.is_tiled()) return;
    depth.values.for_each_stored(
        [&](std::size_t cell, double) { static_cast<void>(std::as_const(terrain).values[cell]); });
}

/// Names of the rasters of a union.
struct UnionNames {
    std::string depth, velocity, pressure, arrival, hits, worst;
};

/// Writes the rasters one after the other, so that memory contains few at once. Returns the depth.
Raster write_union(const StudyInput& input, const std::vector<study::UnionMember>& members, const GridSpec& grid,
                   const UnionNames& names, const ResultDirectory& directory) {
    const MapWriter writer(input.base, directory);
    Raster depth;
    {
        study::DepthUnion maps = study::depth_union(members, grid);
        writer.write(names.depth, maps.depth);
        writer.write(names.hits, maps.hits);
        writer.write(names.worst, maps.worst);
        depth = std::move(maps.depth);
    }
    writer.write(names.velocity, study::greatest_of(members, study::Quantity::velocity, grid));
    writer.write(names.pressure, study::greatest_of(members, study::Quantity::pressure, grid));
    writer.write(names.arrival, study::earliest_arrival(members, grid));
    return depth;
}

/// @param name of a scenario in names of files
void write_scenario(const StudyInput& input, const std::vector<study::UnionMember>& members, const GridSpec& grid,
                    const std::string& name, const ResultDirectory& directory) {
    const std::string of_scenario = "scenario_";
    write_union(
        input, members, grid,
        {of_scenario + "max_depth_" + name, of_scenario + "max_velocity_" + name, of_scenario + "max_pressure_" + name,
         of_scenario + "arrival_time_" + name, of_scenario + "hit_count_" + name, of_scenario + "worst_source_" + name},
        directory);
    const auto scheme = hazard_scheme_of(input.base.spec);
    if (!scheme) return;
    ClassMap map{of_scenario + "intensity_" + name, "Intensity", scheme->classes, scheme->name, scheme->source, "",
                 {scheme->minimum_label()}};
    publish_classes(study::greatest_of(members, study::Quantity::intensity, grid), map, provenance(input.base),
                    words_of(input.base.spec), directory);
}

}  // namespace

void publish_unions(StudyInput& input, const StudyResult& result, const ResultDirectory& directory, StudyFacts& facts) {
    const auto& region = input.reading.study.region;
    const std::vector<study::UnionMember> all = members_of(input, result, std::nullopt);
    {
        const Raster depth = write_union(input, all, result.grid,
                                         {"union_max_depth", "union_max_velocity", "union_max_pressure",
                                          "union_arrival_time", "hit_count", "worst_source"},
                                         directory);
        read_ground_under(depth, input.base.scene.terrain);
        publish_study_ground(input, directory);
        write_reached(input, depth, directory);
        facts.reached_threshold = input.base.spec.output.trace_threshold;
        facts.reached_m2 = {covered_area(depth, facts.reached_threshold)};
    }
    if (region && region->return_period)
        facts.degrees = write_degree(input, study::worst_degree(all, result.grid, region->degrees), directory);
    if (!region || !region->scenario) return;
    std::map<std::string, bool> scenarios;
    for (const study::UnionMember& member : all) scenarios[input.slopes[member.number].scenario] = true;
    std::vector<std::string> names;
    for (const auto& [name, present] : scenarios) names.push_back(name);
    const std::vector<std::string> stems = file_stems(names);
    for (std::size_t i = 0; i < names.size(); ++i)
        write_scenario(input, members_of(input, result, names[i]), result.grid, stems[i], directory);
}

void write_slopes(const StudyInput& input, const StudyResult& result, const gis::OutlineLayer& traces,
                  const std::string& path) {
    gis::OutlineLayer slopes{"slopes", {}};
    for (const MemberResult& member : result.members) {
        const Slope& slope = input.slopes[member.member];
        PolygonFeature feature;
        feature.parts = slope.outline;
        feature.numbers["member"] = static_cast<double>(member.member);
        if (slope.return_period) feature.numbers["return_period"] = *slope.return_period;
        feature.texts = {{"name", slope.name},
                         {"group", slope.group},
                         {"scenario", slope.scenario},
                         {"status", member.failure.empty() ? "finished" : "failed"},
                         {"reason", member.failure}};
        for (const study::Figure& figure : member.figures) feature.numbers[figure.key] = figure.value;
        for (std::size_t k = 0; k < input.table.keys.size(); ++k)
            feature.texts[input.table.keys[k]] = input.table.values[member.member][k];
        slopes.features.push_back(std::move(feature));
    }
    write_result_outlines(path, result.grid.crs_wkt, {slopes, traces}, words_of(input.base.spec));
}

}  // namespace frana::app
