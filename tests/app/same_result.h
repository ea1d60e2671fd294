// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace frana::test {

/// Returns every file below a folder, sorted, as relative paths.
std::vector<std::string> files_below(const std::string& folder);

/// Expects the same files in two results, with the same lasting bytes. Returns their number.
std::size_t expect_same_files(const std::string& expected, const std::string& result);

}  // namespace frana::test
