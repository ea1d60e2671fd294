// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/error.h"

namespace frana::app {

/// Paths that may be meant by what a key names: a file, or one that GDAL's spellings lead to ("file|layer=a",
/// "DRIVER:file:part", "/vsizip/file/part").
std::vector<std::string> spellings(const std::string& source);

/// The files that a command must leave as they are: its inputs and the data of results. A file is known by where it
/// lies on the disk, whatever path, symbolic link or second name leads there.
class KeptFiles {
  public:
    /// What a key or an option names: a file, or one that GDAL's spellings lead to ("file|layer=a", "DRIVER:file:part",
    /// "/vsizip/file/part"). What is no file on this disk is left out.
    void add(const std::string& source);
    /// Everything in a result's folder but the pictures and animations that were drawn from it, and the files that its
    /// scene names.
    /// @param but files in it that are to be written again
    void add_result(const std::string& folder, const std::vector<std::string>& but = {});

    /// Adds a problem for every file to be written that is one of them. `where` names the option that says the place.
    void check(const std::vector<std::string>& outputs, const std::string& where, Problems& problems) const;
    /// Also for every .tif that is there already and was not drawn by frana: a picture never takes a raster's place.
    void check_pictures(const std::vector<std::string>& outputs, const std::string& where, Problems& problems) const;

  private:
    [[nodiscard]] bool has(const std::string& path) const;

    std::set<std::pair<std::uint64_t, std::uint64_t>> files_;  ///< device and inode
};

}  // namespace frana::app
