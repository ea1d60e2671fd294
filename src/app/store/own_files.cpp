// SPDX-License-Identifier: Apache-2.0
#include "app/store/own_files.h"

#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <optional>

#include "app/store/manifest.h"
#include "app/store/partial_folder.h"
#include "app/store/result_files.h"
#include "core/error.h"
#include "core/files.h"
#include "gis/raster/picture_out.h"
#include "params/grammar/ini_file.h"
#include "params/grammar/value_text.h"
#include "params/keys/parameter.h"
#include "params/keys/scene_parameters.h"

namespace frana::app {
namespace {

namespace fs = std::filesystem;

std::optional<std::pair<std::uint64_t, std::uint64_t>> place_of(const std::string& path) {
    struct stat found {};
    if (::stat(path.c_str(), &found) != 0 || !S_ISREG(found.st_mode)) return std::nullopt;
    return std::pair{static_cast<std::uint64_t>(found.st_dev), static_cast<std::uint64_t>(found.st_ino)};
}

bool is_drawn(const fs::path& file, const fs::path& folder) {
    if (const ResultFile* known = existing_file(file.lexically_relative(folder).generic_string()))
        return known->is_drawn();
    // Drawn to folders chosen by the user.
    const std::array<std::string, 5> pictures{".png", ".pdf", ".svg", ".mp4", ".gif"};
    return std::find(pictures.begin(), pictures.end(), file.extension().string()) != pictures.end();
}

}  // namespace

std::vector<std::string> spellings(const std::string& source) {
    std::vector<std::string> all{source, source.substr(0, source.find('|'))};
    for (std::size_t from = 0; from < source.size();) {
        const std::size_t to = std::min(source.find_first_of(":\"|?,", from), source.size());
        all.push_back(source.substr(from, to - from));
        from = to + 1;
    }
    const std::string archive = "/vsi";
    for (std::size_t i = 0, count = all.size(); i < count; ++i) {
        if (!all[i].starts_with(archive)) continue;
        fs::path inner = all[i].substr(std::min(all[i].find('/', archive.size()), all[i].size()));
        for (; inner.has_relative_path(); inner = inner.parent_path()) {
            all.push_back(inner.string());            // "/vsizip//folder/file.zip/part"
            all.push_back(inner.string().substr(1));  // "/vsizip/file.zip/part" from the current folder
        }
    }
    return all;
}

void KeptFiles::add(const std::string& source) {
    for (const std::string& path : spellings(source))
        if (const auto place = place_of(path)) files_.insert(*place);
}

void KeptFiles::add_result(const std::string& folder, const std::vector<std::string>& but) {
    std::error_code error;
    const auto is_rewritten = [&](const fs::path& path) {
        return std::any_of(but.begin(), but.end(), [&](const std::string& one) {
            return fs::path(one).lexically_normal() == path.lexically_normal();
        });
    };
    for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
        const auto place = place_of(entry->path().string());
        if (place && !is_drawn(entry->path(), folder) && !is_rewritten(entry->path())) files_.insert(*place);
    }
    const fs::path scene = fs::path(folder) / k_scene_file;
    if (!fs::exists(scene, error)) return;
    static const std::vector<Parameter>& k_keys = scene_parameters();
    const std::string here = fs::absolute(folder).string();
    for (const IniEntry& entry : read_ini(scene.string())) {
        const Parameter* const key = find_parameter(k_keys, present_name(entry.name));
        SceneSpec spec;
        if (key == nullptr || !key->reads_files() || key->read(spec, entry.value)) continue;
        key->map_files(spec, [&](const std::string& path) {
            add(absolute_path(path, here));
            return path;
        });
    }
}

bool KeptFiles::has(const std::string& path) const {
    const auto place = place_of(path);
    return place && files_.count(*place) > 0;
}

void KeptFiles::check(const std::vector<std::string>& outputs, const std::string& where, Problems& problems) const {
    for (const std::string& path : outputs)
        if (has(path))
            problems.add({"would be overwritten: it is an input or belongs to a result", where, path, "",
                          "Choose another folder with --out"});
}

void KeptFiles::check_pictures(const std::vector<std::string>& outputs, const std::string& where,
                               Problems& problems) const {
    check(outputs, where, problems);
    for (const std::string& path : outputs) {
        if (path.ends_with(".tif") && place_of(path) && !has(path) && !gis::is_drawn_geotiff(path))
            problems.add(
                {"exists already and was not drawn by frana", where, path, "", "Choose another folder with --out"});
    }
}

namespace {

namespace fs = std::filesystem;

/// Moves a file to the first free of NAME.kept-1.EXTENSION, NAME.kept-2.EXTENSION, ...
std::error_code move_to_kept(const fs::path& from, fs::path& to) {
    std::error_code error, ignored;
    for (int number = 1;; ++number) {
        to = from.parent_path() / from.stem();
        to += ".kept-" + std::to_string(number) + from.extension().string();
        if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return {};
        error.assign(errno, std::generic_category());
        const bool is_unknown = error == std::errc::invalid_argument;  // to the file system
        if (error == std::errc::file_exists || (is_unknown && fs::exists(fs::symlink_status(to, ignored)))) continue;
        if (is_unknown) fs::rename(from, to, error);
        return error;
    }
}

}  // namespace

