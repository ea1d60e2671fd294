// SPDX-License-Identifier: Apache-2.0
#include "render/canvas/versions.h"

#include <pango/pangocairo.h>

namespace frana::render {

std::string library_versions() {
    return std::string("VTK " FRANA_VTK_VERSION "\nCairo ") + cairo_version_string() + "\nPango " +
           pango_version_string() + "\nFFmpeg libavcodec " FRANA_LIBAVCODEC_VERSION "\n";
}

}  // namespace frana::render
