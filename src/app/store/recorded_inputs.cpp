// SPDX-License-Identifier: Apache-2.0
#include "app/store/recorded_inputs.h"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "app/store/manifest.h"
#include "app/store/result_files.h"
#include "core/json.h"
#include "params/grammar/ini_file.h"
#include "params/keys/scene_parameters.h"

namespace frana::app {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t k_largest_read = 1'000'000'000;  // a checksum would take as long as the run's own reading

/// A file, and those beside it that belong to it: of a shapefile, the CRS and the position of a raster.
std::vector<fs::path> parts_of(const fs::path& file) {
    std::vector<fs::path> parts{file};
    for (const char* ending : {".shx", ".dbf", ".prj", ".cpg", ".tfw", ".wld"}) {
        fs::path part = file;
        part.replace_extension(ending);
        std::error_code error;
        if (part != file && fs::is_regular_file(part, error)) parts.push_back(part);
    }
    return parts;
}

/// One file as recorded.
struct Recorded {
    std::string key;
    fs::path relative, then;  ///< from the result; the absolute place at the time
    std::uint64_t bytes = 0;
    std::string checksum;  ///< empty: too large

    [[nodiscard]] std::string mark() const {
        return std::to_string(bytes) + " bytes" + (checksum.empty() ? "" : ", xxh128 " + checksum);
    }
};

FileMark mark_at(const fs::path& file) {
    std::error_code error;
    const auto bytes = fs::file_size(file, error);
    if (error) return {};
    return bytes > k_largest_read ? FileMark{bytes, ""} : mark_of(file.string());
}

bool has_content(const fs::path& file, const Recorded& recorded) {
    std::error_code error;
    if (!fs::is_regular_file(file, error)) return false;
    const FileMark mark = mark_at(file);
    return mark.bytes == recorded.bytes && mark.checksum == recorded.checksum;
}

std::vector<Recorded> read_recorded(const fs::path& folder) {
    std::vector<Recorded> all;
    const auto json = read_json_file((folder / k_inputs_file).string());
    if (!json || !json->contains("files")) return all;
    try {
        for (const Json& one : json->at("files"))
            all.push_back({one.at("key").get<std::string>(), unescaped_name(one.at("file").get<std::string>()),
                           unescaped_name(one.at("place").get<std::string>()), one.at("bytes").get<std::uint64_t>(),
                           one.at("xxh128").is_null() ? "" : one.at("xxh128").get<std::string>()});
    } catch (const std::exception&) {
        return {};  // not of frana
    }
    return all;
}

std::vector<NamedFile> files_of(const NamingText& text) {
    std::vector<NamedFile> all;
    text.map_files([&](const std::string& key, const std::string& path) {
        all.push_back({key, path});
        return path;
    });
    return all;
}

/// Lets a key name a file at another place.
void move_file(const NamingText& text, const std::string& key, const fs::path& from, const fs::path& to) {
    text.map_files([&](const std::string& named, const std::string& path) {
        const auto at = path.find(from.string());
        return named != key || at == std::string::npos
                   ? path
                   : path.substr(0, at) + to.string() + path.substr(at + from.string().size());
    });
}

/// The folder of inputs.json for a scene file: its own; of a member's, that of the study.
fs::path recording_folder(const fs::path& scene) {
    const fs::path folder = scene.parent_path();
    std::error_code error;
    const bool of_member =
        !fs::exists(folder / k_inputs_file, error) && folder.parent_path().filename() == k_member_folder;
    return of_member ? folder.parent_path().parent_path() : folder;
}

/// Maps the files of a scene.
void map_scene_files(SceneSpec& scene, const NamingText::FileMap& map) {
    static const std::vector<Parameter>& k_keys = scene_parameters();
    for (const Parameter& key : k_keys)
        if (key.reads_files()) key.map_files(scene, [&](const std::string& path) { return map(key.name(), path); });
    for (const NamedFile& file : named_files(scene))  // one of the program cannot be elsewhere, but may have changed
        if (file.of_program) map(file.key, file.path);
}

}  // namespace

std::string recorded_inputs(const Prepared& prepared) {
    return recorded_inputs(named_files(prepared.spec), prepared.result_folder);
}

