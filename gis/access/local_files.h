// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace frana::gis {

/// Puts a door before the files of this machine through which GDAL and its drivers go: FIFOs, devices and
/// sockets are not opened (a Refusal says so), whatever file names them. GdalSession does so once.
void guard_local_files();

/// The same for a path that a driver would not even try; true if it is such.
bool refuse_special_file(const char* path);

/// While one lives, no library writes a file on this thread: GML's .gfs, .aux.xml, .properties of an archive.
/// Nothing that frana reads gets a file beside it.
class ReadingOnly {
  public:
    ReadingOnly() noexcept;
    ~ReadingOnly();
    ReadingOnly(const ReadingOnly&) = delete;
    ReadingOnly& operator=(const ReadingOnly&) = delete;
};

}  // namespace frana::gis
