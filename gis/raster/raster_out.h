// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/colour.h"
#include "core/raster.h"

namespace frana::gis {

/// Item of metadata: the direction in which depths are measured, "vertical" or "normal to the bed".
inline constexpr const char* k_depth_item = "DEPTH";
/// Returns it; vertical where there is none, as in older files.
std::string depth_direction_in(const std::map<std::string, std::string>& metadata);

/// A class of a raster: its value, its label (the value if there is none), its colour.
struct NamedClass {
    int value = 0;
    std::string label;
    Rgb colour;
};

/// Texts of a raster file about its first band.
struct RasterText {
    std::string description;                      ///< of the band
    std::string unit;                             ///< of the values
    std::map<std::string, std::string> metadata;  ///< of the file: PROGRAM, TIME_S, ...
    std::vector<NamedClass> classes;              ///< its visible entries, if the band has a colour table
    std::vector<std::string> further;             ///< descriptions of the bands after it
};

/// Reads them. Throws Error(input) if the file cannot be read.
RasterText read_raster_text(const std::string& path);

/// The "no data" value of Float32 files.
inline constexpr double k_file_nodata = -9999;

/// The texts of a band.
struct BandText {
    std::string name;                             ///< "max_depth"
    std::string description;                      ///< "Maximum flow depth, vertical"
    std::string unit;                             ///< "m"
    std::map<std::string, std::string> metadata;  ///< program, version, ...
};

/// Results are read as a whole; of frames there are hundreds, most of each without data, and writing them takes
/// processor time from the run.
enum class RasterUse { result, frame };

/// Writes a Float32 cloud-optimised GeoTIFF with nodata -9999, overviews, statistics and texts inside; no file beside
/// it. In frames, blocks without data are omitted (sparse; they read as nodata), and rasters of up to 1024 cells a side
/// have no overviews: half the time. Made in memory, written aside, synced to the disk and renamed: on failure an older
/// file remains, and an incomplete file never gets the name. Throws Error(environment), also for a full disk.
void write_geotiff(const std::string& path, const Raster& raster, const BandText& text,
                   RasterUse use = RasterUse::result);

/// One band of a file with several.
struct RasterBand {
    const Raster& raster;
    BandText text;
    bool zero_elsewhere = false;  ///< on a large map: a cell that is not stored is 0, not NaN
};
/// The same with several bands, all on one grid and alike in zero_elsewhere.
void write_geotiff(const std::string& path, const std::vector<RasterBand>& bands);

/// One class of a classified raster.
struct ClassEntry {
    std::uint8_t value = 0;  ///< 1 to 254
    std::string label;
    Rgb colour;
};

/// The same with one byte per cell (NaN becomes 0, which is nodata), the classes' names and colours inside. Throws
/// Error(input) for a value that is not a class.
void write_class_geotiff(const std::string& path, const Raster& raster, const std::vector<ClassEntry>& classes,
                         const BandText& text);

}  // namespace frana::gis
