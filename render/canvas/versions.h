// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace frana::render {

/// VTK and FFmpeg's libav, as they run: one "NAME VERSION" a line.
std::string library_versions();

}  // namespace frana::render
