// SPDX-License-Identifier: Apache-2.0
#include "app/store/result_directory.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <optional>
#include <set>
#include <system_error>
#include <thread>
#include <utility>

#include "app/store/checkpoints.h"
#include "app/store/interrupted_run.h"
#include "app/store/manifest.h"
#include "app/store/replace_result.h"
#include "app/store/result_files.h"
#include "app/store/result_place.h"
#include "app/store/unfinished_results.h"
#include "app/text/text_file.h"
#include "core/files.h"

namespace frana::app {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& what, const std::string& path, const std::string& reason) {
    throw Error(ErrorKind::environment,
                Problem{what + ": " + reason, path, "", "", "Check the place's rights and free space"});
}

/// Lists every file of frana below a folder in which a result was built, and syncs each to the disk. What a killed
/// program left half written is removed: nothing is in the making any more.
void list_files(const fs::path& result, const fs::path& folder, Manifest& manifest) {
    for (const fs::directory_entry& entry : folder_entries(folder)) {
        const fs::file_status status = entry.symlink_status();
        if (fs::is_directory(status)) list_files(result, entry.path(), manifest);
        if (!fs::is_regular_file(status)) continue;
        const std::string name = entry.path().lexically_relative(result).generic_string();
        if (name == k_manifest_file || name == k_building_file || existing_file(name) == nullptr) continue;
        std::error_code ignored;
        if (file_in_making(name))
            fs::remove(entry.path(), ignored);
        else
            manifest.files[name] = mark_on_disk(entry.path().string());
    }
    sync_path(folder.string());
}

Manifest manifest_of(const fs::path& folder, const ResultFacts& facts) {
    Manifest manifest{facts.scene_hash, facts.simulated_seconds, facts.finished, {}};
    list_files(folder, folder, manifest);
    return manifest;
}

}  // namespace

ResultDirectory::ResultDirectory(const std::string& directory, bool overwrite, const std::string& left)
    : directory_(result_path(directory)), aside_(left), overwrite_(overwrite), made_(left.empty()) {
    if (made_) {
        make_sibling();
    } else {
        // Another run's check of the lock may hold it for a moment.
        for (int tries = 0; lock_ < 0 && tries < 10; ++tries) {
            if (tries > 0) std::this_thread::sleep_for(std::chrono::milliseconds(20));
            lock_ = lock_folder(aside_, false);
        }
        if (lock_ < 0) refuse();
    }
    if (another_run_builds(directory_, aside_)) refuse();
}

void ResultDirectory::make_sibling() {
    std::error_code error;
    fs::create_directories(fs::path(directory_).parent_path(), error);
    if (error) fail("cannot be made", fs::path(directory_).parent_path().string(), error.message());
    std::string name = directory_ + k_building + "XXXXXX";
    if (::mkdtemp(name.data()) == nullptr) fail("no folder can be created beside it", directory_, std::strerror(errno));
    aside_ = name;
    // mkdtemp restricts access; a result gets the permissions of the one before it, or of any folder of the user.
    const mode_t mask = ::umask(0);
    ::umask(mask);
    struct stat older {};
    const bool is_there = ::stat(directory_.c_str(), &older) == 0;
    fs::permissions(aside_, static_cast<fs::perms>(is_there ? older.st_mode & 07777 : 0777 & ~mask), error);
    lock_ = lock_folder(aside_, true);  // another run's check of the lock may hold it for a moment
    try {
        note_building(aside_, directory_);
    } catch (const Error&) {
        ::rmdir(aside_.c_str());
        if (lock_ >= 0) ::close(lock_);
        throw;
    }
}

// Called by the constructor: the destructor does not run.
void ResultDirectory::refuse() {
    if (made_) remove_unfinished(aside_);
    if (lock_ >= 0) ::close(lock_);
    throw Error(ErrorKind::input, Problem{"another run is writing this result now", directory_, "", "",
                                          "Wait for it, or choose another folder with --out"});
}

ResultDirectory::~ResultDirectory() {
    try {
        if (!published_ && !has_saved_work(aside_)) remove_unfinished(aside_);
    } catch (const Error&) {
        published_ = true;  // files that cannot be read remain for the next run
    }
    if (lock_ >= 0) ::close(lock_);
}

std::string ResultDirectory::path(const std::string& name) const {
    return (fs::path(aside_) / name).string();
}

void ResultDirectory::make_folder(const std::string& name) const {
    std::error_code error;
    fs::create_directories(path(name), error);
    if (error) fail("cannot be made", path(name), error.message());
}

