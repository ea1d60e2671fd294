// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace frana::gis {

/// GDAL with GEOS, and PROJ, as they run: one "NAME VERSION" a line.
std::string library_versions();

}  // namespace frana::gis
