// SPDX-License-Identifier: Apache-2.0
#include "app/store/replace_result.h"

#include <fcntl.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <optional>

#include "app/store/manifest.h"
#include "app/store/result_files.h"
#include "app/store/unfinished_results.h"
#include "core/folder_entries.h"

namespace frana::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* k_kept_mark = ".kept-";

/// Moves to the given name, or to another if it is in use.
std::error_code move_to_free(const fs::path& from, const fs::path& to) {
    if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return {};
    std::error_code error(errno, std::generic_category());
    if (error != std::errc::invalid_argument) return error;  // else a file system without this operation
    std::error_code ignored;
    if (fs::exists(fs::symlink_status(to, ignored))) return std::make_error_code(std::errc::file_exists);
    fs::rename(from, to, error);
    return error;
}

/// Moves to the first free name with a number.
std::error_code move_to_kept(const fs::path& from, const fs::path& stem, const fs::path& extension, fs::path& to) {
    for (int number = 1;; ++number) {
        to = stem;
        to += k_kept_mark + std::to_string(number);
        to += extension;
        const std::error_code error = move_to_free(from, to);
        if (error != std::errc::file_exists) return error;
    }
}

/// Whether a program would read the file of this name together with another (NAME.tif.aux.xml with NAME.tif).
bool belongs_to_file(const std::string& name) {
    for (std::size_t end = name.find_first_of(".-", name.rfind('/') + 1); end != std::string::npos;
         end = name.find_first_of(".-", end + 1)) {
        const ResultFile* file = existing_file(name.substr(0, end));
        if (file != nullptr && (file->kind == FileKind::raster || file->kind == FileKind::vector ||
                                file->kind == FileKind::picture || file->kind == FileKind::stack))
            return true;
    }
    return false;
}

/// Names with a fixed meaning in every result: such a file of the older one must not be read as one of the new.
bool is_a_results_own_name(const std::string& name) {
    const ResultFile* file = existing_file(name);
    return file != nullptr && file->pattern.find('*') == std::string::npos;
}

class Replacement {
  public:
    Replacement(fs::path older, fs::path result, const Manifest& manifest, RunLog& log)
        : older_(std::move(older)), result_(std::move(result)), manifest_(manifest), log_(log) {}

    std::vector<Problem> run() {
        walk("");
        // Nothing is removed from a folder if a part of it could not be read or moved.
        if (problems_.empty()) remove_listed();
        report();
        return std::move(problems_);
    }

  private:
    void walk(const std::string& folder) {
        std::vector<fs::directory_entry> entries;
        try {
            entries = folder_entries(older_ / folder);
        } catch (const Error& error) {
            problem("a folder of the older result " + error.problems().front().what, folder);
            return;
        }
        for (const fs::directory_entry& entry : entries) {
            std::error_code ignored;
            const std::string name = entry.path().lexically_relative(older_).generic_string();
            const fs::file_status status = entry.symlink_status(ignored);
            if (fs::is_directory(status) && (has_listed(name) || is_folder(result_ / name))) {
                walk(name);
                folders_.push_back(name);
            } else if (fs::is_regular_file(status) && is_as_listed(name)) {
                listed_.push_back(name);
            } else {
                keep(name);
            }
        }
    }

    static bool is_folder(const fs::path& path) {
        std::error_code ignored;
        return fs::is_directory(fs::symlink_status(path, ignored));
    }

    [[nodiscard]] bool has_listed(const std::string& folder) const {
        const auto next = manifest_.files.lower_bound(folder + "/");
        return next != manifest_.files.end() && next->first.starts_with(folder + "/");
    }

    [[nodiscard]] bool is_as_listed(const std::string& name) const {
        if (name == k_manifest_file || name == k_replaced_file || name == k_building_file) return true;
        const auto listed = manifest_.files.find(name);
        if (listed == manifest_.files.end()) return is_leftover(name);
        std::error_code error;
        if (fs::file_size(older_ / name, error) != listed->second.bytes || error) return false;
        try {
            return mark_of((older_ / name).string()) == listed->second;
        } catch (const Error&) {
            return false;  // a file that cannot be read is not listed
        }
    }

