// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/grid_spec.h"

class OGRSpatialReference;

namespace frana::gis {

/// WKT2:2019 of what a user wrote: "EPSG:32632", a PROJ string, WKT of any age. `where` names the file and
/// key for the message. Throws Error(input).
std::string crs_from_user(const std::string& text, const std::string& where);

/// WKT2:2019 of a vector layer's CRS; "" where it has none, or one that places nothing on the Earth.
std::string layer_crs(const OGRSpatialReference* crs);

/// For people: "EPSG:32632 (WGS 84 / UTM zone 32N)", or the bare name where no authority is known; "local"
/// for "".
std::string crs_name(const std::string& wkt);

/// Whether coordinates are eastings and northings in metres, so that a cell is a square on the ground.
bool is_projected_in_metres(const std::string& wkt);

/// Metres per unit of a projected CRS's coordinates; 1 for any other.
double metres_per_unit(const std::string& wkt);

/// The horizontal part alone: a working grid's CRS says nothing about heights.
std::string horizontal_crs(const std::string& wkt);

/// Metres per unit of the vertical part; 0 where there is none.
double vertical_metres_per_unit(const std::string& wkt);

/// A full turn of longitude in the units of a geographic CRS (360 degrees); 0 for any other CRS.
double longitude_turn(const std::string& wkt);

/// WKT of the WGS 84 / UTM zone (north or south) of a place given in degrees.
std::string utm_crs_for(double longitude, double latitude);

/// Degrees of WGS 84, longitude in x. Throws Error(input) where the projection has no inverse.
Point to_longitude_latitude(const std::string& wkt, Point map);

/// The angle at a place from grid north to true north, in degrees, positive clockwise. Zero for "" (local).
double meridian_convergence_deg(const std::string& wkt, Point map);

}  // namespace frana::gis
