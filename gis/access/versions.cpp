// SPDX-License-Identifier: Apache-2.0
#include "gis/access/versions.h"

#include <gdal.h>
#include <ogr_api.h>
#include <proj.h>

namespace frana::gis {

std::string library_versions() {
    int major = 0, minor = 0, micro = 0;
    std::string text = std::string("GDAL ") + GDALVersionInfo("RELEASE_NAME") + "\n";
    if (OGRGetGEOSVersion(&major, &minor, &micro))
        text += "GEOS " + std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(micro) + "\n";
    return text + "PROJ " + proj_info().version + "\n";
}

}  // namespace frana::gis
