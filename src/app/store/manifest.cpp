// SPDX-License-Identifier: Apache-2.0
#include "app/store/manifest.h"

#include <cstdio>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>

#include "app/store/own_files.h"
#include "app/store/result_files.h"
#include "app/text/version.h"
#include "core/error.h"
#include "core/files.h"

namespace frana::app {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& what, const std::string& path, int reason) {
    throw Error(ErrorKind::environment,
                Problem{what + ": " + std::strerror(reason), path, "", "", system_remedy(reason)});
}

std::string now_utc() {
    const std::time_t now = std::time(nullptr);
    std::tm parts{};
    ::gmtime_r(&now, &parts);
    char text[32];
    std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts);
    return text;
}

/// Changes the manifest of a result while it is locked; one that `change` leaves as it was (false) is not written.
void update(const std::string& folder, const std::function<bool(Manifest&)>& change) {
    const FolderLock lock(folder, true);
    if (!lock.is_held()) fail("cannot be opened", folder, lock.reason());
    std::optional<Manifest> manifest = read_manifest(folder);
    if (manifest && change(*manifest)) write_manifest(folder, *manifest);
}

/// Returns the nearest folder above a file that is a result; empty: none.
fs::path result_around(const fs::path& file) {
    for (fs::path folder = file.parent_path();; folder = folder.parent_path()) {
        if (read_manifest(folder.string())) return folder;
        if (!folder.has_relative_path()) return {};
    }
}

/// Returns those files that exist, or may be made in an existing folder, and are in results, by result.
std::map<fs::path, std::vector<fs::path>> by_result(const std::vector<std::string>& paths, bool may_lack = false) {
    std::map<fs::path, fs::path> results;  // by folder
    std::map<fs::path, std::vector<fs::path>> found;
    for (const std::string& path : paths) {
        std::error_code error;
        const fs::path file = may_lack ? fs::weakly_canonical(path, error) : fs::canonical(path, error);
        if (error || !(may_lack || fs::is_regular_file(file, error))) continue;
        const auto [known, is_new] = results.try_emplace(file.parent_path());
        if (is_new) known->second = result_around(file);
        if (!known->second.empty()) found[known->second].push_back(file);
    }
    return found;
}

}  // namespace

std::string escaped_name(const std::string& name) {
    std::string text;
    for (const char c : name) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte > 0x20 && byte < 0x7f && c != '%') {
            text += c;
        } else {
            char code[4];
            std::snprintf(code, sizeof code, "%%%02X", byte);
            text += code;
        }
    }
    return text;
}

std::string unescaped_name(const std::string& text) {
    std::string name;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '%' && i + 2 < text.size()) {
            name += static_cast<char>(std::stoi(text.substr(i + 1, 2), nullptr, 16));
            i += 2;
        } else {
            name += text[i];
        }
    }
    return name;
}

bool is_as_listed(const std::string& path, const std::optional<std::uint64_t>& bytes) {
    std::error_code error;
    const std::uintmax_t size = fs::file_size(path, error);
    return !error && (!bytes || size == *bytes);
}

std::uint64_t size_on_disk(const std::string& path) {
    if (const int reason = sync_path(path); reason != 0) fail("cannot be written to the disk", path, reason);
    std::error_code error;
    const std::uint64_t bytes = fs::file_size(path, error);
    if (error) fail("cannot be read", path, error.value());
    return bytes;
}

std::optional<Manifest> read_manifest(const std::string& folder) {
    const std::optional<Json> json = read_json_file((fs::path(folder) / k_manifest_file).string());
    if (!json || value_in<std::string>(*json, "/program") != k_program) return std::nullopt;
    const std::int64_t format = value_in<std::int64_t>(*json, "/format").value_or(0);
    if (format < 1 || format > k_manifest_format) return std::nullopt;
    Manifest manifest;
    manifest.scene_hash = value_in<std::string>(*json, "/scene_hash").value_or("");
    manifest.simulated_seconds = value_in<double>(*json, "/simulated_seconds").value_or(0);
    manifest.finished = value_in<bool>(*json, "/finished").value_or(false);
    try {
        if (!json->at("files").is_array()) return std::nullopt;
        for (const Json& entry : json->at("files")) {
            std::optional<std::uint64_t>& bytes = manifest.files[unescaped_name(entry.at("name").get<std::string>())];
            if (!entry.at("bytes").is_null()) bytes = entry.at("bytes").get_ref<const Json::number_unsigned_t&>();
        }
    } catch (const std::exception&) {
        return std::nullopt;
    }
    return manifest;
}

void write_manifest(const std::string& folder, const Manifest& manifest) {
    Json json{{"program", k_program},
              {"version", k_version},
              {"format", k_manifest_format},
              {"written", now_utc()},
              {"scene_hash", manifest.scene_hash},
              {"simulated_seconds", manifest.simulated_seconds},
              {"finished", manifest.finished}};
    Json& files = json["files"] = Json::array();
    for (const auto& [name, bytes] : manifest.files)
        files.push_back({{"name", escaped_name(name)}, {"bytes", bytes ? Json(*bytes) : Json()}});
    write_file((fs::path(folder) / k_manifest_file).string(), json_text(json), Sync::yes);
    if (const int reason = sync_path(folder); reason != 0) fail("cannot be written to the disk", folder, reason);
}

void note_in_making(const std::vector<std::string>& paths) {
    for (const auto& [result, files] : by_result(paths, true))
        update(result.string(), [&, &result = result, &files = files](Manifest& manifest) {
            for (const fs::path& file : files)
                manifest.files[file.lexically_relative(result).generic_string()] = std::nullopt;
            return true;
        });
}

void record_files(const std::vector<std::string>& paths) {
    for (const auto& [result, files] : by_result(paths, true))
        update(result.string(), [&, &result = result, &files = files](Manifest& manifest) {
            std::set<fs::path> folders;
            std::error_code error;
            for (const fs::path& file : files) {
                const std::string name = file.lexically_relative(result).generic_string();
                if (fs::is_regular_file(file, error))
                    manifest.files[name] = size_on_disk(file.string());
                else
                    manifest.files.erase(name);
                folders.insert(file.parent_path());
            }
            for (const fs::path& folder : folders) sync_path(folder.string());
            return true;
        });
}

std::vector<std::string> changed_files(const std::vector<std::string>& paths) {
    std::vector<std::string> changed;
    for (const auto& [result, files] : by_result(paths)) {
        const std::optional<Manifest> manifest = read_manifest(result.string());
        if (!manifest) continue;
        for (const fs::path& file : files) {
            const std::string name = file.lexically_relative(result).generic_string();
            const auto listed = manifest->files.find(name);
            if (listed == manifest->files.end() || !is_as_listed(file.string(), listed->second))
                changed.push_back(file.string());
        }
    }
    return changed;
}

void remove_from_manifest(const std::string& folder, const std::vector<std::string>& names) {
    update(folder, [&](Manifest& manifest) {
        std::size_t forgotten = 0;
        for (const std::string& name : names) forgotten += manifest.files.erase(name);
        return forgotten > 0;
    });
}

}  // namespace frana::app
