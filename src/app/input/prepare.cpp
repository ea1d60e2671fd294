// SPDX-License-Identifier: Apache-2.0
#include "app/input/prepare.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "app/input/check_inputs.h"
#include "app/input/layer_values.h"
#include "app/input/memory_bound.h"
#include "app/input/prepare_inflow.h"
#include "app/input/prepare_structured.h"
#include "app/input/prepare_terrain.h"
#include "app/input/prepare_zones.h"
#include "app/input/used_file.h"
#include "app/text/number_text.h"
#include "core/error.h"
#include "core/text.h"
#include "core/words/words.h"
#include "gis/crs/crs.h"
#include "gis/raster/footprint.h"
#include "gis/vector/vector_in.h"
#include "params/keys/laws.h"
#include "params/keys/output_parameters.h"
#include "params/keys/plausible.h"
#include "params/keys/scene_parameters.h"
#include "params/keys/used_keys.h"
#include "simulation/arrivals.h"
#include "simulation/run_warnings.h"
#include "simulation/scene.h"
#include "simulation/scene_values.h"

namespace frana::app {
namespace {

// A footprint on the grid larger than drawn by this factor gives a warning.
constexpr double k_widened = 1.5;

std::optional<gis::PolygonLayer> read_layer(const SceneReading& reading, const std::string& key,
                                            const std::string& file, const TerrainInput* ground,
                                            std::vector<UsedFile>& files, Findings found, Problems& problems) {
    gis::PolygonLayer layer =
        reading.session.read(gis::read_polygons, file, target_crs(reading, ground), reading.where(key), {});
    found.log.note(key + " " + file + ": " + std::to_string(layer.features.size()) + " features in " + layer.crs_label);
    found.warn_of(key, layer.warnings);
    files.push_back(used_polygons(key == "terrain.walls" ? worded("Walls") : worded("Obstacles"), file, layer));
    if (ground != nullptr) report_transform(key, layer.transform, ground->terrain.grid.cell_size, found);
    if (ground == nullptr || !is_on_ground(reading, key, layer.bounds, *ground, false, problems)) return std::nullopt;
    return layer;
}

/// Sets every cell of a feature to at least `value`; logs how much larger the footprint became if it is thin.
void stamp(const gis::PolygonLayer& layer, std::size_t feature, double value, const std::string& key, Raster& raster,
           CountedTexts& warnings, Problems& problems, const Place& where) {
    const MultiPolygon& parts = layer.features[feature].shape.areas;
    std::int64_t cells = 0;
    gis::visit_cells(parts, raster.grid, gis::Cover::closed, [&](std::int64_t row, std::int64_t column) {
        ++cells;
        raster.at(row, column) = std::max(raster.at(row, column), value);
    });
    const double footprint = static_cast<double>(cells) * raster.grid.cell_area(), drawn = area(parts);
    if (cells == 0) {
        problems.add({feature_name(layer, feature) + " covers no cell", where, grouped(drawn) + " m2", "",
                      "Choose smaller cells"});
    } else if (footprint > k_widened * drawn) {
        warnings.add("narrow", worded("{1}, {3}: feature {2} covers {4} of {5} m2: smaller cells",
                                      {key, std::to_string(feature + 1), layer.layer_name, numeral(grouped(footprint)),
                                       numeral(grouped(drawn))}));
    }
}

void raise_ground(const SceneReading& reading, TerrainInput* ground, std::vector<UsedFile>& files, Findings found,
                  Problems& problems) {
    const TerrainSpec& spec = reading.scene.terrain;
    const std::string key = "terrain.obstacles";
    const auto layer = read_layer(reading, key, *spec.obstacles, ground, files, found, problems);
    if (!layer || !spec.obstacle_height) return;
    Raster height(ground->terrain.grid);
    CountedTexts warnings;
    for (std::size_t f = 0; f < layer->features.size(); ++f) {
        const auto metres = value_of(reading, "terrain.obstacle-height", *spec.obstacle_height, *layer, f, problems);
        if (metres) stamp(*layer, f, *metres, key, height, warnings, problems, reading.where(key));
    }
    for (const Sentence& warning : warnings.texts()) found.warn(warning);
    double most = 0;
    std::int64_t raised = 0;
    height.values.for_each_stored([&](std::size_t cell, double metres) {
        if (!(metres > 0)) return;
        ground->terrain.values[cell] += metres;
        most = std::max(most, metres);
        ++raised;
    });
    if (const auto warning = implausible("terrain.obstacle-height", most)) found.warn(*warning);
    found.log.note("obstacles raise " + grouped(raised) + " cells of the bed by up to " + number_text(most, 4) + " m");
}

/// Reads built structures: raises the ground by terrain.obstacles, and returns 1 where terrain.walls are, on the
/// working grid (none without walls). Adds every problem to `problems`; without terrain (null) files are only checked.
/// Adds the files read to `files`.
std::optional<Raster> prepare_obstacles(const SceneReading& reading, TerrainInput* ground, std::vector<UsedFile>& files,
                                        Findings found, Problems& problems) {
    const TerrainSpec& spec = reading.scene.terrain;
    std::optional<Raster> walls;
    attempt(problems, [&] {
        if (spec.obstacles) raise_ground(reading, ground, files, found, problems);
    });
    attempt(problems, [&] {
        if (!spec.walls) return;
        const std::string key = "terrain.walls";
        const auto layer = read_layer(reading, key, *spec.walls, ground, files, found, problems);
        if (!layer) return;
        walls.emplace(ground->terrain.grid);
        CountedTexts warnings;
        for (std::size_t f = 0; f < layer->features.size(); ++f)
            stamp(*layer, f, 1, key, *walls, warnings, problems, reading.where(key));
        for (const Sentence& warning : warnings.texts()) found.warn(warning);
        std::int64_t cells = 0;
        walls->values.for_each_stored([&](std::size_t, double wall) { cells += wall == 1; });
        found.log.note("walls stand on " + grouped(cells) + " cells");
    });
    return walls;
}

std::optional<gis::PolygonLayer> read_scar(const SceneReading& reading, const TerrainInput* ground,
                                           std::vector<UsedFile>& files, Findings found, Problems& problems) {
    if (!reading.scene.observed.perimeter) return std::nullopt;
    const Place where = reading.where("observed.perimeter");
    return attempt(problems, [&] {
        gis::PolygonLayer layer = reading.session.read(
            gis::read_polygons, *reading.scene.observed.perimeter, target_crs(reading, ground), where,
            layer_choice(reading, reading.scene.observed.perimeter_layer, "observed.perimeter"));
        files.push_back(used_polygons(worded("Observed outline"), *reading.scene.observed.perimeter, layer));
        found.warn_of(worded("Observed outline"), layer.warnings);
        if (ground != nullptr) {
            report_transform(worded("Observed outline"), layer.transform, ground->terrain.grid.cell_size, found);
            is_on_ground(reading, "observed.perimeter", layer.bounds, *ground, true, problems);
        }
        return std::optional(std::move(layer));
    });
}

std::map<std::string, std::string> resolved_choices(const SceneSpec& spec, const TerrainInput& ground,
                                                    const GridSpec& grid) {
    std::map<std::string, std::string> chosen;
    chosen["terrain.crs"] = ground.crs_label;
    chosen["terrain.cell-size"] = shortest_text(grid.cell_size);
    chosen["terrain.bounds"] = extent_text(grid.bounds());
    if (const auto friction = friction_coefficient_of(spec.material))
        chosen["material.friction-coefficient"] = shortest_text(*friction);
    chosen["material.in-plane-stress"] = in_plane_stress(spec.material);
    chosen["numerics.cfl"] = shortest_text(courant_number(spec.numerics, spec.material));
    chosen["numerics.slope-correction"] = word_of(slope_correction(spec.numerics), k_slope_corrections);
    chosen["numerics.curvature"] = curvature(spec.numerics) ? "on" : "off";
    chosen["numerics.flight"] = flight(spec.numerics) ? "on" : "off";
    chosen["numerics.well-balanced"] = well_balanced(spec.numerics) ? "on" : "off";
    chosen["observed.threshold"] = shortest_text(observed_threshold(spec));
    chosen["hazard.minimum-depth"] = shortest_text(hazard_minimum_depth(spec));
    return chosen;
}

/// Refuses files named by a key that no other key of the scene uses.
void refuse_unread_files(const SceneReading& reading, const std::vector<UsedFile>& files, Problems& problems) {
    for (const NamedFile& named : named_files(reading.scene)) {
        const auto same = [&](const UsedFile& used) { return used.path == named.path; };
        if (std::any_of(files.begin(), files.end(), same)) continue;
        problems.add({"names a file that nothing of the scene reads", reading.where(named.key), named.path, "",
                      "Remove the key, or let another key refer to the file"});
    }
}

/// Problems found only by seeding: a wall on the release, a velocity without direction, an inflow over ground without
/// data.
void refuse_what_cannot_start(const Scene& scene) {
    const bool in_motion =
        std::any_of(scene.release.begin(), scene.release.end(), [](const ReleaseArea& area) { return area.speed > 0; });
    if (scene.walls || in_motion || !scene.inflows.empty()) Arrivals(scene, make_release(scene).later);
}

}  // namespace

Prepared prepare(const SceneReading& reading, Findings found) {
    Problems problems = reading.problems;
    for (const Sentence& warning : reading.warnings) found.warn(warning);
    std::optional<TerrainInput> ground = prepare_terrain(reading, found, problems);
    const TerrainInput* known_ground = ground ? &*ground : nullptr;
    std::vector<UsedFile> files;
    if (ground) files.push_back(ground->used);
    std::vector<UsedFile> site;  // listed after the release, but it changes the ground under it
    std::optional<Raster> walls = prepare_obstacles(reading, ground ? &*ground : nullptr, site, found, problems);
    ReleaseInput release = prepare_release(reading, known_ground, files, found, problems);
    files.insert(files.end(), site.begin(), site.end());
    std::vector<Inflow> inflows = prepare_inflow(reading, known_ground, files, found, problems);
    MaterialZones zones = prepare_zones(reading, known_ground, all_outlines(release), files, found, problems);
    std::optional<Raster> forest = prepare_forest(reading, known_ground, files, found, problems);
    std::optional<StructuredMaterial> structured =
        prepare_structured(reading, known_ground, release, walls, files, found, problems);
    std::optional<gis::PolygonLayer> scar = read_scar(reading, known_ground, files, found, problems);
    if (scar && ground)
        question_outline(all_outlines(release), parts_of(scar->features), ground->terrain.grid,
                         reading.where("observed.perimeter"), found);
    ExtraInput extra;
    if (ground) extra = prepare_extra(reading, ground->terrain.grid, files, found, problems);
    problems.throw_if_any();
    if (const HazardSpec& hazard = reading.scene.hazard; hazard.resolved && is_own_file(*hazard.scheme))
        files.push_back(used_data_file(worded("Hazard scheme"), *hazard.scheme, hazard.resolved->called));
    if (const FrictionTableSpec& table = reading.scene.friction_table; table.resolved)
        files.push_back(used_data_file(worded("Friction table"), table.resolved->file, table.resolved->called));
    refuse_unread_files(reading, files, problems);

    Prepared prepared;
    prepared.spec = reading.scene;
    resolve_language(prepared.spec);
    prepared.scene.grid = ground->terrain.grid;
    prepared.scene.terrain = std::exchange(ground->terrain, Raster{});
    set_values(reading.scene, prepared.scene);
    prepared.scene.release = std::exchange(release.areas, {});
    prepared.scene.walls = std::move(walls);
    if (structured && !inflows.empty()) structured->more_fluid = true;
    prepared.scene.inflows = std::move(inflows);
    prepared.scene.zones = std::move(zones);
    prepared.scene.structured = std::move(structured);
    refuse_unused_zones(reading, prepared.scene, problems);
    problems.throw_if_any();
    place_origin(prepared.scene);
    refuse_too_much(reading, prepared.scene, release.area_m2);
    prepared.friction = set_table_friction(reading.scene, std::move(forest), reading.where("material.friction-table"),
                                           prepared.scene, problems);
    problems.throw_if_any();
    if (prepared.friction) found.log.note("friction table: " + friction_text(prepared.friction->choice()).text());
    refuse_what_cannot_start(prepared.scene);
    check_ground_read(reading, *ground, prepared.scene.terrain, found);
    release.ground = ground_of_release(prepared.scene);
    if (release.ground) {
        // What is thrown moves wherever it lands.
        const double friction = reading.scene.release.velocity ? 0 : sure_friction(reading.scene);
        found.warn_all(release_ground_warnings(*release.ground, friction));
    }
    const GridSpec& grid = prepared.scene.grid;
    if (!grid.crs_wkt.empty()) {
        prepared.convergence_deg =
            reading.session.read(gis::meridian_convergence_deg, grid.crs_wkt,
                                 Point{(grid.west + grid.east()) / 2, (grid.south() + grid.north) / 2});
    }
    prepared.resolved = resolved_choices(reading.scene, *ground, grid);
    prepared.files = std::move(files);
    prepared.ground = std::move(*ground);
    prepared.release = std::move(release);
    prepared.scar = std::move(scar);
    prepared.scene.recording.gauges = std::exchange(extra.gauges, {});
    prepared.scene.recording.sections = std::exchange(extra.sections, {});
    // What is of one moment is recorded where somebody uses it.
    if (extra.fragility && extra.fragility->uses(HazardQuantity::momentum)) prepared.scene.recording.intensity = true;
    prepared.extra = std::move(extra);
    prepared.scene.file_volume = prepared.release.file_volume;
    prepared.scene.warnings = std::exchange(found.warnings, {});
    return prepared;
}

Prepared prepare(const SceneReading& reading, RunLog& log) {
    Warnings found;
    return prepare(reading, {log, found});
}

std::vector<std::string> left_at_default(const Prepared& prepared) {
    std::vector<std::string> left;
    for (const Parameter& key : scene_parameters()) {
        const std::string name = key.name();
        const auto chosen = prepared.resolved.find(name);
        const bool is_chosen = chosen != prepared.resolved.end();
        if (!key.decides_map || prepared.spec.origin_of(name) != frana::Origin::default_value ||
            !is_used(prepared.spec, key, is_chosen))
            continue;
        left.push_back(name + " = " + (is_chosen ? chosen->second : key.write(prepared.spec).value_or("")) +
                       (key.unit.empty() ? "" : " " + key.unit));
    }
    return left;
}

Prepared prepare(const SceneReading& reading, const std::optional<Problem>& place, Findings found) {
    if (!place) return prepare(reading, found);
    try {
        (void)prepare(reading, found);
    } catch (const Error& error) {
        std::vector<Problem> all = error.problems();
        all.push_back(*place);
        throw Error(error.kind(), all);
    }
    throw Error(ErrorKind::environment, *place);
}

}  // namespace frana::app
