// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace frana {

/// Returns the length in bytes of the character at `at`, 1 to 4; 0 if the text there is not UTF-8: a stray, missing or
/// overlong byte, a surrogate, a code above U+10FFFF.
std::size_t utf8_length(std::string_view text, std::size_t at) noexcept;

/// Returns the text with every byte that is not UTF-8 escaped as "\xe9": file names and attributes may contain any
/// bytes; JSON, HTML, GeoPackage and CSV may not. Valid UTF-8 is unchanged.
std::string valid_utf8(std::string_view text);

/// The same with control characters escaped as well ("\x0a"), so that the text stays on one line.
std::string one_line(std::string_view text);

/// Returns the first `most` characters of a text, the last replaced by an ellipsis if there are more. Bytes that are
/// not UTF-8 count one each.
std::string elided(std::string_view text, std::size_t most);

}  // namespace frana
