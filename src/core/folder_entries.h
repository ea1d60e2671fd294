// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace frana {

/// What lies in a folder, sorted by name; nothing where there is no such folder. A look that a signal
/// interrupts is repeated. Throws Error(environment) where the folder cannot be read: that is not the same as
/// empty.
std::vector<std::filesystem::directory_entry> folder_entries(const std::filesystem::path& folder);

}  // namespace frana
