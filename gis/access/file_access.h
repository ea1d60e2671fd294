// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>
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

/// Limits the time of the libraries' calls on a file during its lifetime: if a single call takes longer (a query in a
/// database that never ends, a file that never arrives), `when_time_is_up` is called on another thread. No library can
/// be interrupted, so that function ends the program.
class TimeLimit {
  public:
    /// `where` names key and file.
    explicit TimeLimit(Place where);
    ~TimeLimit();
    TimeLimit(const TimeLimit&) = delete;
    TimeLimit& operator=(const TimeLimit&) = delete;

    /// Called after a call returned: the next one has the whole limit again.
    void again() noexcept;

    /// For the watching thread only.
    [[nodiscard]] std::int64_t begun() const noexcept { return begun_; }
    [[nodiscard]] std::int64_t deadline() const noexcept { return deadline_; }
    [[nodiscard]] const std::string& where() const noexcept { return where_; }

  private:
    Place where_;
    std::int64_t begun_;                  ///< as the deadline
    std::atomic<std::int64_t> deadline_;  ///< [ms] of the steady clock
};

/// Sets the function called then, once, before files are read; without it there is no limit. `seconds` per call.
void when_time_is_up(double seconds, void (*end)(const Problem&));

/// Sets the function that reports a file on which the libraries have spent some seconds, every ten seconds: its `where`
/// and the duration. Must be set before the other.
void on_slow_reading(void (*warn)(const std::string& where, double seconds));

/// Returns whether GDAL may read over the network (URLs, /vsicurl/, databases, map services); see allow_network().
[[nodiscard]] bool network_allowed();

/// Returns the remedy for a path that is not on this machine; none if it is, or if the network is allowed.
[[nodiscard]] std::optional<std::string> network_remedy(const std::string& path);

/// Removes GDAL's network drivers and file systems; GdalSession calls it once unless the network was allowed.
void disable_network();

}  // namespace frana::gis
