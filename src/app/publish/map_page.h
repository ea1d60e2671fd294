// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pictures/map_source.h"
#include "app/pictures/result_reader.h"

namespace frana::app {

/// Writes map.html into a result's folder, from the files that are in it: one page without any request, which shows
/// relief, rasters, outlines and frames, and tells the values at a place and along a line. Values are rounded to a
/// hundredth of their least class; of more than a million cells round the flow, blocks have their greatest value. Pages
/// have at most 6 MB: the last layers are left out, and named. Throws Error(environment) also without Leaflet.
void write_map_page(const ResultReader& result, const MapSource& source);

}  // namespace frana::app
