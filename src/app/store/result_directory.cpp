// SPDX-License-Identifier: Apache-2.0
#include "app/store/result_directory.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <optional>
#include <set>
#include <system_error>
#include <thread>

#include "app/store/checkpoints.h"
#include "app/store/interrupted_run.h"
#include "app/store/manifest.h"
#include "app/store/own_files.h"
#include "app/store/result_files.h"
#include "core/files.h"

namespace frana::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* k_choose = "Choose another result directory with --out";

/// Resolves the folders above it; its own name is kept as given. Trailing slashes would hide that name.
fs::path clean(const fs::path& directory) {
    fs::path path = fs::absolute(directory);
    while (!path.has_filename() && path.has_relative_path()) path = path.parent_path();
    std::error_code error;
    const fs::path name = path.filename();
    const bool is_named = name != "." && name != "..";
    const fs::path real = fs::weakly_canonical(is_named ? path.parent_path() : path, error);
    if (error) return path.lexically_normal();
    return is_named ? real / name : real;
}

/// Returns the nearest existing folder above a path.
fs::path existing_parent(fs::path path) {
    std::error_code ignored;
    do path = path.parent_path();
    while (!fs::exists(path, ignored) && path.has_relative_path());
    return path;
}

bool is_inside(const fs::path& path, const fs::path& directory) {
    const fs::path relative = path.lexically_relative(directory);
    return !relative.empty() && *relative.begin() != "..";
}

/// Returns the greatest length of a result's name: it is built beside its place under a longer name.
long longest_name(const fs::path& path) {
    const long most = ::pathconf(existing_parent(path).c_str(), _PC_NAME_MAX);
    return (most > 0 ? most : 255) - static_cast<long>(std::string(k_partial).size());
}

/// SQLite, which writes the GeoPackages, opens no path of more bytes, with those of its journal; inside a result the
/// names of files and folders, and of files in the making, need this much.
constexpr std::size_t k_longest_path = 512, k_room = 112;

/// Returns the problem if permissions or the disk do not allow the folder to be made, or replaced; else none.
std::optional<std::string> refusal(const fs::path& path) {
    const fs::path parent = existing_parent(path);
    if (::faccessat(AT_FDCWD, parent.c_str(), W_OK | X_OK, AT_EACCESS) != 0) return std::strerror(errno);
    if (::faccessat(AT_FDCWD, path.c_str(), F_OK, AT_EACCESS) != 0) return std::nullopt;
    if (::faccessat(AT_FDCWD, path.c_str(), R_OK | W_OK | X_OK, AT_EACCESS) != 0)
        return std::string("the existing folder may not be changed: ") + std::strerror(errno);
    return std::nullopt;
}

constexpr const char* k_move = "Move them to another folder, or choose another result directory with --out";

void check_older(const fs::path& path, Older older, const Place& where, Problems& problems) {
    const std::optional<Manifest> manifest = read_manifest(path.string());
    if (!manifest) {
        problems.add(
            {"is a folder with other files, not a result; it is never overwritten", where, path.string(), "",
             "Choose an empty or new folder with --out (a result without its manifest.json counts as such a one)"});
    } else if (older == Older::refused) {
        problems.add({"contains a result already", where, path.string(), "",
                      manifest->finished || checkpoints_in(path.string()).empty()
                          ? "Choose another folder with --out, or add --overwrite"
                          : "It was stopped before its end: --resume continues it, --overwrite starts anew"});
    } else if (older == Older::replaced) {
        if (const auto users = users_files(path.string()); !users.empty())
            problems.add({"contains " + told(users), where, path.string(), "", k_move});
    }
}

/// Inputs must not be in the result's folder, whatever their names.
void check_inputs(const fs::path& result, const std::vector<std::string>& inputs, const Place& where,
                  Problems& problems) {
    const auto would_be_replaced = [&](const std::string& place) {
        std::error_code error;
        const fs::path real = fs::weakly_canonical(place, error);
        return !error && fs::exists(real, error) && is_inside(real, result) && real != result / k_scene_file &&
               real != result / k_study_file;  // read before, and rewritten
    };
    for (const std::string& input : inputs) {
        const std::vector<std::string> places = spellings(input);
        if (std::any_of(places.begin(), places.end(), would_be_replaced))
            problems.add({"is an input and would be replaced by the result", where, input, "", k_choose});
    }
}

}  // namespace

std::string result_path(const std::string& directory) {
    return clean(directory).string();
}

bool has_files(const std::string& folder) {
    std::error_code error;
    if (!fs::is_directory(folder, error)) return false;
    const bool is_empty = fs::is_empty(folder, error);
    return error || !is_empty;
}

Problem other_run(const std::string& result) {
    return {"another run is writing this result now", result, "", "",
            "Wait for it, or choose another folder with --out"};
}

