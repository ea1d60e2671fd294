// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/input/prepare.h"

namespace frana::app {

/// What makes a run what it is, one fact a line: every resolved key but those that only say when checkpoints are taken,
/// the working grid, and a checksum of what was read of each file (Prepared::files). Two runs with the same identity
/// give the same bits.
std::string scene_identity(const Prepared& prepared);

/// The key in summary.json of what data_identity tells.
inline constexpr const char* k_data_key = "file_checksums";

/// The part of it that the scene's keys do not tell: of the grid and of what was read from files. summary.json keeps
/// it.
std::vector<std::string> data_identity(const Prepared& prepared);
/// The whole, of a finished result: from its scene.ini and its summary.json; none where an older frana left them.
std::optional<std::string> result_identity(const std::string& result_folder);

/// In words what differs between two identities: "time.end is 20 here and was 10", at most a few.
std::vector<std::string> identity_differences(const std::string& here, const std::string& then);

}  // namespace frana::app
