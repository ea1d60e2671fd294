// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/ground_statistics.h"
#include "core/error.h"
#include "core/raster.h"
#include "core/text.h"
#include "facade/frana.h"
#include "params/keys/scene_spec.h"
#include "simulation/result.h"
#include "simulation/scene.h"

namespace frana::facade {

inline std::vector<Problem> problems_of(const std::vector<frana::Problem>& problems) {
    std::vector<Problem> list;
    for (const frana::Problem& p : problems) list.push_back({p.what, p.where, p.value, p.limit, p.remedy});
    return list;
}

/// Calls what may throw the engine's errors; its users get those of the interface.
template <class Work>
auto guarded(const Work& work) {
    try {
        return work();
    } catch (const frana::Error& error) {
        throw Error(error.what(), problems_of(error.problems()));
    }
}

[[noreturn]] inline void refuse(const frana::Problem& problem) {
    throw Error(describe(problem), problems_of({problem}));
}

/// Returns why a key with this value is not for a scene in memory: an unknown key, a value that is not allowed, a file,
/// or what concerns only the files that the program reads and writes. None: it is.
std::optional<frana::Problem> problem_of_setting(const std::string& key, const std::string& value);

GridSpec spec_of(const Grid& grid);

inline std::vector<frana::Point> points_of(const std::vector<Point>& points) {
    std::vector<frana::Point> own;
    for (const Point& p : points) own.push_back({p.x, p.y});
    return own;
}

inline MultiPolygon area_of(const std::vector<Polygon>& polygons) {
    MultiPolygon area;
    for (const Polygon& polygon : polygons) {
        frana::Polygon& own = area.emplace_back();
        own.outer = points_of(polygon.outer);
        for (const Ring& hole : polygon.holes) own.holes.push_back(points_of(hole));
    }
    return area;
}

/// Changes the values of a window, row by row.
using Change = std::function<void(const CellWindow& window, double* values)>;

/// A raster whose cells are read from values where and when they are asked for; `change` makes them the engine's.
frana::Raster raster_in_place(const GridSpec& grid, const Values& values, const Change& change = {});

struct Scene::Data {
    Grid grid;
    Values elevations;
    std::vector<std::pair<std::string, std::string>> keys;  ///< in the order of their last setting
    std::map<std::string, Values> by_place;                 ///< keys of [zones] and [structured]
    Values walls;
    std::vector<Release> release;
    std::vector<Inflow> inflows;
    std::vector<Gauge> gauges;
    std::vector<CrossSection> sections;
};

/// Key of the depth of free fluid at the start, a number or by place.
inline constexpr const char* k_initial_fluid = "structured.initial-fluid-depth";

/// Refuses more particles than the engine can number with 32 bits.
inline void check_particle_count(double count, const Place& where, Problems& problems) {
    constexpr double k_most_particles = 1e9;
    if (count <= k_most_particles) return;
    problems.add({"would need more particles than can be counted", where, shortest_text(count),
                  "at most " + shortest_text(k_most_particles), "Choose larger cells"});
}

/// What the engine runs.
struct EngineScene {
    SceneSpec spec;
    frana::Scene scene;
    std::optional<GroundStatistics> release_ground;
};

/// Throws the engine's Error(input) with every problem of the scene, in the words of scene files.
EngineScene prepare_scene(const Scene::Data& data);

struct Result::Data {
    RunResult result;
    Grid grid;
    Recording recording;  ///< of which the result has rows
    std::string summary;  ///< JSON
    std::vector<std::string> warnings;
};

struct Frame::Data {
    frana::Frame frame;
    Grid grid;
};

std::shared_ptr<const Result::Data> result_data(RunResult result, const EngineScene& prepared, const Grid& grid);

}  // namespace frana::facade