void keep_changed_files(const std::vector<std::string>& paths) {
    for (const std::string& path : changed_files(paths)) {
        fs::path kept;
        if (const std::error_code error = move_to_kept(path, kept))
            throw Error(
                ErrorKind::environment,
                Problem{"was changed since frana wrote it, and cannot be kept under another name: " + error.message(),
                        path, "", "", "Choose another folder with --out"});
        std::cerr << "frana: " << path << " is not as frana wrote it: kept as " << kept.filename().string() << '\n';
    }
}

namespace {

namespace fs = std::filesystem;

bool lists_files(const fs::path& folder) {
    return is_listed_result(folder.string());
}

// Whether it is of a run, complete or unfinished; comparisons and studies list their files too, but belong to no scene.
bool is_result(const fs::path& folder) {
    const std::optional<Manifest> manifest = read_manifest(folder.string());
    if (manifest && !manifest->scene_hash.empty()) return true;
    return is_being_built(folder.string()) || (!manifest && is_unlisted_result(folder.string()));
}

/// Returns the nearest folder of a kind, at a path or above it; the path need not exist yet.
template <class Kind>
std::optional<fs::path> around(const std::string& path, const Kind& kind) {
    std::error_code error;
    fs::path folder = fs::weakly_canonical(fs::absolute(path.empty() ? "." : path), error);
    if (!folder.has_filename()) folder = folder.parent_path();  // "folder/"
    for (;; folder = folder.parent_path()) {
        if (kind(folder)) return folder;
        if (!folder.has_relative_path()) return std::nullopt;
    }
}

void check_another_result(const std::string& folder, const std::string& where, const std::vector<std::string>& reads,
                          Problems& problems) {
    const auto result = around(folder, is_result);
    const auto is_it = [&](const std::string& read) { return around(read, is_result) == result; };
    if (!result || std::any_of(reads.begin(), reads.end(), is_it)) return;
    const std::string read = reads.empty() ? "" : "; the input is " + joined(reads, ", ");
    problems.add({"is in another result, " + result->string() + ", whose files would be changed" + read, where, folder,
                  "", "Choose a place outside it"});
}

}  // namespace

void check_own(const std::string& folder, const std::vector<std::string>& files, const std::string& where,
               const std::vector<std::string>& reads, Problems& problems) {
    check_another_result(folder, where, reads, problems);
    if (around(folder, lists_files)) return;  // files changed since are kept when they are rewritten
    std::error_code error;
    const std::string list = (fs::path(folder) / k_manifest_file).string();
    const std::string remedy =
        "Choose another folder with " + where +
        ", or move the file away; a study by an older frana, without a list of its files, must be moved as a whole";
    if (fs::exists(list, error))
        problems.add({"exists already and is not frana's list of files", where, list, "", remedy});
    // Results of a frana without lists of files are identified only by its names.
    const auto unlisted = around(folder, is_result);
    const fs::path real = fs::weakly_canonical(folder.empty() ? "." : folder, error);
    for (const std::string& file : files) {
        const fs::path inside = real / fs::path(file).lexically_relative(folder.empty() ? "." : folder);
        const bool known =
            unlisted &&
            existing_file(inside.lexically_normal().lexically_relative(*unlisted).generic_string()) != nullptr;
        if (!known && fs::exists(fs::symlink_status(file, error)))
            problems.add({"exists already and was not written by frana", where, file, "", remedy});
    }
}

void begin_own(const std::string& folder, const std::vector<std::string>& files) {
    if (!around(folder, lists_files) && !around(folder, is_result)) write_manifest(folder, {});
    keep_changed_files(files);
}

void clear_own(const std::string& folder, const std::vector<std::string>& files,
               const std::function<bool(const std::string& name)>& belongs) {
    const auto home = around(folder, lists_files);
    const auto manifest = home ? read_manifest(home->string()) : std::nullopt;
    if (!manifest) return;
    const fs::path real = fs::canonical(folder);
    std::vector<std::string> removed;
    for (const auto& [name, mark] : manifest->files) {
        const fs::path file = *home / name;
        const auto is_it = [&](const std::string& one) { return fs::path(one).filename() == file.filename(); };
        if (file.parent_path() != real || !belongs(file.filename().string()) ||
            std::any_of(files.begin(), files.end(), is_it))
            continue;
        std::error_code error;
        if (!fs::is_regular_file(fs::symlink_status(file, error)) || mark_of(file.string()) != mark) continue;
        fs::remove(file, error);
        if (error)
            throw Error(ErrorKind::environment,
                        Problem{"is from an earlier, longer series and cannot be removed: " + error.message(),
                                file.string(), "", "", system_remedy(error.value())});
        removed.push_back(name);
    }
    remove_from_manifest(home->string(), removed);
}

}  // namespace frana::app
