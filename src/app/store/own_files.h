// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/error.h"

namespace frana::app {

/// Returns the paths that the value of a key may mean: a file, or one in GDAL's syntax ("file|layer=a",
/// "DRIVER:file:part", "/vsizip/file/part").
std::vector<std::string> spellings(const std::string& source);

/// The files that a command must not change: its inputs and the data of results. A file is identified by its place on
/// the disk, whatever path, symbolic link or second name leads to it.
class KeptFiles {
  public:
    /// Adds the file named by a key or an option, which may use GDAL's syntax ("file|layer=a", "DRIVER:file:part",
    /// "/vsizip/file/part"). A name that is not a file on this disk is ignored.
    void add(const std::string& source);
    /// Adds everything in a result's folder except the pictures and animations drawn from it, and the files that its
    /// scene names.
    /// @param but files in it that are to be rewritten
    void add_result(const std::string& folder, const std::vector<std::string>& but = {});

    /// Adds a problem for every output that is one of them. `where` names the option that specifies the place.
    void check(const std::vector<std::string>& outputs, const std::string& where, Problems& problems) const;
    /// Also for every existing .tif not drawn by frana: a picture never replaces a raster.
    void check_pictures(const std::vector<std::string>& outputs, const std::string& where, Problems& problems) const;

  private:
    [[nodiscard]] bool has(const std::string& path) const;

    std::set<std::pair<std::uint64_t, std::uint64_t>> files_;  ///< device and inode
};

/// For commands that write to a folder which need not be a result: they replace only files written by frana. These are
/// listed in the manifest of the result that is or contains the folder, or in one of the folder.

/// Adds a problem for a folder that is, or is in, a result other than those read, since files of different results
/// would mix; and for every output that exists in a folder without a list of frana's files, since it belongs to the
/// user. If there is a list, keep_changed_files() keeps those that were changed.
/// @param where the option that specifies the place
/// @param reads results, or files in them, that the command reads and may write into
void check_own(const std::string& folder, const std::vector<std::string>& files, const std::string& where,
               const std::vector<std::string>& reads, Problems& problems);

/// Call before the first of the files is written: creates a list in a folder without one, so that files are identified
/// after a kill and changed ones are kept; record_files() lists them at the end. Throws Error(environment).
void begin_own(const std::string& folder, const std::vector<std::string>& files);

/// Removes files of a series (frames of a longer animation) that frana wrote to a folder and does not rewrite: listed,
/// unchanged and not among these. `belongs` identifies the series by names in the folder. Throws Error(environment).
void clear_own(const std::string& folder, const std::vector<std::string>& files,
               const std::function<bool(const std::string& name)>& belongs);

/// Called before files are rewritten: those that are in a result, exist, and differ from its manifest belong to the
/// user and get such a name. Reported on stderr. Files outside results may be replaced. Throws Error(environment).
void keep_changed_files(const std::vector<std::string>& paths);

}  // namespace frana::app