std::vector<Problem> ResultDirectory::publish(const ResultFacts& facts, RunLog& log) {
    write_manifest(aside_, manifest_of(aside_, facts));
    const bool replaces = has_files(directory_);
    if (replaces && !overwrite_)  // another program was faster; the computed result is not discarded
        keep_unpublished("another result has appeared there meanwhile", "");
    if (replaces) {
        try {
            note_replaced(directory_, fs::path(aside_).filename().string());
        } catch (const Error&) {  // only a kill in the next moments would lose it
        }
    }
    // The two are exchanged atomically: a result exists at every moment.
    const bool exchanged =
        replaces && ::renameat2(AT_FDCWD, aside_.c_str(), AT_FDCWD, directory_.c_str(), RENAME_EXCHANGE) == 0;
    if (!exchanged) replace_in_steps(replaces);  // not supported by the file system, or there is no older result
    published_ = true;
    std::error_code ignored;
    fs::remove(fs::path(directory_) / k_building_file, ignored);
    sync_path(fs::path(directory_).parent_path().string());
    ::close(std::exchange(lock_, -1));  // later changes of the manifest need the lock
    return tidy_up(replaces, log);
}

void ResultDirectory::replace_in_steps(bool replaces) {
    const std::string waiting = aside_ + ".old";
    std::error_code error, ignored;
    if (replaces) {
        fs::rename(directory_, waiting, error);
        if (error) keep_unpublished("the older result cannot be moved away", error.message());
    }
    fs::rename(aside_, directory_, error);
    if (error) {
        if (replaces) fs::rename(waiting, directory_, ignored);
        keep_unpublished("the result cannot take its name", error.message());
    }
    if (replaces) fs::rename(waiting, aside_, ignored);
}

void ResultDirectory::keep_unpublished(const std::string& what, const std::string& reason) {
    const std::string kept = directory_ + ".kept-" + aside_.substr(aside_.rfind('-') + 1);
    std::error_code error, ignored;
    fs::rename(aside_, kept, error);
    if (!error) fs::remove(fs::path(kept) / k_building_file, ignored);
    fs::remove(fs::path(directory_) / k_replaced_file, ignored);
    published_ = true;
    fail(what, directory_, (reason.empty() ? "" : reason + "; ") + "the new one is kept in " + (error ? aside_ : kept));
}

std::vector<Problem> ResultDirectory::tidy_up(bool replaces, RunLog& log) {
    const std::size_t lines = log.lines().size();
    const std::vector<Problem> problems = clear_place_of(directory_, replaces ? aside_ : "", log);
    if (log.lines().size() > lines) {
        write_text_file(final_path(k_log_file), log.text());
        record_files({final_path(k_log_file)});
    }
    return problems;
}

std::string ResultDirectory::final_path(const std::string& name) const {
    return (fs::path(directory_) / name).string();
}

namespace {

// Removes unfinished files of killed programs in a complete result.
void remove_leftovers(const fs::path& result, const fs::path& folder) {
    for (const fs::directory_entry& entry : folder_entries(folder)) {
        std::error_code ignored;
        const fs::file_status status = entry.symlink_status(ignored);
        if (fs::is_directory(status)) remove_leftovers(result, entry.path());
        if (fs::is_regular_file(status) && is_leftover(entry.path().lexically_relative(result).generic_string()))
            fs::remove(entry.path(), ignored);
    }
}

}  // namespace

std::vector<Problem> clear_place_of(const std::string& result, const std::string& replaced, RunLog& log) {
    std::vector<Problem> problems;
    std::vector<std::string> older = replaced_results(result);
    if (!replaced.empty() && std::find(older.begin(), older.end(), replaced) == older.end()) older.push_back(replaced);
    for (const std::string& folder : older) {
        const int mine = lock_folder(folder, false);
        if (mine < 0 && errno == EWOULDBLOCK) continue;  // another run is processing it
        const std::vector<Problem> more = replace_result(folder, result, log);
        problems.insert(problems.end(), more.begin(), more.end());
        if (mine >= 0) ::close(mine);
    }
    for (const std::string& folder : abandoned_results(result)) {
        if (!remove_unfinished(folder))
            log.info("a killed run has left " + folder + "; it contains files that frana did not write, and is kept");
    }
    remove_empty_siblings(result);
    remove_note_of_building(result);
    return problems;
}

void remove_working_files(const std::string& result, bool frames, RunLog& log) {
    const std::optional<Manifest> manifest = read_manifest(result);
    if (!manifest) return;
    std::vector<std::string> folders{k_checkpoint_folder, k_page_folder, k_record_folder, k_whole_frames, k_cut_frames},
        removed;
    if (frames) folders.emplace_back(k_frame_folder);
    std::error_code error, ignored;
    for (const std::string& folder : folders) {
        std::set<fs::path> inner;  // of a calibration: the records of each event
        for (const auto& [name, mark] : manifest->files) {
            if (!name.starts_with(folder + "/")) continue;
            for (fs::path parent = fs::path(name).parent_path(); parent != folder; parent = parent.parent_path())
                inner.insert(parent);
            fs::remove(fs::path(result) / name, error);
            if (error) {
                log.warn(worded("{1} is no longer needed and cannot be removed: {2}; --resume tries again",
                                {(fs::path(result) / name).string(), error.message()}));
            } else {
                removed.push_back(name);
            }
        }
        for (auto one = inner.rbegin(); one != inner.rend(); ++one) fs::remove(fs::path(result) / *one, ignored);
        fs::remove(fs::path(result) / folder, ignored);  // unless the user has files in it
    }
    remove_from_manifest(result, removed);
    remove_leftovers(result, result);
}

}  // namespace frana::app
