// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace frana::app {

inline constexpr const char* k_program = "frana";
/// Set by the build from the project's version.
inline constexpr const char* k_version = FRANA_VERSION;

}  // namespace frana::app
