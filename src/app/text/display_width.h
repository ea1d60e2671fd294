// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace frana::app {

/// Returns the columns that a UTF-8 text takes on a terminal: wide letters (Chinese) two, combining accents none. A
/// byte that is not UTF-8 counts one.
std::size_t display_width(std::string_view text);

/// Returns the number of bytes of the longest beginning that takes at most so many columns; at least one character.
std::size_t bytes_within(std::string_view text, std::size_t columns);

/// Wraps at spaces so that no line is wider; a wider word is broken. A newline in the text starts another line.
std::vector<std::string> wrapped(const std::string& text, std::size_t columns);

/// Pads with spaces to so many columns, on the left if `right`.
std::string padded(const std::string& text, std::size_t columns, bool right = false);

}  // namespace frana::app
