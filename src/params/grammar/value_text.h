// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
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

/// Returns the text without white space at either end.
std::string trimmed(const std::string& text);

/// Reads a finite number with a decimal point from the whole text; none otherwise.
std::optional<double> number_from_text(const std::string& text);
std::optional<std::int64_t> integer_from_text(const std::string& text);
/// Reads on, true, yes, 1 and off, false, no, 0.
std::optional<bool> boolean_from_text(const std::string& text);

/// Returns the parts between commas or white space, without empty ones.
std::vector<std::string> words_of(const std::string& text);

std::string joined(const std::vector<std::string>& words, const std::string& separator);

}  // namespace frana
