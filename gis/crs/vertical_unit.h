// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace frana::gis {

/// The unit of a raster's values.
struct VerticalUnit {
    std::string name = "metre";
    double metres = 1;    ///< per unit
    bool known = true;    ///< false: the file names a unit that is not a length; values are unchanged
    bool stated = false;  ///< specified in the file
};

/// Returns the unit of a band's unit text ("m", "ft", "US survey foot", "" for none), else of the CRS's vertical part.
VerticalUnit vertical_unit_of(const std::string& band_unit, const std::string& crs_wkt);

/// Returns the unit of a user's choice: "metre", "foot", "us-survey-foot". Throws Error(input) for another word.
VerticalUnit vertical_unit_named(const std::string& name);

}  // namespace frana::gis
