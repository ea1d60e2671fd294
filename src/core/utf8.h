// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace frana {

/// Bytes of the character that begins at `at`, 1 to 4; 0 where the text there is not UTF-8: a stray, missing or
/// overlong byte, a surrogate, a code above U+10FFFF.
std::size_t utf8_length(std::string_view text, std::size_t at) noexcept;

/// The text with every byte that is not UTF-8 written out as "\xe9": names of files and attributes may hold any bytes,
/// and JSON, HTML, GeoPackage and CSV may not. What is UTF-8 stays as it is.
std::string valid_utf8(std::string_view text);

/// The same with control characters written out as well ("\x0a"), so that the text stays on one line.
std::string one_line(std::string_view text);

/// The first `most` characters of a text, the last of them an ellipsis where there were more. What is not UTF-8 counts
/// byte by byte.
std::string elided(std::string_view text, std::size_t most);

}  // namespace frana
