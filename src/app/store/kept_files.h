// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
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

}  // namespace frana::app
