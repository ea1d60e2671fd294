// SPDX-License-Identifier: Apache-2.0
#include "app/store/manifest.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>

#include "app/store/result_files.h"
#include "app/text/version.h"
#include "core/error.h"
#include "core/files.h"

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace frana::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* k_checksum = "xxh128";

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

/// Locks a result's manifest while it is read, changed and written: the folder itself is locked.
class ManifestLock {
  public:
    explicit ManifestLock(const std::string& folder)
        : descriptor_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
        if (descriptor_ < 0) fail("cannot be opened", folder, errno);
        while (::flock(descriptor_, LOCK_EX) != 0 && errno == EINTR) {
        }
    }
    ~ManifestLock() { ::close(descriptor_); }
    ManifestLock(const ManifestLock&) = delete;
    ManifestLock& operator=(const ManifestLock&) = delete;

  private:
    int descriptor_;
};

/// ContentSum of bytes.
class ContentSum {
  public:
    ContentSum() : state_(XXH3_createState(), &XXH3_freeState) { XXH3_128bits_reset(state_.get()); }
    void add(std::string_view bytes) {
        XXH3_128bits_update(state_.get(), bytes.data(), bytes.size());
        mark_.bytes += bytes.size();
    }
    [[nodiscard]] FileMark mark() const {
        const XXH128_hash_t hash = XXH3_128bits_digest(state_.get());
        char text[33];
        std::snprintf(text, sizeof text, "%016llx%016llx", static_cast<unsigned long long>(hash.high64),
                      static_cast<unsigned long long>(hash.low64));
        FileMark mark = mark_;
        mark.checksum = text;
        return mark;
    }

  private:
    std::unique_ptr<XXH3_state_t, XXH_errorcode (*)(XXH3_state_t*)> state_;
    FileMark mark_;
};

/// Whether a GeoPackage has its mark with an earlier header. Format of SQLite: bytes 18 and 19 are the journal mode, 24
/// to 27 and 92 to 95 count changes, two for each time that a GIS shows the file.
bool is_as_before_showing(const std::string& path, const FileMark& listed) {
    constexpr std::size_t k_header = 100, k_most_changes = 64;
    std::string all;
    read_blocks(path, [&](std::string_view bytes) { all += bytes; });
    if (all.size() < k_header) return false;
    all[18] = all[19] = 1;
    for (std::size_t change = 0; change < k_most_changes; ++change) {
        for (const std::size_t counter : {24U, 92U})  // one less, big-endian
            for (std::size_t byte = counter + 3; byte >= counter && all[byte]-- == 0; --byte) {
            }
        ContentSum sum;
        sum.add(all);
        if (sum.mark() == listed) return true;
    }
    return false;
}

