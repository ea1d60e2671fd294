// SPDX-License-Identifier: Apache-2.0
#include "facade/inside.h"

#include <dlfcn.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "analysis/gaussian_field.h"
#include "analysis/ground_statistics.h"
#include "analysis/touched_cells.h"
#include "analysis/trace.h"
#include "core/error.h"
#include "core/text.h"
#include "params/keys/material_parameters.h"
#include "params/keys/scene_spec.h"
#include "params/keys/zone_keys.h"
#include "params/scene/read_scene.h"
#include "simulation/arrivals.h"
#include "simulation/release.h"
#include "simulation/run_check.h"
#include "simulation/run_warnings.h"
#include "simulation/scene.h"
#include "simulation/scene_values.h"

namespace frana::facade {
namespace {

std::string name_of(const Release& release, std::size_t index) {
    return "release " + (release.name.empty() ? std::to_string(index + 1) : release.name);
}

MultiPolygon outline_of(const Release& release, const GridSpec& grid) {
    if (release.outline.empty() && !release.thicknesses.empty())
        return outlines_where_positive(grid, release.thicknesses.cells);
    return area_of(release.outline);
}

bool check_outline(const MultiPolygon& outline, const GridSpec& grid, const Place& where, Problems& problems) {
    for (const frana::Polygon& polygon : outline) {
        const bool finite = std::all_of(polygon.outer.begin(), polygon.outer.end(),
                                        [](const frana::Point& p) { return std::isfinite(p.x) && std::isfinite(p.y); });
        if (finite && polygon.outer.size() >= 3 && area(polygon) > 0) continue;
        problems.add({"has an outline without area", where, "", "", "Give at least three points that are not in line"});
        return false;
    }
    const Bounds box = bounds(outline), map = grid.bounds();
    if (is_within(box, map)) return true;
    problems.add({"reaches beyond the terrain", where, extent_text(box), extent_text(map),
                  "Check the coordinates of both, or give a larger terrain"});
    return false;
}

/// A number of the scene by the rule of the key that gives it in a file.
bool check_number(const std::string& key, double value, const Place& where, Problems& problems) {
    std::optional<frana::Problem> problem = problem_of_key(key, shortest_text(value));
    if (!problem) return true;
    problem->where = where;
    problems.add(*problem);
    return false;
}

bool check_thicknesses(std::span<const double> cells, const Place& where, Problems& problems) {
    double least = 0, greatest = 0;
    for (const double t : cells) {
        if (t < least) least = t;
        if (t > greatest) greatest = t;
    }
    if (least < 0) {
        problems.add({"the thickness is negative", where, shortest_text(least) + " m", "0 or more",
                      "The difference after minus before has the wrong sign; where there is no data give NaN"});
    } else if (!(greatest > 0)) {
        problems.add({"nothing is released: the thickness is nowhere positive", where, "", "", "Check its cells"});
    } else {
        if (greatest > k_most_thickness) check_thickness(greatest, where, problems);
        return greatest <= k_most_thickness;
    }
    return false;
}

/// The areas that fail, checked. Cells without outline get one; thicknesses by cells have the volume of the cells.
std::vector<ReleaseArea> release_areas(const Scene::Data& data, const SceneSpec& spec, const GridSpec& grid,
                                       Problems& problems) {
    std::vector<ReleaseArea> areas;
    if (data.release.empty() && data.inflows.empty())
        problems.add({"nothing is released", "scene", "", "", "Add an area of release or an inflow"});
    for (std::size_t i = 0; i < data.release.size(); ++i) {
        const Release& release = data.release[i];
        const Place where = name_of(release, i);
        ReleaseArea own;
        own.name = release.name;
        own.volume = release.volume;
        set_uniform_details(spec.release, own);
        if (release.volume && release_volume_of(spec.release))
            problems.add({"contradicts release.volume, the volume of all areas", where + ": volume",
                          shortest_text(*release.volume) + " m3", "", "Keep one of the two"});
        const bool has_volume =
            release.volume && check_number("release.volume", *release.volume, where + ": volume", problems);
        if (release.thicknesses.empty()) {
            if (check_number("release.thickness", release.thickness, where, problems))
                check_thickness(release.thickness, where, problems);
            own.thickness = release.thickness;
        } else if (check_thicknesses(release.thicknesses.cells, where, problems)) {
            own.thickness_raster = raster_in_place(grid, release.thicknesses);
        } else {
            continue;
        }
        own.outline = outline_of(release, grid);
        if (own.outline.empty()) problems.add({"has no outline", where, "", "", "Give one, or thicknesses by cell"});
        if (own.outline.empty() || !check_outline(own.outline, grid, where, problems)) continue;
        if (has_volume) check_thickness(*release.volume / area(own.outline), where + ": volume", problems);
        check_particle_count(area(own.outline) * spec.numerics.particles_per_cell / grid.cell_area(), where, problems);
        if (own.thickness_raster && !own.volume && !spec.release.volume && !own.normal_to_bed) {
            // Interpolated at its edge, a raster would lose volume.
            const MultiPolygon local = moved(own.outline, [&](frana::Point p) { return grid.local_from_map(p); });
            if (const double volume = volume_in_cells(*own.thickness_raster, grid.cell_size, local); volume > 0)
                own.volume = volume;
        }
        areas.push_back(std::move(own));
    }
    return areas;
}

/// Returns the greatest of the values of a key by place. All must be in its range.
template <class Key>
double greatest_of(const Values& values, const Key& key, Problems& problems) {
    double greatest = -HUGE_VAL;
    for (const double value : values.cells) {
        if (std::isnan(value)) continue;
        greatest = std::max(greatest, value);
        if (key.range.has(value)) continue;
        problems.add({"is out of range", key.name, shortest_text(value) + " " + key.unit, key.range.text(),
                      "NaN where the value of the material applies"});
        break;
    }
    return greatest;
}

/// Gives the solids their values by place, in the units of the engine. Only those in cells that the release touches
/// are ever used; there each must be known.
void add_solids_by_place(const Scene::Data& data, const SceneSpec& spec, const std::vector<ReleaseArea>& release,
                         const GridSpec& grid, StructuredMaterial& material, Problems& problems) {
    std::vector<std::size_t> released;
    for (const ReleaseArea& area : release)
        for (const std::size_t cell : touched_cells({area.outline, {}, {}}, grid)) released.push_back(cell);
    for (const SolidKey& key : solid_keys()) {
        const bool is_instead =
            data.by_place.count(key.name) == 0 && !key.instead.empty() && !(spec.structured.*key.source);
        const auto found = data.by_place.find(is_instead ? key.instead : key.name);
        if (found == data.by_place.end()) continue;
        if (!is_instead) (void)greatest_of(found->second, key, problems);
        const bool is_known = (spec.structured.*key.in_use(spec.structured).source).has_value();
        frana::Raster raster(grid, k_no_data);
        for (const std::size_t cell : released) {
            const double value = found->second.cells[cell];
            raster.values[cell] = key.degrees() ? tangent_of(value) : value;
            if (!std::isnan(value) || is_known) continue;
            problems.add({"has no value on part of the release", found->first, "", "",
                          "Give values on all of it, or set the key as well"});
            break;
        }
        material.zones.push_back({key.value, std::move(raster)});
    }
}

/// Puts free fluid on the ground at the start: by place, or as deep everywhere.
void add_initial_fluid(const Scene::Data& data, const SceneSpec& spec, const GridSpec& grid,
                       StructuredMaterial& material, Problems& problems) {
    const auto found = data.by_place.find(k_initial_fluid);
    const bool by_place = found != data.by_place.end();
    const auto& uniform = spec.structured.initial_fluid_depth;
    if (!by_place && !(uniform && uniform->number > 0)) return;
    material.initial_fluid.emplace(grid, k_no_data);
    material.more_fluid = true;
    double least = 0, greatest = 0;
    for (std::size_t cell = 0; cell < data.elevations.cells.size(); ++cell) {
        const double depth = by_place ? found->second.cells[cell] : uniform->number;
        const bool is_wall = !data.walls.empty() && data.walls.cells[cell] == 1;
        if (std::isnan(depth) || depth == 0 || std::isnan(data.elevations.cells[cell]) || is_wall) continue;
        least = std::min(least, depth);
        greatest = std::max(greatest, depth);
        material.initial_fluid->values[cell] = depth;
    }
    if (check_number(k_initial_fluid, least, k_initial_fluid, problems))
        check_number(k_initial_fluid, greatest, k_initial_fluid, problems);
}

/// The structured model's material, where that is the scene's model. Needs release and inflows.
std::optional<StructuredMaterial> structured_material(const Scene::Data& data, const SceneSpec& spec,
                                                      const frana::Scene& scene, Warnings& warnings,
                                                      Problems& problems) {
    std::optional<StructuredMaterial> material = structured_of(spec);
    for (const auto& [key, values] : data.by_place)
        if (key.starts_with("structured.") && !(material && (material->solids || key == k_initial_fluid)))
            problems.add({"gives a property of what the scene does not have", key, "", "",
                          "Set material.model = structured and structured.phases = solids-and-fluid"});
    if (!material) return material;
    material->more_fluid = material->more_fluid || !scene.inflows.empty();
    if (material->solids) add_solids_by_place(data, spec, scene.release, scene.grid, *material, problems);
    add_initial_fluid(data, spec, scene.grid, *material, problems);
    if (!problems.empty()) return material;
    const auto where = [](const std::string& key) { return key; };
    for (const frana::Problem& problem : structured_problems(*material, scene.grid.cell_size, where))
        problems.add(problem);
    double thickest = 0;
    for (const Release& release : data.release) {
        if (release.thicknesses.empty()) thickest = std::max(thickest, release.thickness);
        for (const double thickness : release.thicknesses.cells)
            if (thickness > thickest) thickest = thickness;
    }
    const auto is_given = [&](const std::string& key) {
        return data.by_place.count(key) > 0 ||
               std::any_of(data.keys.begin(), data.keys.end(), [&](const auto& given) { return given.first == key; });
    };
    if (material->solids) warnings += structured_warnings(*material, thickest, scene.grid.cell_size, where, is_given);
    return material;
}

/// The values of [zones], checked, in the units of the engine.
MaterialZones material_zones(const Scene::Data& data, const SceneSpec& spec, const GridSpec& grid, Problems& problems) {
    MaterialZones zones;
    for (const ZoneKey& key : zone_keys()) {
        const auto found = data.by_place.find(key.name);
        if (found == data.by_place.end()) continue;
        const Values& values = found->second;
        check_zone_use(key, spec, key.name, problems);
        const double greatest = greatest_of(values, key, problems);
        if (key.what == "friction") check_zone_friction(spec, key.stored(greatest), key.name, problems);
        std::optional<frana::Raster>& target = zones.*raster_of(key);
        if (target)
            problems.add({"contradicts another key of [zones]: both give the " + key.what, key.name, "", "",
                          "Keep one of the two"});
        const Change to_tangents = [](const CellWindow& window, double* of) {
            for (std::int64_t cell = 0; cell < window.rows * window.columns; ++cell) of[cell] = tangent_of(of[cell]);
        };
        target = raster_in_place(grid, values, key.degrees() ? to_tangents : Change());
    }
    return zones;
}

/// The points of a line; a problem and false if they make none.
bool take_line(const std::vector<Point>& points, const Place& where, Polyline& line, Problems& problems) {
    for (const Point& p : points) line.push_back({p.x, p.y});
    const bool finite = std::all_of(points.begin(), points.end(),
                                    [](const Point& p) { return std::isfinite(p.x) && std::isfinite(p.y); });
    if (finite && points.size() >= 2) return true;
    problems.add({"has no line", where, std::to_string(points.size()) + " points", "2 or more, finite",
                  "Give the points of a line"});
    return false;
}

/// The inflows, checked as frana run checks those of files; where they lie on the ground is checked by the engine.
std::vector<frana::Inflow> inflows_of(const Scene::Data& data, const SceneSpec& spec, Problems& problems) {
    constexpr double k_turn = 360;
    std::vector<frana::Inflow> inflows;
    for (std::size_t i = 0; i < data.inflows.size(); ++i) {
        const Inflow& inflow = data.inflows[i];
        const Place where = "inflow " + std::to_string(i + 1);
        frana::Inflow own;
        if (inflow.direction) {
            if (!(*inflow.direction >= 0 && *inflow.direction <= k_turn))
                problems.add({"is out of range", where + ": direction", shortest_text(*inflow.direction) + " degrees",
                              "0 to " + shortest_text(k_turn), "Count clockwise from north"});
            own.azimuth = *inflow.direction * std::numbers::pi / 180;
        }
        if (!take_line(inflow.line, where, own.line, problems)) continue;
        const double length = length_of(own.line);
        for (const HydrographPoint& point : inflow.hydrograph) {
            const double critical = critical_speed(spec.numerics.gravity, point.discharge, length);
            own.hydrograph.push_back({point.time, point.discharge, point.velocity.value_or(critical)});
        }
        if (check_hydrograph(own.hydrograph, where, problems)) inflows.push_back(std::move(own));
    }
    return inflows;
}

/// Refuses inflows with more particles than can be counted. Needs the grid, the numerics and the end of the scene.
void check_inflow_counts(const frana::Scene& scene, Problems& problems) {
    for (std::size_t i = 0; i < scene.inflows.size(); ++i)
        check_particle_count(particles_of(scene.inflows[i], lattice_spacing(scene), scene.time.end),
                             "inflow " + std::to_string(i + 1), problems);
}

/// Their names, of which each has its own; one without is numbered.
template <class Recorded>
std::vector<std::string> names_of(const std::vector<Recorded>& list, const Place& where, Problems& problems) {
    std::vector<std::string> names;
    for (const Recorded& one : list) names.push_back(one.name.empty() ? std::to_string(names.size() + 1) : one.name);
    check_names(names, where, problems);
    return names;
}

/// The gauges and cross-sections, checked as frana run checks those of files.
void add_recorded(const Scene::Data& data, const GridSpec& grid, Recording& recording, Problems& problems) {
    const auto gauges = names_of(data.gauges, "gauges", problems);
    for (std::size_t i = 0; i < gauges.size(); ++i) {
        const Point& place = data.gauges[i].place;
        recording.gauges.push_back({gauges[i], {place.x, place.y}});
        check_inside({recording.gauges.back().place}, grid, "gauge " + gauges[i], "gauges", problems);
    }
    const auto sections = names_of(data.sections, "cross-sections", problems);
    for (std::size_t i = 0; i < sections.size(); ++i) {
        const std::string name = "cross-section " + sections[i];
        frana::CrossSection& own = recording.sections.emplace_back(frana::CrossSection{sections[i], {}});
        if (take_line(data.sections[i].line, name, own.line, problems))
            check_inside(own.line, grid, name, "cross-sections", problems);
    }
}

namespace fs = std::filesystem;

/// Returns the folder of presets, hazard schemes and friction tables: FRANA_SHARE, else the one installed with this
/// library. Throws Error(environment) if there is none.
std::string share_directory() {
    if (const char* named = std::getenv("FRANA_SHARE"); named != nullptr && *named != '\0') return named;
    // PREFIX/lib/libfrana.so, PREFIX/lib/x86_64-linux-gnu/libfrana.so, PREFIX/lib/python3/dist-packages/frana/...
    Dl_info here{};
    std::error_code error;
    if (dladdr(reinterpret_cast<const void*>(&share_directory), &here) != 0 && here.dli_fname != nullptr) {
        const fs::path library = fs::canonical(here.dli_fname, error);
        for (fs::path folder = library.parent_path(); folder.has_relative_path(); folder = folder.parent_path())
            for (const char* share : {"share/frana", "share"})
                if (fs::is_directory(folder / share / "materials", error)) return (folder / share).string();
    }
    throw frana::Error(ErrorKind::environment, frana::Problem{"the share folder with the material presets is missing",
                                                              here.dli_fname == nullptr ? "frana" : here.dli_fname, "",
                                                              "", "Set FRANA_SHARE to it"});
}

/// Keys of scene files for which a scene in memory has values.
std::vector<std::string> given_otherwise(const Scene::Data& data) {
    std::vector<std::string> given{"terrain.dtm", "release.thickness", "release.perimeter"};
    if (!data.inflows.empty()) given.insert(given.end(), {"inflow.line", "inflow.hydrograph"});
    if (!data.gauges.empty()) given.emplace_back("output.gauges");
    if (!data.sections.empty()) given.emplace_back("output.cross-sections");
    for (const auto& [key, values] : data.by_place) given.push_back(key);
    return given;
}

SceneReading read_keys(const Scene::Data& data) {
    std::vector<std::string> keys;
    bool needs_share = false;
    for (const auto& [key, value] : data.keys) {
        keys.push_back(key + "=" + value);
        needs_share =
            needs_share || key == "material.preset" || key == "material.friction-table" || key == "hazard.scheme";
    }
    return read_scene_keys(keys, given_otherwise(data), needs_share ? share_directory() : std::string(), "scene");
}

std::string metres(double value) {
    return shortest_text(value) + " m";
}

void check_elevations(const Values& elevations, Warnings& warnings, Problems& problems) {
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

/// As frana run counts them: the cells whose centres the outlines contain.
std::optional<GroundStatistics> ground_of_release(const frana::Scene& scene) {
    GroundSum sum(scene.terrain);
    const GridSpec& grid = scene.grid;
    const auto cell = [&](double distance) { return static_cast<std::int64_t>(std::floor(distance / grid.cell_size)); };
    for (const ReleaseArea& area : scene.release) {
        const InsideTest inside(area.outline);
        const Bounds box = bounds(area.outline);
        for (std::int64_t row = cell(grid.north - box.north); row <= cell(grid.north - box.south); ++row)
            for (std::int64_t column = cell(box.west - grid.west); column <= cell(box.east - grid.west); ++column)
                if (inside(grid.cell_centre(row, column))) sum.add(row, column);
    }
    return sum.statistics();
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
    const SceneSpec& spec = prepared.spec;
    frana::Scene& scene = prepared.scene;
    scene.warnings.assign(reading.warnings.begin(), reading.warnings.end());
    scene.grid = spec_of(data.grid);
    check_elevations(data.elevations, scene.warnings, problems);
    scene.terrain = terrain_of(data, spec, scene.grid);
    scene.walls = walls_of(data.walls, scene.grid, problems);
    set_values(spec, scene);
    scene.release = release_areas(data, spec, scene.grid, problems);
    scene.inflows = inflows_of(data, spec, problems);
    add_recorded(data, scene.grid, scene.recording, problems);
    scene.zones = material_zones(data, spec, scene.grid, problems);
    scene.structured = structured_material(data, spec, scene, scene.warnings, problems);
    check_inflow_counts(scene, problems);
    problems.throw_if_any();
    place_origin(scene);
    (void)set_table_friction(spec, std::nullopt, "material.friction-table", scene, problems);
    problems.throw_if_any();
    prepared.release_ground = ground_of_release(scene);
    // What is thrown moves wherever it lands.
    const bool may_be_held = !spec.release.velocity && !scene.zones.friction_coefficient;
    if (prepared.release_ground)
        scene.warnings += release_ground_warnings(*prepared.release_ground, may_be_held ? sure_friction(spec) : 0);
    return prepared;
}

}  // namespace frana::facade
