// SPDX-License-Identifier: Apache-2.0
#include "app/commands/library_versions.h"

#include <boost/version.hpp>

#include "gis/access/gdal_session.h"
#include "render/canvas/page.h"

namespace frana::app {

std::string library_versions() {
    const std::string boost = std::to_string(BOOST_VERSION / 100000) + "." +
                              std::to_string(BOOST_VERSION / 100 % 1000) + "." + std::to_string(BOOST_VERSION % 100);
    return gis::library_versions() + render::library_versions() + "Boost " + boost + "\nbuilt with " + FRANA_COMPILER +
           "\n";
}

}  // namespace frana::app
