// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace frana {

/// Returns the number of letters to insert, delete, replace or swap with their neighbour to turn one word into the
/// other.
int edit_distance(std::string_view a, std::string_view b);

/// Returns the "section.key" most likely meant: nearest by spelling, or the same key in another section. Empty if none
/// is near enough to help.
std::string nearest_name(const std::string& name, const std::vector<std::string>& known);

}  // namespace frana
