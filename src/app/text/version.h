// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace frana::app {

inline constexpr const char* k_program = "frana";
/// Set by the build from the project's version.
inline constexpr const char* k_version = FRANA_VERSION;

/// Format of result directories, in summary.json; increases when the meaning of a file or key of share/doc/results.md
/// changes. Results without it are older and can be read.
inline constexpr long k_result_format = 1;

/// Format of a result's manifest.json.
inline constexpr long k_manifest_format = 1;

}  // namespace frana::app