    void keep(const std::string& name) {
        const fs::path from = older_ / name;
        fs::path to = result_ / name;
        std::error_code error;
        fs::create_directories(to.parent_path(), error);
        const bool is_changed = manifest_.files.count(name) > 0;
        const bool has_own_name = !is_changed && !belongs_to_file(name) && !is_a_results_own_name(name);
        error = has_own_name ? move_to_free(from, to) : std::make_error_code(std::errc::file_exists);
        if (error == std::errc::file_exists) {
            const fs::path stem = to.parent_path() / to.stem(), extension = to.extension();
            error = move_to_kept(from, stem, extension, to);
            if (!error)
                kept_.push_back(name + (is_changed ? ", which was changed since frana wrote it, " : " ") +
                                "is kept as " + to.lexically_relative(result_).string());
        }
        if (error) problem("a file of yours could not be moved into the new result: " + error.message(), name);
    }

    void remove_listed() {
        // List and note are removed after everything that they describe: after a kill or a problem the next run can
        // complete the removal.
        const std::vector<std::string> last{k_manifest_file, k_replaced_file};
        std::erase_if(listed_, [&](const std::string& name) { return name == last.front() || name == last.back(); });
        std::sort(folders_.rbegin(), folders_.rend());  // subfolders first
        std::error_code error;
        for (const std::vector<std::string>& names : {listed_, folders_, last, {""}})
            for (const std::string& name : names) {
                if (error) break;
                fs::remove(older_ / name, error);
            }
        if (!error) return;
        log_.warn(worded("the older result could not be removed: {1}; what is left of it is in {2} until the next run",
                         {error.message(), older_.string()}));
        try {
            if (fs::is_empty(older_)) note_replaced(older_.string(), older_.filename().string());
        } catch (const std::exception&) {  // then it remains as an empty folder
        }
    }

    void problem(const std::string& what, const std::string& name) {
        constexpr std::size_t k_most = 10;
        if (problems_.size() < k_most)
            problems_.push_back({what, (older_ / name).string(), "", "",
                                 "It is still there; the new result is complete in " + result_.string()});
    }

    void report() {
        constexpr std::size_t k_most = 20;
        for (std::size_t i = 0; i < std::min(k_most, kept_.size()); ++i) log_.info("older result: " + kept_[i]);
        if (kept_.size() > k_most)
            log_.info("older result: " + std::to_string(kept_.size() - k_most) +
                      " more files are kept under such names");
    }

    fs::path older_, result_;
    const Manifest& manifest_;
    RunLog& log_;
    std::vector<std::string> listed_, folders_, kept_;
    std::vector<Problem> problems_;
};

}  // namespace

std::vector<Problem> replace_result(const std::string& older, const std::string& result, RunLog& log) {
    try {
        if (const std::optional<Manifest> manifest = read_manifest(older))
            return Replacement(older, result, *manifest, log).run();
    } catch (const Error& error) {  // the next run tries again
        return error.problems();
    }
    std::error_code ignored;
    fs::remove(fs::path(older) / k_replaced_file, ignored);
    if (fs::remove(older, ignored)) return {};  // it was empty: a run was killed before it completed this
    fs::path kept;
    if (const std::error_code error = move_to_kept(older, result, "", kept))
        return {{"the older result could not be renamed: " + error.message(), older, "", "",
                 "It is still there; the new result is complete in " + result}};
    log.info("the older result does not list its files: it is kept whole in " + kept.string());
    return {};
}

void keep_changed_files(const std::vector<std::string>& paths) {
    for (const std::string& path : changed_files(paths)) {
        const fs::path file = path;
        fs::path kept;
        if (const std::error_code error = move_to_kept(file, file.parent_path() / file.stem(), file.extension(), kept))
            throw Error(
                ErrorKind::environment,
                Problem{"was changed since frana wrote it, and cannot be kept under another name: " + error.message(),
                        path, "", "", "Choose another folder with --out"});
        std::cerr << "frana: " << path << " is not as frana wrote it: kept as " << kept.filename().string() << '\n';
    }
}

}  // namespace frana::app
