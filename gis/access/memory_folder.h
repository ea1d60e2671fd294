// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "core/file_aside.h"

namespace frana::gis {

/// A folder of GDAL's in memory. A disk that fails for a moment while GDAL writes its tiles can leave a wrong file
/// without a word; so files are made here, and frana itself writes their bytes to the disk and sees to each.
/// A raster's file takes as much memory as it will take of the disk, beside the raster itself.
class MemoryFolder {
  public:
    MemoryFolder();
    /// Forgets what is in it.
    ~MemoryFolder();
    MemoryFolder(const MemoryFolder&) = delete;
    MemoryFolder& operator=(const MemoryFolder&) = delete;

    /// Where GDAL is to write the file that goes to a path on the disk; files beside it go with it.
    [[nodiscard]] std::string place_of(const std::string& path) const;
    /// Writes all files in it to the folder of `path`, brought to the disk. Throws Error(environment).
    void write_to_disk(const std::string& path, Sync sync = Sync::yes) const;

  private:
    std::string folder_;
};

}  // namespace frana::gis
