// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace frana::facade {

/// Returns the folder of material presets: that of FRANA_SHARE, else the one installed with this library. Throws
/// Error(environment) if there is none.
std::string presets_directory();

}  // namespace frana::facade
