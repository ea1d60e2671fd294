// SPDX-License-Identifier: Apache-2.0
#include "render/canvas/versions.h"

#include <vtkVersion.h>

extern "C" {
#include <libavutil/avutil.h>
}

namespace frana::render {

std::string library_versions() {
    return std::string("VTK ") + vtkVersion::GetVTKVersion() + "\nFFmpeg " + av_version_info() + "\n";
}

}  // namespace frana::render
