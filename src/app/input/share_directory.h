// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace frana::app {

/// Returns the folder with materials, hazard schemes and examples: $FRANA_SHARE, else share/frana beside the program
/// (in a build) or ../share/frana from there (installed). Throws Error(environment) if none of them exists.
std::string share_directory();

/// Returns its folder of material presets.
std::string materials_directory();

}  // namespace frana::app
