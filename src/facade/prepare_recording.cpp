// SPDX-License-Identifier: Apache-2.0
#include "facade/prepare_recording.h"

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "core/shortest_text.h"
#include "params/keys/scene_spec.h"

namespace frana::facade {
namespace {

/// Refuses a place that no cell contains; NaN too.
void check_inside(const std::vector<Point>& places, const std::string& where, const GridSpec& grid,
                  Problems& problems) {
    const Bounds map = grid.bounds();
    for (const Point& p : places) {
        if (p.x >= map.west && p.x <= map.east && p.y >= map.south && p.y <= map.north) continue;
        problems.add({"lies outside the terrain", where, shortest_text(p.x) + ", " + shortest_text(p.y),
                      "west " + shortest_text(map.west) + " south " + shortest_text(map.south) + " east " +
                          shortest_text(map.east) + " north " + shortest_text(map.north),
                      "Check the coordinates of both, or give a larger terrain"});
        return;
    }
}

/// Names what is to be recorded: each has its own.
class Names {
  public:
    Names(std::string what, Problems& problems) : what_(std::move(what)), problems_(problems) {}
    std::string next(const std::string& given) {
        ++count_;
        std::string name = given.empty() ? std::to_string(count_) : given;
        if (!names_.insert(name).second)
            problems_.add({"two have the same name", what_, name, "", "Give each a unique name"});
        return name;
    }

  private:
    std::string what_;
    Problems& problems_;
    std::set<std::string> names_;
    std::size_t count_ = 0;
};

}  // namespace

Recording recording_of(const Scene::Data& data, const SceneSpec& spec, const GridSpec& grid, Problems& problems) {
    Recording recording;
    Names gauges("gauges", problems), sections("cross-sections", problems);
    for (const Gauge& gauge : data.gauges) {
        const std::string name = gauges.next(gauge.name);
        check_inside({gauge.place}, "gauge " + name, grid, problems);
        recording.gauges.push_back({name, {gauge.place.x, gauge.place.y}});
    }
    for (const CrossSection& section : data.sections) {
        const std::string name = sections.next(section.name), where = "cross-section " + name;
        if (section.line.size() < 2)
            problems.add({"has no line", where, std::to_string(section.line.size()) + " points", "2 or more",
                          "Give the points of a line"});
        check_inside(section.line, where, grid, problems);
        frana::CrossSection& own = recording.sections.emplace_back(frana::CrossSection{name, {}});
        for (const Point& p : section.line) own.line.push_back({p.x, p.y});
    }
    recording.interval = spec.output.sample_interval.value_or(0);
    recording.normal_depth = spec.output.depth == k_normal_depth;
    return recording;
}

}  // namespace frana::facade
