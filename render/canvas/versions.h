// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace frana::render {

/// Returns the versions of Cairo and Pango at run time, and those of VTK and FFmpeg's libavcodec, which are not loaded
/// for this, that frana was built with: one "NAME VERSION" per line.
std::string library_versions();

}  // namespace frana::render
