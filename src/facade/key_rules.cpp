// SPDX-License-Identifier: Apache-2.0
#include "facade/key_rules.h"

#include <algorithm>
#include <iterator>

#include "params/keys/former_names.h"
#include "params/keys/scene_parameters.h"
#include "params/scene/read_keys.h"

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

}  // namespace frana::facade
