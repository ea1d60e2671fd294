// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "core/colour.h"

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

/// Returns the shortest decimal text that reads back as the same double ("0.1", "1e+20"); "nan", "inf", "-inf" for
/// non-finite values.
std::string shortest_text(double value);

/// Returns a text as a page or picture can show it, with bytes that are not UTF-8 escaped (valid_utf8): control
/// characters, marks that turn the direction of letters and codes that are no letters are spaces. XML has no form for
/// them, and a name must not reorder the text around it.
std::string shown_text(std::string_view text);

/// Escapes a text for HTML and XML, for elements and attributes, as it can be shown (shown_text).
std::string escaped_markup(std::string_view text);

/// Returns a colour as "#0072b2", the form of HTML, SVG and layer styles.
std::string hex(Rgb colour);

/// Encodes bytes in the base64 alphabet (RFC 4648), for data URLs.
std::string base64(std::string_view bytes);

/// Limits of a number.
struct NumberRange {
    double lowest = 0;
    double highest = 0;
    bool lowest_excluded = false, highest_excluded = false;

    [[nodiscard]] bool has(double value) const {
        return (lowest_excluded ? value > lowest : value >= lowest) &&
               (highest_excluded ? value < highest : value <= highest);
    }
    [[nodiscard]] std::string text() const {
        return (lowest_excluded ? "greater than " : "") + shortest_text(lowest) +
               (highest_excluded  ? ", less than "
                : lowest_excluded ? ", at most "
                                  : " to ") +
               shortest_text(highest);
    }
};

}  // namespace frana