/// Returns the nearest folder above a file that is a result; empty: none.
fs::path result_around(const fs::path& file) {
    for (fs::path folder = file.parent_path();; folder = folder.parent_path()) {
        if (is_listed_result(folder.string())) return folder;
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

FileMark mark_of(const std::string& path) {
    ContentSum sum;
    if (const int reason = read_blocks(path, [&](std::string_view bytes) { sum.add(bytes); }); reason != 0)
        fail("cannot be read", path, reason);
    return sum.mark();
}

bool is_as_listed(const std::string& path, const FileMark& listed) {
    std::error_code error;
    if (fs::file_size(path, error) != listed.bytes || error) return false;
    if (mark_of(path) == listed) return true;
    if (!path.ends_with(".gpkg")) return false;
    return is_as_before_showing(path, listed);
}

FileMark mark_on_disk(const std::string& path) {
    if (const int reason = sync_path(path); reason != 0) fail("cannot be written to the disk", path, reason);
    return mark_of(path);
}

std::optional<Manifest> read_manifest(const std::string& folder) {
    const std::optional<Json> json = read_json_file((fs::path(folder) / k_manifest_file).string());
    if (!json || value_in<std::string>(*json, "/program") != k_program) return std::nullopt;
    const std::int64_t format = value_in<std::int64_t>(*json, "/format").value_or(0);
    if (format < 1 || format > k_manifest_format) return std::nullopt;
    Manifest manifest;
    manifest.scene_hash = value_in<std::string>(*json, "/scene_hash").value_or("");
    manifest.simulated_seconds = value_in<double>(*json, "/simulated_seconds").value_or(0);
    manifest.finished = value_in<bool>(*json, "/finished");
    try {
        if (!json->at("files").is_array()) return std::nullopt;
        for (const Json& entry : json->at("files"))
            manifest.files[unescaped_name(entry.at("name").get<std::string>())] = {
                entry.at("bytes").get_ref<const Json::number_unsigned_t&>(), entry.at(k_checksum).get<std::string>()};
        for (const Json& name : json->value("in_making", Json::array()))
            manifest.in_making.insert(unescaped_name(name.get<std::string>()));
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
              {"simulated_seconds", manifest.simulated_seconds}};
    if (manifest.finished) json["finished"] = *manifest.finished;
    Json& files = json["files"] = Json::array();
    for (const auto& [name, mark] : manifest.files)
        files.push_back({{"name", escaped_name(name)}, {"bytes", mark.bytes}, {k_checksum, mark.checksum}});
    for (const std::string& name : manifest.in_making) json["in_making"].push_back(escaped_name(name));
    write_file((fs::path(folder) / k_manifest_file).string(), json_text(json), Sync::yes);
    if (const int reason = sync_path(folder); reason != 0) fail("cannot be written to the disk", folder, reason);
}

bool is_listed_result(const std::string& folder) {
    return read_manifest(folder).has_value();
}

void note_in_making(const std::vector<std::string>& paths) {
    for (const auto& [result, files] : by_result(paths, true)) {
        const ManifestLock lock(result.string());
        std::optional<Manifest> manifest = read_manifest(result.string());
        if (!manifest) continue;
        for (const fs::path& file : files) manifest->in_making.insert(file.lexically_relative(result).generic_string());
        write_manifest(result.string(), *manifest);
    }
}

void record_files(const std::vector<std::string>& paths) {
    for (const auto& [result, files] : by_result(paths)) {
        const ManifestLock lock(result.string());
        std::optional<Manifest> manifest = read_manifest(result.string());
        if (!manifest) continue;
        for (const fs::path& file : files) {
            const std::string name = file.lexically_relative(result).generic_string();
            manifest->files[name] = mark_on_disk(file.string());
            manifest->in_making.erase(name);
        }
        std::set<fs::path> folders;
        for (const fs::path& file : files) folders.insert(file.parent_path());
        for (const fs::path& folder : folders) sync_path(folder.string());
        write_manifest(result.string(), *manifest);
    }
}

std::vector<std::string> changed_files(const std::vector<std::string>& paths) {
    std::vector<std::string> changed;
    for (const auto& [result, files] : by_result(paths)) {
        const std::optional<Manifest> manifest = read_manifest(result.string());
        if (!manifest) continue;
        for (const fs::path& file : files) {
            const std::string name = file.lexically_relative(result).generic_string();
            const auto listed = manifest->files.find(name);
            if (manifest->in_making.count(name) > 0) continue;
            if (listed == manifest->files.end() || !is_as_listed(file.string(), listed->second))
                changed.push_back(file.string());
        }
    }
    return changed;
}

void remove_from_manifest(const std::string& folder, const std::vector<std::string>& names) {
    const ManifestLock lock(folder);
    std::optional<Manifest> manifest = read_manifest(folder);
    if (!manifest) return;
    std::size_t forgotten = 0;
    for (const std::string& name : names) forgotten += manifest->files.erase(name);
    if (forgotten > 0) write_manifest(folder, *manifest);
}

void record_finished(const std::string& folder) {
    const ManifestLock lock(folder);
    std::optional<Manifest> manifest = read_manifest(folder);
    if (!manifest || manifest->finished.value_or(false)) return;
    manifest->finished = true;
    write_manifest(folder, *manifest);
}

}  // namespace frana::app
