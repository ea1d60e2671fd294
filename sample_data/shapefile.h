// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/geometry.h"

namespace frana::sample {

/// Writes a shapefile of one polygon with a text attribute "name", in a CRS given by its EPSG code. The date in its
/// attribute table is fixed, so that writing it again gives the same bytes. Throws Error(environment).
void write_shapefile(const std::string& path, int epsg, const Ring& outline, const std::string& name);

}  // namespace frana::sample
