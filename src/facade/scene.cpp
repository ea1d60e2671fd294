// SPDX-License-Identifier: Apache-2.0
#include "facade/inside.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "core/text.h"
#include "params/grammar/value_text.h"
#include "params/keys/material_parameters.h"
#include "params/keys/parameter.h"
#include "params/keys/scene_parameters.h"
#include "params/keys/zone_keys.h"
#include "params/scene/read_scene.h"
#include "simulation/arrivals.h"
#include "simulation/release.h"

namespace frana::facade {
namespace {

/// What the engine computes with; all other keys tell the program where to read, what to write and how to draw.
constexpr const char* k_sections[] = {"material", "structured", "entrainment", "numerics", "time"};
constexpr const char* k_keys[] = {"terrain.nodata-policy",
                                  "terrain.error",
                                  "release.thickness-direction",
                                  "release.dtm-contains-release",
                                  "release.volume",
                                  "release.start",
                                  "release.velocity",
                                  "release.direction",
                                  "output.trace-threshold",
                                  "output.sample-interval"};
/// A search over sizes of cells, each read from the files.
constexpr const char* k_not[] = {"numerics.accuracy"};

template <class List>
bool is_in(const List& list, const std::string& word) {
    return std::find(std::begin(list), std::end(list), word) != std::end(list);
}

const char* remedy_for(const std::string& section, const std::string& name) {
    if (section == "terrain") return "The scene has its terrain from the values it was made of; remove the key";
    if (section == "release") return "Give it with the area of release";
    if (section == "inflow") return "Add an inflow to the scene";
    if (name == "output.gauges") return "Add gauges to the scene";
    if (name == "output.cross-sections") return "Add cross-sections to the scene";
    if (section == "zones") return "Give one value for each cell of the grid";
    return "Remove the key";
}

}  // namespace

std::optional<frana::Problem> problem_of_setting(const std::string& key, const std::string& value) {
    if (auto problem = problem_of_key(key, value)) return problem;
    const std::vector<Parameter>& parameters = scene_parameters();
    const Parameter& parameter = *find_parameter(parameters, present_name(key));
    const std::string name = parameter.name();
    if ((!is_in(k_sections, parameter.section) && !is_in(k_keys, name)) || is_in(k_not, name)) {
        return frana::Problem{"is not for a scene in memory: it says how the program frana reads and writes files", key,
                              value, "", remedy_for(parameter.section, name)};
    }
    if (name == "terrain.nodata-policy" && value == "fill") {
        return frana::Problem{"is not for a scene in memory, whose elevations are not changed", key, value,
                              "stop, wall", "Fill the values before the scene is made"};
    }
    bool names_file = false;
    if (parameter.reads_files()) {
        SceneSpec scene;
        parameter.read(scene, value);
        parameter.map_files(scene, [&](const std::string& path) {
            names_file = true;
            return path;
        });
    }
    if (!names_file) return std::nullopt;
    return frana::Problem{"names a file, and a scene in memory reads none", key, value, "", "Give a number"};
}

GridSpec spec_of(const Grid& grid) {
    GridSpec spec;
    spec.west = grid.west;
    spec.north = grid.north;
    spec.cell_size = grid.cell_size;
    spec.columns = grid.columns;
    spec.rows = grid.rows;
    return spec;
}

frana::Raster raster_in_place(const GridSpec& grid, const Values& values, const Change& change) {
    frana::Raster raster;
    raster.grid = grid;
    raster.values = CellValues::tiled(grid.rows, grid.columns, k_no_data,
                                      [values, change, columns = grid.columns](const CellWindow& window, double* to) {
                                          double* next = to;
                                          for (std::int64_t row = window.row; row < window.row + window.rows; ++row)
                                              next = std::copy_n(values.cells.data() + row * columns + window.column,
                                                                 window.columns, next);
                                          if (change) change(window, to);
                                      });
    return raster;
}

namespace {

std::string size_text(std::int64_t rows, std::int64_t columns) {
    return std::to_string(rows) + " x " + std::to_string(columns);
}

void require_grid(const Grid& grid) {
    constexpr std::int64_t k_most_side = 1'000'000;
    const auto side = [](std::int64_t cells) { return cells >= 1 && cells <= k_most_side; };
    if (!side(grid.rows) || !side(grid.columns))
        refuse({"is out of range", "grid: rows, columns", size_text(grid.rows, grid.columns),
                "1 to " + std::to_string(k_most_side), "Give the shape of the elevations"});
    if (!std::isfinite(grid.cell_size) || !(grid.cell_size > 0))
        refuse({"is out of range", "grid: cell size", shortest_text(grid.cell_size) + " m", "greater than 0",
                "Give the side of a cell in metres"});
    if (!std::isfinite(grid.west) || !std::isfinite(grid.north))
        refuse({"is not finite", "grid: west, north", shortest_text(grid.west) + ", " + shortest_text(grid.north), "",
                "Give the coordinates of the north-western corner"});
}

void require_size(const Grid& grid, const Values& values, const std::string& what) {
    if (values.cells.size() == static_cast<std::size_t>(grid.rows * grid.columns)) return;
    refuse({"does not have one value for each cell", what, std::to_string(values.cells.size()) + " values",
            size_text(grid.rows, grid.columns) + " cells", "Give values on the scene's grid"});
}

}  // namespace

Scene::Scene(const Grid& grid, Values elevations) : data_(std::make_unique<Data>()) {
    require_grid(grid);
    require_size(grid, elevations, "elevations");
    data_->grid = grid;
    data_->elevations = std::move(elevations);
}

Scene::Scene(const Scene& other) : data_(std::make_unique<Data>(*other.data_)) {}
Scene::Scene(Scene&& other) noexcept = default;
Scene& Scene::operator=(const Scene& other) {
    if (this != &other) data_ = std::make_unique<Data>(*other.data_);
    return *this;
}
Scene& Scene::operator=(Scene&& other) noexcept = default;
Scene::~Scene() = default;

const Grid& Scene::grid() const noexcept {
    return data_->grid;
}

void Scene::set(const std::string& key, const std::string& value) {
    if (const auto problem = problem_of_setting(key, value)) refuse(*problem);
    const std::string name = present_name(key);
    std::erase_if(data_->keys, [&](const auto& given) { return given.first == name; });
    data_->keys.emplace_back(name, value);
}

void Scene::set(const std::string& key, double value) {
    set(key, shortest_text(value));
}

void Scene::set_values(const std::string& key, Values values) {
    std::vector<std::string> names{k_initial_fluid};
    for (const ZoneKey& zone : zone_keys()) names.push_back(zone.name);
    for (const SolidKey& solid : solid_keys()) names.push_back(solid.name);
    if (!is_in(names, key))
        refuse({"is no key whose value varies from place to place", key, "", joined(names, ", "), ""});
    require_size(data_->grid, values, key);
    data_->by_place[key] = std::move(values);
}

void Scene::set_walls(Values walls) {
    require_size(data_->grid, walls, "walls");
    data_->walls = std::move(walls);
}

void Scene::add_release(Release release) {
    if (!release.thicknesses.empty()) require_size(data_->grid, release.thicknesses, "release: thicknesses");
    data_->release.push_back(std::move(release));
}

void Scene::add_inflow(Inflow inflow) {
    data_->inflows.push_back(std::move(inflow));
}

void Scene::add_gauge(Gauge gauge) {
    data_->gauges.push_back(std::move(gauge));
}

void Scene::add_section(CrossSection section) {
    data_->sections.push_back(std::move(section));
}

std::vector<std::string> Scene::check() const {
    return guarded([&] {
        EngineScene prepared = prepare_scene(*data_);
        // What is found only by placing the mass.
        const frana::Release release = make_release(prepared.scene);
        const Arrivals arrivals(prepared.scene, release.later);
        return texts_of(prepared.scene.warnings);
    });
}

}  // namespace frana::facade
