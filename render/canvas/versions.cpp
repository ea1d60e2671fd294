// SPDX-License-Identifier: Apache-2.0
#include "render/canvas/versions.h"

#include <pango/pangocairo.h>
#include <vtkVersion.h>

extern "C" {
#include <libavutil/avutil.h>
}

namespace frana::render {

std::string library_versions() {
    return std::string("VTK ") + vtkVersion::GetVTKVersion() + "\nCairo " + cairo_version_string() + "\nPango " +
           pango_version_string() + "\nFFmpeg " + av_version_info() + "\n";
}

}  // namespace frana::render
