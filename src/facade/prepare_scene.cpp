// SPDX-License-Identifier: Apache-2.0
#include "facade/prepare_scene.h"

#include <algorithm>
#include <cmath>

#include "analysis/gaussian_field.h"
#include "analysis/terrain_sanity.h"
#include "core/error.h"
#include "core/shortest_text.h"
#include "facade/prepare_areas.h"
#include "facade/prepare_inflows.h"
#include "facade/prepare_recording.h"
#include "facade/presets.h"
#include "facade/values_in_place.h"
#include "params/scene/read_keys.h"
#include "simulation/scene_origin.h"
#include "simulation/scene_values.h"
#include "simulation/structured_check.h"

namespace frana::facade {
namespace {

/// Keys of scene files for which a scene in memory has values.
std::vector<std::string> given_otherwise(const Scene::Data& data) {
    std::vector<std::string> given{"terrain.dtm", "release.thickness", "release.perimeter"};
    if (!data.inflows.empty()) given.insert(given.end(), {"inflow.line", "inflow.hydrograph"});
    if (!data.gauges.empty()) given.emplace_back("output.gauges");
    if (!data.sections.empty()) given.emplace_back("output.cross-sections");
    return given;
}

SceneReading read_keys(const Scene::Data& data) {
    std::vector<std::string> keys;
    bool preset = false;
    for (const auto& [key, value] : data.keys) {
        keys.push_back(key + "=" + value);
        preset = preset || key == "material.preset";
    }
    return read_scene_keys(keys, given_otherwise(data), preset ? presets_directory() : std::string(), "scene");
}

std::string metres(double value) {
    return shortest_text(value) + " m";
}

void check_elevations(const Values& elevations, std::vector<std::string>& warnings, Problems& problems) {
    double lowest = HUGE_VAL, highest = -HUGE_VAL;
    for (const double z : elevations.cells) {
        if (std::isnan(z)) continue;
        lowest = std::min(lowest, z);
        highest = std::max(highest, z);
    }
    if (lowest > highest) {
        problems.add({"has no elevation anywhere", "elevations", "", "", "NaN is no data; give metres elsewhere"});
        return;
    }
    const double extreme = highest > -lowest ? highest : lowest;
    if (std::abs(extreme) > k_impossible_elevation) {
        problems.add({"contains an impossible elevation", "elevations", metres(extreme),
                      shortest_text(-k_impossible_elevation) + " to " + metres(k_impossible_elevation),
                      "Where there is no data give NaN; give metres elsewhere"});
        return;
    }
    if (highest > k_highest_ground)
        warnings.push_back("the highest elevation is " + metres(highest) +
                           ", higher than any mountain. Where there is no data give NaN; give metres elsewhere");
    if (lowest < k_lowest_ground)
        warnings.push_back("the lowest elevation is " + metres(lowest) +
                           ", lower than any dry ground. Where there is no data give NaN; give metres elsewhere");
}

frana::Raster terrain_of(const Scene::Data& data, const SceneSpec& spec, const GridSpec& grid) {
    if (!spec.terrain.error) return raster_in_place(grid, data.elevations);
    const GaussianField field{spec.terrain.error->standard_deviation, spec.terrain.error->range,
                              spec.terrain.error->seed};
    return raster_in_place(grid, data.elevations, [field, grid](const CellWindow& window, double* values) {
        add_field(field, grid, window, values);
    });
}

std::optional<frana::Raster> walls_of(const Values& values, const GridSpec& grid, Problems& problems) {
    if (values.empty()) return std::nullopt;
    frana::Raster walls(grid);
    for (std::size_t cell = 0; cell < values.cells.size(); ++cell) {
        const double wall = values.cells[cell];
        if (wall == 0) continue;
        if (wall != 1) {
            problems.add({"is neither a wall nor none", "walls", shortest_text(wall), "0, 1", "Give 1 for walls"});
            break;
        }
        walls.values[cell] = 1;
    }
    return walls;
}

}  // namespace

EngineScene prepare_scene(const Scene::Data& data) {
    const SceneReading reading = read_keys(data);
    Problems problems = reading.problems;
    EngineScene prepared;
    prepared.spec = reading.scene;
    prepared.warnings = texts_of(reading.warnings);
    const SceneSpec& spec = prepared.spec;
    frana::Scene& scene = prepared.scene;
    scene.grid = spec_of(data.grid);
    check_elevations(data.elevations, prepared.warnings, problems);
    scene.terrain = terrain_of(data, spec, scene.grid);
    scene.walls = walls_of(data.walls, scene.grid, problems);
    scene.terrain_contains_release = spec.release.dtm_contains_release;
    scene.release = release_areas(data, spec, scene.grid, problems);
    scene.release_volume = release_volume_of(spec.release);
    scene.inflows = inflows_of(data, spec, problems);
    scene.recording = recording_of(data, spec, scene.grid, problems);
    scene.material = material_of(spec.material);
    scene.zones = material_zones(data, spec, scene.grid, problems);
    scene.structured = structured_of(spec);
    if (scene.structured) scene.structured->more_fluid = !scene.inflows.empty();
    if (scene.structured)
        for (const frana::Problem& problem :
             structured_problems(*scene.structured, [](const std::string& key) { return key; }))
            problems.add(problem);
    scene.entrainment = entrainment_of(spec.entrainment);
    scene.numerics = numerics_of(spec);
    scene.time = time_of(spec);
    check_inflow_counts(scene, problems);
    problems.throw_if_any();
    place_origin(scene);
    return prepared;
}

}  // namespace frana::facade
