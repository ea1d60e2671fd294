// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace frana::gis {

/// Returns the versions of GDAL with GEOS, and PROJ, at run time: one "NAME VERSION" per line.
std::string library_versions();

}  // namespace frana::gis
