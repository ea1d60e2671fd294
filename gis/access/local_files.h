// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace frana::gis {

/// Filters all access of GDAL and its drivers to local files: FIFOs, devices and sockets are not opened (a refused
/// access is noted), whatever file names them. GdalSession calls it once.
void guard_local_files();

/// The same for a path that a driver would not try to open; returns true for such a path.
bool refuse_special_file(const char* path);

/// While an instance exists, no library writes a file on this thread: GML's .gfs, .aux.xml, .properties of an archive.
/// No file is created beside one that frana reads.
class ReadingOnly {
  public:
    ReadingOnly() noexcept;
    ~ReadingOnly();
    ReadingOnly(const ReadingOnly&) = delete;
    ReadingOnly& operator=(const ReadingOnly&) = delete;
};

}  // namespace frana::gis
