// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace frana::app {

/// A name no longer than `most` bytes: what is longer ends in eight digits of its hash instead, so that long names that
/// begin alike stay apart.
std::string shortened_name(const std::string& name, std::size_t most = 100);

/// Names of files for names of the user's, one for each: letters, digits and hyphens stay, all else becomes '_'. No two
/// are alike, not even where capitals count as small letters: names that would be get eight digits of their hash, one
/// that needed no change keeps itself. The same names give the same files in any order.
std::vector<std::string> file_stems(const std::vector<std::string>& names);

}  // namespace frana::app
