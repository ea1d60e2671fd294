// SPDX-License-Identifier: Apache-2.0
#include "app/result_directory.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <thread>

#include "app/checkpoints.h"
#include "app/layers.h"

namespace frana::app {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& what, const std::string& path, const std::string& reason) {
    throw Error(ErrorKind::environment,
                Problem{what + ": " + reason, path, "", "", "Check the place's rights and free space"});
}

/// Between a result's name and what tells its siblings apart.
constexpr const char* k_building = ".partial-";

/// Trailing slashes would hide the folder's own name.
fs::path clean(const std::string& directory) {
    fs::path path = fs::absolute(directory).lexically_normal();
    return path.has_filename() ? path : path.parent_path();
}

/// The nearest folder above that is there already.
fs::path existing_parent(fs::path path) {
    std::error_code ignored;
    do path = path.parent_path();
    while (!fs::exists(path, ignored) && path.has_relative_path());
    return path;
}

bool is_result(const fs::path& directory) {
    return fs::exists(directory / "summary.json") && fs::exists(directory / "scene.ini");
}

bool is_inside(const fs::path& path, const fs::path& directory) {
    const fs::path relative = path.lexically_relative(directory);
    return !relative.empty() && *relative.begin() != "..";
}

/// Locks a folder for as long as the descriptor that is returned stays open; the system lets go of it when the
/// program ends, however it ends. -1, with errno, where somebody else holds it; `wait`: until nobody does.
int lock(const std::string& folder, bool wait) {
    const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) return -1;
    if (::flock(descriptor, wait ? LOCK_EX : LOCK_EX | LOCK_NB) == 0) return descriptor;
    const int reason = errno;
    ::close(descriptor);
    errno = reason;
    return -1;
}

/// Names in a result directory that frana itself writes; everything else there is the user's.
bool is_ours(const std::string& name) {
    static const std::vector<std::string> k_names{"scene.ini",
                                                  "summary.json",
                                                  "timeseries.csv",
                                                  "log.txt",
                                                  "extent.gpkg",
                                                  "frames",
                                                  "maps",
                                                  "charts",
                                                  k_checkpoint_folder,
                                                  "animation.mp4",
                                                  "animation.gif",
                                                  "comparison.json",
                                                  "comparison.png",
                                                  "comparison_curve.csv",
                                                  "report.html",
                                                  "gauges.csv",
                                                  "sections.csv",
                                                  "gauges.gpkg",
                                                  "profiles.csv",
                                                  "profiles.gpkg",
                                                  "hazard_zones.gpkg",
                                                  "hazard_zones.qml",
                                                  "hazard_zones.sld",
                                                  "peakFiles",
                                                  "frames.nc",
                                                  "frames.zarr"};
    if (std::find(k_names.begin(), k_names.end(), name) != k_names.end()) return true;
    std::vector<std::string> rasters{"release", "dtm", "bed", "comparison", "hazard", "max_flux", "max_head"};
    for (const Layer& layer : all_layers()) rasters.push_back(layer.name);
    for (const std::string& raster : rasters)
        for (const char* ending : {".tif", ".qml", ".sld"})
            if (name == raster + ending) return true;
    return false;
}

}  // namespace

std::string result_path(const std::string& directory) {
    return clean(directory).string();
}

void check_result_directory(const std::string& directory, bool overwrite,
                            const std::vector<std::string>& inputs, const std::string& where,
                            Problems& problems) {
    const fs::path path = clean(directory);
    std::error_code failure;
    if (fs::exists(path, failure) && !fs::is_directory(path, failure)) {
        problems.add(
            {"is a file, not a folder", where, path.string(), "", "Choose another result directory"});
        return;
    }
    if (fs::is_directory(path, failure) && !fs::is_empty(path, failure)) {
        if (!is_result(path)) {
            problems.add({"is a folder with other files in it, not a result; it is never overwritten", where,
                          path.string(), "", "Choose an empty or new folder with --out"});
        } else if (!overwrite) {
            problems.add({"holds a result already", where, path.string(), "",
                          checkpoints_in(path.string()).empty()
                              ? "Choose another folder with --out, or add --overwrite"
                              : "It was stopped before its end: --resume goes on, --overwrite starts anew"});
        }
        for (const std::string& input : inputs) {
            if (is_inside(input, path) && fs::path(input) != path / "scene.ini" &&
                is_ours(fs::path(input).lexically_relative(path).begin()->string())) {
                problems.add({"would be replaced by the result while it is read", where, input, "",
                              "Choose another result directory with --out"});
            }
        }
    }
    const fs::path parent = existing_parent(path);
    if (!fs::is_directory(parent, failure)) {
        problems.add({"cannot be written: " + parent.string() + " is not a folder", where, path.string(), "",
                      "Choose another result directory with --out"});
    } else if (::access(parent.c_str(), W_OK | X_OK) != 0) {
        Problem problem{std::string("cannot be written: ") + std::strerror(errno), where, path.string(), "",
                        "Choose another result directory with --out"};
        if (problems.empty()) throw Error(ErrorKind::environment, problem);
        problems.add(problem);
    }
}

std::vector<std::string> unfinished_results(const std::string& directory) {
    const fs::path result = clean(directory);
    const std::string beginning = result.filename().string() + k_building;
    std::vector<std::pair<fs::file_time_type, std::string>> found;
    std::error_code failure;
    for (const fs::directory_entry& entry : fs::directory_iterator(result.parent_path(), failure)) {
        if (entry.path().filename().string().rfind(beginning, 0) == 0)
            found.emplace_back(entry.last_write_time(failure), entry.path().string());
    }
    std::sort(found.rbegin(), found.rend());
    std::vector<std::string> folders;
    for (const auto& [time, folder] : found) folders.push_back(folder);
    return folders;
}

