// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace frana::app {

/// Returns a name no longer than `most` bytes: a longer one ends in eight digits of its hash instead, so that long
/// names with the same beginning differ.
std::string shortened_name(const std::string& name, std::size_t most = 100);

/// Returns file names for names of the user, one for each: letters, digits and hyphens are kept, all else becomes '_'.
/// All are different, also if case is ignored: names that would be equal get eight digits of their hash, one that
/// needed no change is kept. The same names give the same files in any order.
std::vector<std::string> file_stems(const std::vector<std::string>& names);

}  // namespace frana::app
