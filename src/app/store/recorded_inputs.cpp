// SPDX-License-Identifier: Apache-2.0
#include "app/store/recorded_inputs.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "app/store/manifest.h"
#include "app/store/result_files.h"
#include "core/error.h"
#include "core/files.h"
#include "core/json.h"
#include "params/grammar/ini_file.h"

#define XXH_INLINE_ALL
#include <xxhash.h>

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

/// Identifies the content of a file.
struct FileMark {
    std::uint64_t bytes = 0;
    std::string checksum{};  ///< XXH3, 128 bits, as `xxh128sum` prints it; empty: too large

    bool operator==(const FileMark&) const = default;
    [[nodiscard]] std::string text() const {
        return std::to_string(bytes) + " bytes" + (checksum.empty() ? "" : ", xxh128 " + checksum);
    }
};

/// One file as recorded.
struct Recorded {
    std::string key;
    fs::path relative;  ///< from the result
    FileMark mark;
};

FileMark mark_of(const std::string& path) {
    const std::unique_ptr<XXH3_state_t, XXH_errorcode (*)(XXH3_state_t*)> state(XXH3_createState(), &XXH3_freeState);
    XXH3_128bits_reset(state.get());
    FileMark mark;
    const int reason = read_blocks(path, [&](std::string_view bytes) {
        XXH3_128bits_update(state.get(), bytes.data(), bytes.size());
        mark.bytes += bytes.size();
    });
    if (reason != 0)
        throw Error(ErrorKind::environment, Problem{std::string("cannot be read: ") + std::strerror(reason), path, "",
                                                    "", system_remedy(reason)});
    const XXH128_hash_t hash = XXH3_128bits_digest(state.get());
    char text[33];
    std::snprintf(text, sizeof text, "%016llx%016llx", static_cast<unsigned long long>(hash.high64),
                  static_cast<unsigned long long>(hash.low64));
    mark.checksum = text;
    return mark;
}

FileMark mark_at(const fs::path& file) {
    std::error_code error;
    const auto bytes = fs::file_size(file, error);
    if (error) return {};
    return bytes > k_largest_read ? FileMark{bytes, ""} : mark_of(file.string());
}

std::vector<Recorded> read_recorded(const fs::path& folder) {
    std::vector<Recorded> all;
    const auto json = read_json_file((folder / k_inputs_file).string());
    if (!json || !json->contains("files")) return all;
    try {
        for (const Json& one : json->at("files"))
            all.push_back({one.at("key").get<std::string>(),
                           unescaped_name(one.at("file").get<std::string>()),
                           {one.at("bytes").get<std::uint64_t>(),
                            one.at("xxh128").is_null() ? "" : one.at("xxh128").get<std::string>()}});
    } catch (const std::exception&) {
        return {};  // not of frana
    }
    return all;
}

/// The folder of inputs.json for a scene file: its own; of a member's, that of the study.
fs::path recording_folder(const fs::path& scene) {
    const fs::path folder = scene.parent_path();
    std::error_code error;
    const bool of_member =
        !fs::exists(folder / k_inputs_file, error) && folder.parent_path().filename() == k_member_folder;
    return of_member ? folder.parent_path().parent_path() : folder;
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

Warnings changed_inputs(const std::vector<NamedFile>& files, const std::string& folder,
                        const std::function<std::string(const std::string& key)>& where) {
    Warnings warnings;
    const auto stem = [](fs::path file) { return file.replace_extension(); };
    for (const Recorded& recorded : read_recorded(folder)) {
        const fs::path here = (folder / recorded.relative).lexically_normal();
        const auto names_it = [&](const NamedFile& file) {
            return file.key == recorded.key && stem(plain_file(file.path)) == stem(here);
        };
        std::error_code error;
        if (std::none_of(files.begin(), files.end(), names_it) || !fs::is_regular_file(here, error)) continue;
        if (const FileMark now = mark_at(here); now != recorded.mark)
            warnings.push_back(worded("{1}: {2} changed since this result (then {3}; now {4})",
                                      {where(recorded.key), here.string(), recorded.mark.text(), now.text()}));
    }
    return warnings;
}

namespace {

Warnings changed_of_scene(const SceneReading& reading, const fs::path& folder) {
    std::vector<NamedFile> files = named_files(reading.scene);
    std::erase_if(files,
                  [&](const NamedFile& file) { return reading.scene.origin_of(file.key) == Origin::command_line; });
    return changed_inputs(files, folder.string(), [&](const std::string& key) { return reading.where(key); });
}

}  // namespace

Warnings changed_inputs(const SceneReading& reading) {
    return changed_of_scene(reading, recording_folder(reading.scene.file));
}

Warnings changed_inputs(const std::string& study_file, const SceneReading& scene) {
    return changed_of_scene(scene, fs::path(study_file).parent_path());
}

}  // namespace frana::app
