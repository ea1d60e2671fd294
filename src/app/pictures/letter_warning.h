// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace frana::app {

/// Returns a warning that names the letters on the pictures drawn since the last call for which no font is installed;
/// empty: there are none.
std::string letter_warning();

}  // namespace frana::app
