// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/colour.h"

namespace frana::gis {

/// A class that a raster names: its value, its label (the value where none is given), its colour.
struct NamedClass {
    int value = 0;
    std::string label;
    Rgb colour;
};

/// What a raster file says about the values of its first band.
struct RasterText {
    std::string description;                      ///< of the band
    std::string unit;                             ///< of the values
    std::map<std::string, std::string> metadata;  ///< of the file: PROGRAM, TIME_S, ...
    std::vector<NamedClass> classes;              ///< where the band has a colour table: its visible entries
};

/// Throws Error(input) when the file cannot be read.
RasterText read_raster_text(const std::string& path);

}  // namespace frana::gis
