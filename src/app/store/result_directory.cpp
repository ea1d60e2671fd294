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
#include "app/store/partial_folder.h"
#include "app/store/result_files.h"
#include "app/store/result_place.h"
#include "core/files.h"

namespace frana::app {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& what, const std::string& path, const std::string& reason,
                       const std::string& remedy = "Check the place's rights and free space") {
    throw Error(ErrorKind::environment, Problem{what + ": " + reason, path, "", "", remedy});
}

std::string kept_in(const std::string& partial) {
    return "; the new result is complete in " + partial;
}

constexpr const char* k_publish_again = "publish it by the same command with --resume";

std::string rights() {
    return std::string("Check the place's rights and ") + k_publish_again;
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

ResultDirectory::ResultDirectory(const std::string& directory, bool overwrite, bool resumes)
    : directory_(result_path(directory)), partial_(partial_folder(directory)), overwrite_(overwrite) {
    std::error_code error;
    fs::create_directories(fs::path(directory_).parent_path(), error);
    if (error) fail("cannot be made", fs::path(directory_).parent_path().string(), error.message());
    // Another run's check of the lock may hold it for a moment, and one that ends may rename the folder.
    for (int tries = 0; !lock_ || !lock_->is_of(partial_); ++tries) {
        if (tries == 10 && lock_->reason() != EWOULDBLOCK)
            fail("cannot be opened", partial_, std::strerror(lock_->reason()));
        if (tries == 10) throw Error(ErrorKind::input, other_run(directory_));
        if (tries > 0) std::this_thread::sleep_for(std::chrono::milliseconds(20));
        if (::mkdir(partial_.c_str(), 0777) != 0 && errno != EEXIST)
            fail("no folder can be created beside it", directory_, std::strerror(errno));
        lock_.emplace(partial_, false);
    }
    if (!resumes) take_over();
}

/// Empties the folder and notes what it is.
void ResultDirectory::take_over() const {
    if (const auto problem = partial_problem(partial_)) throw Error(ErrorKind::input, *problem);
    std::error_code error = remove_own_files(partial_);
    if (error) fail("cannot be emptied", partial_, error.message());
    // A result gets the permissions of the one before it.
    struct stat older {};
    if (::stat(directory_.c_str(), &older) == 0)
        fs::permissions(partial_, static_cast<fs::perms>(older.st_mode & 07777), error);
    try {
        note_building(partial_);
    } catch (const Error&) {
        ::rmdir(partial_.c_str());
        throw;
    }
}

ResultDirectory::~ResultDirectory() {
    try {
        if (published_ || !is_being_built(partial_) || has_saved_work(partial_) || !users_files(partial_).empty())
            return;
        if (!remove_own_files(partial_)) ::rmdir(partial_.c_str());
    } catch (const Error&) {  // files that cannot be read remain for the next run
    }
}

std::string ResultDirectory::path(const std::string& name) const {
    return (fs::path(partial_) / name).string();
}

void ResultDirectory::make_folder(const std::string& name) const {
    std::error_code error;
    fs::create_directories(path(name), error);
    if (error) fail("cannot be made", path(name), error.message());
}

void ResultDirectory::publish(const ResultFacts& facts, RunLog& log) {
    write_manifest(partial_, manifest_of(partial_, facts));
    if (has_files(directory_))
        replace_older();
    else if (std::rename(partial_.c_str(), directory_.c_str()) != 0)
        fail("the result cannot take its name", directory_, std::strerror(errno) + kept_in(partial_), rights());
    published_ = true;
    sync_path(fs::path(directory_).parent_path().string());
    lock_.reset();  // later changes of the manifest need it
    remove_partial(directory_, log);
}

/// The two are exchanged atomically: a result exists at every moment.
void ResultDirectory::replace_older() {
    const FolderLock older(directory_, true);  // a command that adds pictures to it
    const std::vector<std::string> users = users_files(directory_);
    if (!overwrite_ || !users.empty())  // since the run began; the computed result is not discarded
        throw Error(ErrorKind::environment,
                    Problem{(overwrite_ ? "contains " + told(users) : "another result has appeared there meanwhile") +
                                kept_in(partial_),
                            directory_, "", "",
                            std::string("Move ") + (overwrite_ ? "these files" : "that result") + " elsewhere and " +
                                k_publish_again});
    note_replaced(directory_);
    if (::renameat2(AT_FDCWD, partial_.c_str(), AT_FDCWD, directory_.c_str(), RENAME_EXCHANGE) == 0) return;
    const std::string waiting = partial_ + k_waiting;  // a file system without this operation
    std::error_code error, ignored;
    fs::rename(directory_, waiting, error);
    if (error) fail("the older result cannot be moved away", directory_, error.message() + kept_in(partial_), rights());
    fs::rename(partial_, directory_, error);
    if (error) fs::rename(waiting, directory_, ignored);
    if (error) fail("the result cannot take its name", directory_, error.message() + kept_in(partial_), rights());
    fs::rename(waiting, partial_, ignored);
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
    remove_partial(result, log);
}

}  // namespace frana::app
