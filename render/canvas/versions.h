// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace frana::render {

/// Returns the versions of VTK and FFmpeg's libav at run time: one "NAME VERSION" per line.
std::string library_versions();

}  // namespace frana::render
