// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace frana {

/// Letters to insert, delete, replace or swap with their neighbour to turn one word into the other.
int edit_distance(std::string_view a, std::string_view b);

/// The "section.key" a user most likely meant: nearest by spelling, or the same key in another section.
/// Empty when nothing is near enough to be a help.
std::string nearest_name(const std::string& name, const std::vector<std::string>& known);

}  // namespace frana