std::optional<Problem> partial_problem(const std::string& partial) {
    std::error_code error;
    if (fs::is_symlink(partial, error))
        return Problem{"is a symbolic link: the result would be built elsewhere", partial, "", "",
                       "Remove it, or choose another folder with --out"};
    if (!has_files(partial)) return {};
    if (!is_being_built(partial) && !is_being_replaced(partial))
        return Problem{"was not made by frana, which builds the result in a folder of this name", partial, "", "",
                       k_move};
    const auto users = users_files(partial);
    if (users.empty()) return {};
    return Problem{"was left by a run that was killed and contains " + told(users), partial, "", "", k_move};
}

std::optional<Problem> check_result_directory(const std::string& directory, Older older,
                                              const std::vector<std::string>& inputs, const Place& where,
                                              Problems& problems) {
    const fs::path path = result_path(directory);
    std::error_code error;
    if (fs::is_symlink(path, error)) {
        problems.add({"is a symbolic link, which a result would replace", where, path.string(), "",
                      "Name the folder that it leads to"});
        return {};
    }
    if (fs::exists(path, error) && !fs::is_directory(path, error)) {
        problems.add({"is a file, not a folder", where, path.string(), "", "Choose another result directory"});
        return {};
    }
    if (const long most = longest_name(path); static_cast<long>(path.filename().string().size()) > most)
        problems.add({"has a name that is too long", where, path.filename().string(),
                      "at most " + std::to_string(most) + " bytes here", "Choose a shorter one with --out"});
    if (const std::size_t bytes = path.string().size(); bytes > k_longest_path - k_room)
        problems.add({"has a path that is too long: GeoPackages in it could not be written", where,
                      std::to_string(bytes) + " bytes", "at most " + std::to_string(k_longest_path - k_room) + " bytes",
                      "Choose a folder nearer to the root with --out"});
    try {
        if (has_files(path.string())) check_older(path, older, where, problems);
        const std::string partial = partial_folder(directory);
        const bool is_written = is_locked(partial);
        if (is_written && older != Older::unknown) problems.add(other_run(path.string()));
        if (const auto problem = is_written ? std::nullopt : partial_problem(partial)) problems.add(*problem);
    } catch (const Error& error_of_disk) {
        return error_of_disk.problems().front();
    }
    check_inputs(path, inputs, where, problems);
    const fs::path parent = existing_parent(path);
    if (!fs::is_directory(parent, error)) {
        problems.add(
            {"cannot be written: " + parent.string() + " is not a folder", where, path.string(), "", k_choose});
    } else if (const auto reason = refusal(path)) {
        return Problem{"cannot be written: " + *reason, where, path.string(), "", k_choose};
    }
    return {};
}

namespace {

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
            manifest.files[name] = size_on_disk(entry.path().string());
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

void ResultDirectory::publish(const ResultFacts& facts, Findings found) {
    write_manifest(partial_, manifest_of(partial_, facts));
    if (has_files(directory_))
        replace_older();
    else if (std::rename(partial_.c_str(), directory_.c_str()) != 0)
        fail("the result cannot take its name", directory_, std::strerror(errno) + kept_in(partial_), rights());
    published_ = true;
    sync_path(fs::path(directory_).parent_path().string());
    lock_.reset();  // later changes of the manifest need it
    remove_partial(directory_, found);
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
    // A file system without this operation. What is removed is the program's own; if it is killed here, the new result
    // is complete beside the place.
    std::error_code error = remove_own_files(directory_);
    if (!error) fs::remove(directory_, error);
    if (!error) fs::rename(partial_, directory_, error);
    if (error) fail("the result cannot take its name", directory_, error.message() + kept_in(partial_), rights());
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

void remove_working_files(const std::string& result, bool frames, Findings found) {
    const std::optional<Manifest> manifest = read_manifest(result);
    if (!manifest) return;
    std::vector<std::string> folders{k_checkpoint_folder, k_page_folder, k_record_folder, k_whole_frames, k_cut_frames},
        removed;
    if (frames) folders.emplace_back(k_frame_folder);
    std::error_code error, ignored;
    for (const std::string& folder : folders) {
        std::set<fs::path> inner;  // of a calibration: the records of each event
        for (const auto& [name, bytes] : manifest->files) {
            if (!name.starts_with(folder + "/")) continue;
            for (fs::path parent = fs::path(name).parent_path(); parent != folder; parent = parent.parent_path())
                inner.insert(parent);
            fs::remove(fs::path(result) / name, error);
            if (error) {
                found.warn(worded("{1} cannot be removed: {2}; --resume tries again",
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
    remove_partial(result, found);
}

}  // namespace frana::app