std::string recorded_inputs(const std::vector<NamedFile>& files, const std::string& folder) {
    Json json = Json::object();
    json["files"] = Json::array();
    std::set<std::pair<std::string, std::string>> known;
    for (const NamedFile& named : files) {
        const fs::path file = plain_file(named.path);
        std::error_code error;
        if (file.empty() || !known.emplace(named.key, file.string()).second || !fs::is_regular_file(file, error))
            continue;
        for (const fs::path& part : parts_of(file)) {
            const FileMark mark = mark_at(part);
            json["files"].push_back(
                {{"key", named.key},
                 {"file", escaped_name(folder.empty() || named.of_program ? part.string()
                                                                          : relative_path(part.string(), folder))},
                 {"place", escaped_name(part.string())},
                 {"bytes", mark.bytes},
                 {"xxh128", mark.checksum.empty() ? Json() : Json(mark.checksum)}});
        }
    }
    return json_text(json);
}

void find_recorded_files(const NamingText& text, const std::string& result_folder, RunLog& log) {
    const fs::path folder = result_folder;
    // Of a file and the parts beside it, the first that is missing, which names the others.
    std::vector<std::pair<std::pair<std::string, fs::path>, Problem>> missing;
    const auto stem = [](fs::path file) { return file.replace_extension(); };
    for (const Recorded& recorded : read_recorded(folder)) {
        if (text.is_replaced(recorded.key)) continue;
        const fs::path here = (folder / recorded.relative).lexically_normal();
        const auto belongs_to_key = [&](const fs::path& file, bool main_only) {
            const auto files = files_of(text);
            return std::any_of(files.begin(), files.end(), [&](const NamedFile& named) {
                if (named.key != recorded.key) return false;
                if (main_only) return file == plain_file(named.path);
                const auto parts = parts_of(plain_file(named.path));
                return std::find(parts.begin(), parts.end(), file) != parts.end();
            });
        };
        const auto named = files_of(text);
        if (std::none_of(named.begin(), named.end(), [&](const NamedFile& file) {
                const fs::path main = plain_file(file.path);
                return file.key == recorded.key && (stem(main) == stem(here) || stem(main) == stem(recorded.then));
            }))
            continue;  // the text was changed and names another file
        std::error_code error;
        if (fs::exists(here, error)) {
            if (belongs_to_key(here, false) && !has_content(here, recorded)) {
                const FileMark mark = mark_at(here);
                log.warn(worded("{1}: {2} changed since this result (then {3}; now {4})",
                                {text.where(recorded.key), here.string(), recorded.mark(),
                                 std::to_string(mark.bytes) + " bytes" +
                                     (mark.checksum.empty() ? "" : ", xxh128 " + mark.checksum)}));
            }
        } else if (text.warns_only) {
            continue;
        } else if (here != recorded.then && has_content(recorded.then, recorded) &&
                   (belongs_to_key(here, true) || belongs_to_key(recorded.then, false))) {
            if (!belongs_to_key(here, true)) continue;  // beside a file that was found there
            log.info(text.where(recorded.key) + ": " + recorded.then.string() +
                     " is used, which has the content of the missing " + here.string());
            move_file(text, recorded.key, here, recorded.then);
        } else {
            const std::pair input(recorded.key, stem(here));
            const auto known =
                std::find_if(missing.begin(), missing.end(), [&](const auto& m) { return m.first == input; });
            if (known != missing.end()) {
                known->second.value += ", " + recorded.relative.extension().string();
                continue;
            }
            std::string places = here.string();
            if (here != recorded.then)
                places += fs::exists(recorded.then, error)
                              ? " and as " + recorded.then.string() + ", which has another content"
                              : " and as " + recorded.then.string();
            missing.push_back({input,
                               {"an input of this result is missing; it had " + recorded.mark(),
                                text.where(recorded.key), recorded.relative.string(), "",
                                "Sought as " + places + ". Put it there, or name its place" +
                                    (text.is_study ? " in the study file" : ": --set " + recorded.key + "=FILE")}});
        }
    }
    Problems problems;
    for (const auto& [input, problem] : missing) problems.add(problem);
    problems.throw_if_any();
}

void find_recorded_inputs(SceneReading& reading, RunLog& log) {
    find_recorded_files({[&](const NamingText::FileMap& map) { map_scene_files(reading.scene, map); },
                         [&](const std::string& key) { return reading.where(key); },
                         [&](const std::string& key) { return reading.scene.origin_of(key) == Origin::command_line; }},
                        recording_folder(reading.scene.file).string(), log);
}

void warn_of_changed_inputs(const std::string& study_file, const SceneReading& scene, RunLog& log) {
    SceneSpec spec = scene.scene;
    find_recorded_files(
        {[&](const NamingText::FileMap& map) { map_scene_files(spec, map); },
         [&](const std::string& key) { return scene.where(key); },
         [&](const std::string& key) { return scene.scene.origin_of(key) == Origin::command_line; }, false, true},
        fs::path(study_file).parent_path().string(), log);
}

}  // namespace frana::app
