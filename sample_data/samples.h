// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace frana::sample {

/// Writes dtm.tif, thickness.tif (EPSG:32632), perimeter.shp (EPSG:4326) and scar.shp (EPSG:3003) to an existing
/// folder. Values are rounded (heights to 1 cm, coordinates to 1e-9 degrees or 1 mm), so that the files do not depend
/// on the last bits of a machine's mathematics. Throws Error(environment).
void write_bindo_sample(const std::string& folder);

/// Writes dtm.tif (EPSG:32632, 5 m: a mountain side with two gullies and their fan), slopes.geojson (a polygon of each
/// gully and scenario, with volumes), exposed.geojson (degrees: twenty houses, a road) and gauges.geojson to an
/// existing folder. Heights and coordinates are rounded. Throws Error(environment).
void write_fan_sample(const std::string& folder);

/// The flume's break of slope [m], and the block's path and the obstacle's side of it across the flume [m].
inline constexpr double k_flume_break = 1.2;
inline constexpr double k_block_south = 0.175, k_block_north = 0.425, k_obstacle_north = 0.275;

/// Writes the flume of section 3 of van den Bout et al. (2021), as far as its text specifies it, in plain metres:
/// dtm.tif (2.7 m x 0.6 m, cells of 5 mm), block.geojson, obstacle.geojson. The folder must exist. Throws
/// Error(environment).
void write_flume_sample(const std::string& folder);

/// Writes the two terrains of its section 4 in plain metres, cells of 10 m: break_dtm.tif and valley_dtm.tif with their
/// blocks, break_block.geojson and valley_block.geojson. The folder must exist. Throws Error(environment).
void write_fracture_sample(const std::string& folder);

/// Writes a valley behind a dam with a breach down to its floor, and the plain below, in plain metres, cells of 10 m:
/// dtm.tif, and the valley's outline, lake.geojson. The folder must exist. Throws Error(environment).
void write_reservoir_sample(const std::string& folder);

/// Writes a text aside and renames it. Throws Error(environment).
void write_text(const std::string& path, const std::string& text);

}  // namespace frana::sample
