// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "core/error.h"
#include "core/files.h"

namespace frana::gis {

/// A folder of GDAL's in memory. If the disk fails for a moment while GDAL writes its tiles, a wrong file can remain
/// without an error; therefore files are made here, and frana itself writes their bytes to the disk and checks each
/// write. A raster's file needs as much memory as its size on the disk, besides the raster itself.
class MemoryFolder {
  public:
    MemoryFolder();
    /// Deletes its files.
    ~MemoryFolder();
    MemoryFolder(const MemoryFolder&) = delete;
    MemoryFolder& operator=(const MemoryFolder&) = delete;

    /// Returns where GDAL must write the file for a path on the disk; files beside it are written with it.
    [[nodiscard]] std::string place_of(const std::string& path) const;
    /// Writes all its files to the folder of `path`, synced to the disk. Throws Error(environment).
    void write_to_disk(const std::string& path, Sync sync = Sync::yes) const;

  private:
    std::string folder_;
};

/// An access that a library requested while reading a file and that was refused: an address on the network, a special
/// file.
struct AccessProblem {
    std::string what, value, remedy;  ///< as in Problem
};

/// Called by the filters of the libraries' access (network, local files). The function that reads the file reports the
/// first.
void note_access_problem(AccessProblem problem);

/// Returns the first since the last call, if any: the cause of the library's error.
[[nodiscard]] std::optional<AccessProblem> pop_access_problem();

/// Filters all access of GDAL and its drivers to local files: FIFOs, devices and sockets are not opened (a refused
/// access is noted), whatever file names them. GdalSession calls it once.
void guard_local_files();

/// The same for a path that a driver would not try to open; returns true for such a path.
bool refuse_special_file(const char* path);

/// While an instance exists, no library writes a file on this thread: GML's .gfs, .aux.xml, .properties of an archive.
/// No file is created beside one that frana reads.
class ReadingOnly {
  public:
    ReadingOnly();
    ~ReadingOnly();
    ReadingOnly(const ReadingOnly&) = delete;
    ReadingOnly& operator=(const ReadingOnly&) = delete;
};

/// Limits the time of the libraries' calls on files: while one exists, a call that takes longer than the limit (a query
/// in a database that never ends, a file that never arrives) ends the program with exit code 2, since no library can be
/// interrupted. Of several at once, each that begins, and each call that returns, gives all the whole limit again.
class TimeLimit {
  public:
    /// `where` names key and file; the outermost is told.
    explicit TimeLimit(const Place& where);
    ~TimeLimit();
    TimeLimit(const TimeLimit&) = delete;
    TimeLimit& operator=(const TimeLimit&) = delete;
    /// Called after a call returned.
    void again() noexcept;
};

/// Sets the limit [s], once, before files are read; without it there is none.
void limit_reading(unsigned seconds);

/// Returns whether GDAL may read over the network (URLs, /vsicurl/, databases, map services); see allow_network().
[[nodiscard]] bool network_allowed();

/// Returns the remedy for a path that is not on this machine; none if it is, or if the network is allowed.
[[nodiscard]] std::optional<std::string> network_remedy(const std::string& path);

/// Removes GDAL's network drivers and file systems; GdalSession calls it once unless the network was allowed.
void disable_network();

}  // namespace frana::gis
