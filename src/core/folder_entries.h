// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace frana {

/// Returns the entries of a folder, sorted by name; none if the folder does not exist. A read interrupted by a signal
/// is repeated. Throws Error(environment) if the folder cannot be read: that is not the same as empty.
std::vector<std::filesystem::directory_entry> folder_entries(const std::filesystem::path& folder);

}  // namespace frana