std::vector<std::string> left_results(const std::string& directory) {
    std::vector<std::string> folders = unfinished_results(directory);
    std::erase_if(folders, [](const std::string& folder) {
        const int descriptor = lock(folder, false);
        if (descriptor < 0) return true;
        ::close(descriptor);
        return false;
    });
    std::sort(folders.begin(), folders.end());
    return folders;
}

ResultDirectory::ResultDirectory(const std::string& directory, bool overwrite, const std::string& left)
    : directory_(clean(directory).string()), aside_(left), overwrite_(overwrite), made_(left.empty()) {
    if (made_) {
        make_sibling();
    } else {
        // Another run's look at it takes a moment.
        for (int tries = 0; lock_ < 0 && tries < 10; ++tries) {
            if (tries > 0) std::this_thread::sleep_for(std::chrono::milliseconds(20));
            lock_ = lock(aside_, false);
        }
        if (lock_ < 0) refuse();
    }
    refuse_a_second_run();
}

void ResultDirectory::make_sibling() {
    std::error_code failure;
    fs::create_directories(fs::path(directory_).parent_path(), failure);
    if (failure) fail("cannot be made", fs::path(directory_).parent_path().string(), failure.message());
    std::string name = directory_ + k_building + "XXXXXX";
    if (::mkdtemp(name.data()) == nullptr)
        fail("no folder can be made beside it", directory_, std::strerror(errno));
    aside_ = name;
    // mkdtemp keeps others out; a result is as readable as any folder of the user's.
    const mode_t mask = ::umask(0);
    ::umask(mask);
    fs::permissions(aside_, static_cast<fs::perms>(0777 & ~mask), failure);
    lock_ = lock(aside_, true);  // another run's look at it takes a moment
}

void ResultDirectory::refuse_a_second_run() {
    for (const std::string& folder : unfinished_results(directory_)) {
        if (folder == aside_) continue;
        const int other = lock(folder, false);
        if (other >= 0) {
            ::close(other);  // left behind by a run that was killed
        } else if (errno == EWOULDBLOCK) {
            refuse();
        }
    }
}

// From the constructor: the destructor does not come.
void ResultDirectory::refuse() {
    std::error_code ignored;
    if (made_) fs::remove_all(aside_, ignored);
    if (lock_ >= 0) ::close(lock_);
    throw Error(ErrorKind::input, Problem{"another run is writing this result now", directory_, "", "",
                                          "Wait for it, or choose another folder with --out"});
}

ResultDirectory::~ResultDirectory() {
    std::error_code ignored;
    if (!published_ && checkpoints_in(aside_).empty()) fs::remove_all(aside_, ignored);
    if (lock_ >= 0) ::close(lock_);
}

std::string ResultDirectory::path(const std::string& name) const {
    return (fs::path(aside_) / name).string();
}

void ResultDirectory::make_folder(const std::string& name) const {
    std::error_code failure;
    fs::create_directories(path(name), failure);
    if (failure) fail("cannot be made", path(name), failure.message());
}

void ResultDirectory::publish() {
    std::error_code failure;
    const bool replaces = fs::is_directory(directory_, failure) && !fs::is_empty(directory_, failure);
    if (replaces && !overwrite_) {
        // Somebody else was faster; what was computed is not thrown away.
        const std::string kept = directory_ + ".kept-" + aside_.substr(aside_.rfind('-') + 1);
        fs::rename(aside_, kept, failure);
        published_ = true;
        fail("another result has appeared there meanwhile", directory_,
             "this one is kept in " + (failure ? aside_ : kept));
    }
    // The two change places in one go: at no moment is there none.
    const bool exchanged =
        replaces && ::renameat2(AT_FDCWD, aside_.c_str(), AT_FDCWD, directory_.c_str(), RENAME_EXCHANGE) == 0;
    const std::string old = exchanged ? aside_ : aside_ + ".old";
    if (!exchanged) {  // a file system that cannot, or nothing there
        if (replaces) {
            fs::rename(directory_, old, failure);
            if (failure) fail("the older result cannot be moved away", directory_, failure.message());
        }
        fs::rename(aside_, directory_, failure);
        if (failure) {
            std::error_code ignored;
            if (replaces) fs::rename(old, directory_, ignored);
            fail("the result cannot take its name", directory_, failure.message());
        }
    }
    published_ = true;
    if (replaces) keep_users_files(old);
    remove_leftovers();
}

void ResultDirectory::forget_the_way(bool frames) const {
    std::error_code ignored;
    fs::remove_all(fs::path(directory_) / k_checkpoint_folder, ignored);
    if (frames) fs::remove_all(fs::path(directory_) / "frames", ignored);
}

void ResultDirectory::keep_users_files(const std::string& old) const {
    std::error_code failure;
    for (const fs::directory_entry& entry : fs::directory_iterator(old, failure)) {
        const std::string name = entry.path().filename().string();
        if (is_ours(name)) continue;
        std::error_code kept;
        fs::rename(entry.path(), fs::path(directory_) / name, kept);
        if (kept) fail("a file of yours could not be kept; it is still in " + old, name, kept.message());
    }
    fs::remove_all(old, failure);
}

// What is not ours stays: an older result's files of the user's may be there, if a run was killed while it moved them.
void ResultDirectory::remove_leftovers() const {
    for (const std::string& folder : left_results(directory_)) {
        std::error_code failure;
        const bool all_ours = std::all_of(fs::directory_iterator(folder, failure), fs::directory_iterator(),
                                          [](const fs::directory_entry& entry) {
                                              const std::string name = entry.path().filename().string();
                                              return is_ours(name) || name.find(".partial") != std::string::npos;
                                          });
        if (all_ours && !failure) fs::remove_all(folder, failure);
    }
}

}  // namespace frana::app
