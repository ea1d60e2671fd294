// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace frana::test {

/// Every file below a folder, sorted, as relative paths.
std::vector<std::string> files_below(const std::string& folder);

/// A file of a result without what tells the time of day, how long it took, on how many threads and in how
/// much memory.
std::string lasting_bytes(const std::string& result, const std::string& name);

/// Expects the same files in two results, with the same bytes but for those. Returns how many there are.
std::size_t expect_same_files(const std::string& expected, const std::string& result);

}  // namespace frana::test
