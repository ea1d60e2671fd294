// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace frana::app {

/// Returns the path of a member's record in the folder of a study's result that is being built.
std::string record_file(const std::string& folder, std::size_t member);
/// Returns the existing ones, also those of several studies whose folders are in the folder of records.
std::vector<std::string> records_in(const std::string& folder);

/// Returns whether a folder in which a result was being built has anything that --resume can use: checkpoints of a run,
/// records of a study's members.
bool has_saved_work(const std::string& folder);

/// Returns the folder in which a killed or stopped study left records of members for this result; empty: none.
std::string interrupted_study(const std::string& directory);

}  // namespace frana::app
