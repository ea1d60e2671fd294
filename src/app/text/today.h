// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace frana::app {

/// Returns the local date, "2026-11-24".
std::string today();

}  // namespace frana::app
