// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/error.h"
#include "core/grid_spec.h"

namespace frana::gis {

/// The unit of a raster's values.
struct VerticalUnit {
    std::string name = "m";
    double metres = 1;    ///< per unit
    bool known = true;    ///< false: the file names a unit that is not a length; values are unchanged
    bool stated = false;  ///< specified in the file
};

/// Returns the unit of a band's unit text ("m", "ft", "US survey foot", "" for none), else of the CRS's vertical part.
VerticalUnit vertical_unit_of(const std::string& band_unit, const std::string& crs_wkt);

/// Returns the unit of a user's choice: "metre", "foot", "us-survey-foot". Throws Error(input) for another word.
VerticalUnit vertical_unit_named(const std::string& name);
}  // namespace frana::gis

class OGRSpatialReference;

namespace frana::gis {

/// Returns the WKT2:2019 of a user's text: "EPSG:32632", a PROJ string, any version of WKT. `where` names file and key
/// for the message. Throws Error(input).
std::string crs_from_user(const std::string& text, const Place& where);

/// Returns the WKT2:2019 of a vector layer's CRS; "" if it has none, or one without a position on the Earth.
std::string layer_crs(const OGRSpatialReference* crs);

/// Returns a name for messages: "EPSG:32632 (WGS 84 / UTM zone 32N)", or the bare name if no authority is known;
/// "local" for "".
std::string crs_name(const std::string& wkt);

/// Returns whether coordinates are eastings and northings in metres, so that a cell is a square on the ground.
bool is_projected_in_metres(const std::string& wkt);

/// Returns the metres per unit of a projected CRS's coordinates; 1 for any other.
double metres_per_unit(const std::string& wkt);

/// Returns the horizontal part alone: a working grid's CRS does not define heights.
std::string horizontal_crs(const std::string& wkt);

/// Returns the metres per unit of the vertical part; 0 if there is none.
double vertical_metres_per_unit(const std::string& wkt);

/// Returns a full turn of longitude in the units of a geographic CRS (360 degrees); 0 for any other CRS.
double longitude_turn(const std::string& wkt);

/// Returns the WKT of the WGS 84 / UTM zone (north or south) of a place given in degrees.
std::string utm_crs_for(double longitude, double latitude);

/// Returns degrees of WGS 84, longitude in x. Throws Error(input) if the projection has no inverse.
Point to_longitude_latitude(const std::string& wkt, Point map);

/// Returns the angle at a place from grid north to true north, in degrees, positive clockwise. Zero for "" (local).
double meridian_convergence_deg(const std::string& wkt, Point map);

}  // namespace frana::gis
