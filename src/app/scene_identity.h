// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/prepare.h"

namespace frana::app {

/// What makes a run what it is, one fact a line: every resolved key but those that only say when checkpoints are taken,
/// the working grid, and a checksum of everything that was read from files. Two runs with the same identity give the
/// same bits.
std::string scene_identity(const Prepared& prepared);

/// In words what differs between two identities: "time.end is 20 here and was 10", at most a few.
std::vector<std::string> identity_differences(const std::string& here, const std::string& then);

}  // namespace frana::app
