// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/input/prepare.h"

namespace frana::app {

/// Returns everything that determines a run, one fact per line: every resolved key except those for the times of
/// checkpoints, the working grid, and a checksum of the data read from each file (Prepared::files). Two runs with the
/// same identity have the same bits.
std::string scene_identity(const Prepared& prepared);

/// The key of data_identity in summary.json.
inline constexpr const char* k_data_key = "file_checksums";

/// Returns the part of it not given by the scene's keys: the grid and the data read from files. Stored in summary.json.
std::vector<std::string> data_identity(const Prepared& prepared);
/// Returns the whole identity of a complete result: from its scene.ini and its summary.json; none if an older frana
/// wrote them.
std::optional<std::string> result_identity(const std::string& result_folder);

/// Returns the differences between two identities as text: "time.end is 20 here and was 10", at most a few.
std::vector<std::string> identity_differences(const std::string& here, const std::string& then);

}  // namespace frana::app
