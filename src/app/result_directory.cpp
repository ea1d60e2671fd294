// SPDX-License-Identifier: Apache-2.0
#include "app/result_directory.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "app/layers.h"

namespace frana::app {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& what, const std::string& path, const std::string& reason) {
    throw Error(ErrorKind::environment,
                Problem{what + ": " + reason, path, "", "", "Check the place's rights and free space"});
}

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
                          "Choose another folder with --out, or add --overwrite"});
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
    if (!fs::is_directory(parent, failure) || ::access(parent.c_str(), W_OK | X_OK) != 0) {
        problems.add(
            {std::string("cannot be written: ") + (fs::is_directory(parent, failure)
                                                       ? std::strerror(errno)
                                                       : (parent.string() + " is not a folder").c_str()),
             where, path.string(), "", "Choose another result directory with --out"});
    }
}

ResultDirectory::ResultDirectory(std::string directory, bool overwrite)
    : directory_(clean(directory).string()), overwrite_(overwrite) {
    std::error_code failure;
    fs::create_directories(fs::path(directory_).parent_path(), failure);
    if (failure) fail("cannot be made", fs::path(directory_).parent_path().string(), failure.message());
    std::string name = directory_ + ".partial-XXXXXX";
    if (::mkdtemp(name.data()) == nullptr)
        fail("no folder can be made beside it", directory_, std::strerror(errno));
    aside_ = name;
    // mkdtemp keeps others out; a result is as readable as any folder of the user's.
    const mode_t mask = ::umask(0);
    ::umask(mask);
    fs::permissions(aside_, static_cast<fs::perms>(0777 & ~mask), failure);
    lock_ = lock(aside_, true);  // another run's look at it takes a moment
    refuse_a_second_run();
}

void ResultDirectory::refuse_a_second_run() const {
    const fs::path own(aside_);
    const std::string beginning = fs::path(directory_).filename().string() + ".partial-";
    std::error_code failure;
    for (const fs::directory_entry& entry : fs::directory_iterator(own.parent_path(), failure)) {
        if (entry.path() == own || entry.path().filename().string().rfind(beginning, 0) != 0) continue;
        const int other = lock(entry.path().string(), false);
        if (other >= 0) {
            ::close(other);  // left behind by a run that was killed
        } else if (errno == EWOULDBLOCK) {
            fs::remove_all(own, failure);  // the destructor does not come
            ::close(lock_);
            throw Error(ErrorKind::input, Problem{"another run is writing this result now", directory_, "", "",
                                                  "Wait for it, or choose another folder with --out"});
        }
    }
}

ResultDirectory::~ResultDirectory() {
    if (lock_ >= 0) ::close(lock_);
    std::error_code ignored;
    if (!published_) fs::remove_all(aside_, ignored);
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
    const std::string old = aside_ + ".old";
    const bool replaces = fs::is_directory(directory_, failure) && !fs::is_empty(directory_, failure);
    if (replaces && !overwrite_) {
        published_ = true;  // somebody else was faster; what was computed is not thrown away
        fail("another result has appeared there meanwhile", directory_, "this one is kept in " + aside_);
    }
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
    published_ = true;
    if (!replaces) return;
    for (const fs::directory_entry& entry : fs::directory_iterator(old, failure)) {
        const std::string name = entry.path().filename().string();
        if (is_ours(name)) continue;
        std::error_code kept;
        fs::rename(entry.path(), fs::path(directory_) / name, kept);
        if (kept) fail("a file of yours could not be kept; it is still in " + old, name, kept.message());
    }
    fs::remove_all(old, failure);
}

}  // namespace frana::app
