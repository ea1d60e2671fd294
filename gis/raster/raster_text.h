// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/colour.h"

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
};

/// Reads them. Throws Error(input) if the file cannot be read.
RasterText read_raster_text(const std::string& path);

}  // namespace frana::gis
