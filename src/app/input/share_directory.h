// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace frana::app {

/// The folder with materials and examples: $FRANA_SHARE, else ../share/frana beside the program's folder
/// (installed), else the source's share (built in place). Throws Error(environment) when none of them is
/// there.
std::string share_directory();

/// Its folder of material presets.
std::string materials_directory();

}  // namespace frana::app
