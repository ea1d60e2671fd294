// SPDX-License-Identifier: Apache-2.0
#include "app/store/scene_identity.h"

#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "app/input/share_directory.h"
#include "app/store/result_files.h"
#include "app/text/text_file.h"
#include "app/text/version.h"
#include "core/text.h"
#include "gis/raster/raster_out.h"
#include "params/grammar/ini_file.h"
#include "params/grammar/value_text.h"
#include "params/keys/laws.h"
#include "params/keys/result_rasters.h"
#include "params/keys/scene_parameters.h"
#include "params/scene/read_scene.h"
#include "params/scene/write_scene.h"

namespace frana::app {
namespace {

std::string echo(const SceneSpec& scene, const std::map<std::string, std::string>& resolved) {
    SceneSpec spec = scene;
    // The echo is in another folder: values derived from the scene file's own name must be written out.
    spec.output.title = spec.output.title.value_or(scene_name(spec));
    // The directory contains this result now; a repeated run uses its own unless specified.
    spec.output.directory.reset();
    return scene_text(spec, resolved);
}

// Returns a scene's text without its comments, which state the source of each value.
std::string values_only(const std::string& text) {
    std::istringstream lines(text);
    std::string line, values;
    while (std::getline(lines, line)) {
        if (!line.empty() && line.front() != '#') values += line.substr(0, line.find(" #")) + '\n';
    }
    return values;
}

}  // namespace

SceneSpec seen_from(SceneSpec scene, const std::string& folder) {
    for (const Parameter& parameter : scene_parameters())
        if (parameter.reads_files())
            parameter.map_files(scene, [&](const std::string& path) { return relative_path(path, folder); });
    return scene;
}

SceneSpec without_places(SceneSpec scene) {
    for (const Parameter& parameter : scene_parameters())
        if (parameter.reads_files())
            parameter.map_files(
                scene, [](const std::string& path) { return std::filesystem::path(path).filename().string(); });
    return scene;
}

std::string echoed_scene(const Prepared& prepared) {
    const std::string& folder = prepared.result_folder;
    return echo(folder.empty() ? prepared.spec : seen_from(prepared.spec, folder), prepared.resolved);
}

std::string echoed_scene(const SceneSpec& scene, const std::string& folder) {
    return echo(seen_from(scene, folder), {});
}

std::string echoed_scene_without_places(const Prepared& prepared) {
    return echo(without_places(prepared.spec), prepared.resolved);
}

std::map<std::string, std::string> provenance(const Prepared& prepared) {
    std::map<std::string, std::string> all = prepared.tags;
    all.insert({{"PROGRAM", k_program},
                {"VERSION", k_version},
                {"SCENE", valid_utf8(scene_name(prepared.spec))},
                {"SCENE_HASH", text_hash(echoed_scene_without_places(prepared))},
                {gis::k_depth_item, prepared.spec.output.depth == k_normal_depth ? k_normal : k_vertical},
                {"TIFFTAG_SOFTWARE", std::string(k_program) + " " + k_version}});
    if (const std::string key = "material.density"; model_reads(prepared.spec, key)) {
        const bool is_default = prepared.spec.origin_of(key) == Origin::default_value;
        all["DENSITY"] = shortest_text(prepared.spec.material.density) + " kg/m3" + (is_default ? " (default)" : "");
    }
    for (const std::string& doubt : texts_of(limits_of_use(prepared.scene.warnings))) {
        std::string& told = all["DOUBTS"];
        told += (told.empty() ? "" : "; ") + doubt;
    }
    return all;
}

namespace {

// Whether an output key says how a result is shown, not what is computed or which data are written: with --resume
// another value of it is as good.
bool is_of_pictures(const std::string& line) {
    static const std::regex k_keys(
        "(map-|classes|maps |animation |charts |report |title |language |checkpoint-interval ).*");
    return std::regex_match(line, k_keys);
}

// Returns the "section.key = value" lines of a scene's text that bind a resumed run.
std::string keys(const std::string& text) {
    std::istringstream lines(text);
    std::string section, all;
    for (std::string line; std::getline(lines, line);) {
        if (line.empty() || line.front() == '#') continue;
        if (line.front() == '[') {
            section = line.substr(1, line.size() - 2);
        } else if (section != "output" || !is_of_pictures(line)) {
            all += section + "." + line + "\n";
        }
    }
    return all;
}

std::map<std::string, std::string> facts(const std::string& identity) {
    std::map<std::string, std::string> list;
    std::istringstream lines(identity);
    for (std::string line; std::getline(lines, line);) {
        const auto place = line.find(" = ");
        if (place != std::string::npos) list[line.substr(0, place)] = line.substr(place + 3);
    }
    return list;
}

std::string identity(const std::string& scene_text, const std::vector<std::string>& data) {
    std::string text = keys(scene_text);
    for (const std::string& fact : data) text += fact + "\n";
    return text;
}

}  // namespace

std::vector<std::string> data_identity(const Prepared& prepared) {
    if (!prepared.identity.empty()) return prepared.identity;
    const GridSpec& grid = prepared.scene.grid;
    std::vector<std::string> facts{"working grid = " + std::to_string(grid.columns) + " x " +
                                   std::to_string(grid.rows) + " of " + shortest_text(grid.cell_size) + " m from (" +
                                   shortest_text(grid.west) + ", " + shortest_text(grid.north) + ")"};
    const auto add = [&](const std::string& name, const Checksum& sum) {
        facts.push_back("checksum of the " + name + " = " + std::to_string(sum.value()));
    };
    Checksum crs;
    crs.add(grid.crs_wkt);
    add("coordinate reference system", crs);
    std::map<std::string, int> times;
    for (const UsedFile& file : prepared.files) {
        const int nth = ++times[file.role];
        add("content of " + file.role + (nth > 1 ? " " + std::to_string(nth) : ""), file.checksum);
    }
    return facts;
}

std::string scene_identity(const Prepared& prepared) {
    return identity(echoed_scene_without_places(prepared), data_identity(prepared));
}

std::optional<std::string> result_identity(const std::string& result_folder) {
    const std::filesystem::path folder = result_folder;
    const std::string scene = read_text_file((folder / k_scene_file).string());
    const std::optional<Json> summary = read_json_file((folder / k_summary_file).string());
    if (scene.empty() || !summary || !summary->contains(k_data_key)) return std::nullopt;
    std::vector<std::string> data;
    for (const Json& fact : summary->at(k_data_key)) {
        if (!fact.is_string()) return std::nullopt;
        data.push_back(fact.get<std::string>());
    }
    const SceneReading reading = read_scene((folder / k_scene_file).string(), {}, share_directory());
    return identity(scene_text(without_places(reading.scene), {}), data);
}

std::vector<std::string> identity_differences(const std::string& here, const std::string& then) {
    constexpr std::size_t k_most = 4;
    const auto now = facts(here), before = facts(then);
    std::vector<std::string> words;
    for (const auto& [name, value] : now) {
        const auto old = before.find(name);
        if (old == before.end()) {
            words.push_back(name + " is " + value + " here and was not given");
        } else if (old->second != value) {
            const bool sum = name.rfind("checksum of ", 0) == 0;
            words.push_back(sum ? name.substr(12) + " differs"
                                : name + " is " + value + " here and was " + old->second);
        }
    }
    for (const auto& [name, value] : before) {
        if (now.count(name) == 0) words.push_back(name + " was " + value + " and is not given here");
    }
    if (words.size() > k_most) {
        words.resize(k_most);
        words.emplace_back("and more");
    }
    return words;
}

std::string numbers_fingerprint(const SceneSpec& scene) {
    SceneSpec numbers = scene;
    numbers.output = OutputSpec{};
    numbers.observed = ObservedSpec{};
    numbers.time.frame_interval = TimeSpec{}.frame_interval;
    return text_hash(values_only(scene_text(numbers, {})));
}

std::string convergence_directory(const std::string& result_directory) {
    return result_directory + "-convergence";
}

void write_error_estimate(const std::string& folder, const SceneSpec& scene, const std::string& sentences) {
    write_text_file((std::filesystem::path(folder) / k_error_estimate_file).string(),
                    numbers_fingerprint(scene) + '\n' + sentences);
}

std::optional<std::string> read_error_estimate(const std::string& result_directory, const SceneSpec& scene) {
    std::ifstream file(std::filesystem::path(convergence_directory(result_directory)) / k_error_estimate_file);
    std::string fingerprint;
    if (!std::getline(file, fingerprint) || fingerprint != numbers_fingerprint(scene)) return std::nullopt;
    std::ostringstream rest;
    rest << file.rdbuf();
    return rest.str();
}

}  // namespace frana::app
