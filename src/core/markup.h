// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "core/colour.h"

namespace frana {

/// Returns a text as a page or picture can show it, with bytes that are not UTF-8 escaped (valid_utf8): control
/// characters, marks that turn the direction of letters and codes that are no letters are spaces. XML has no form for
/// them, and a name must not reorder the text around it.
std::string shown_text(std::string_view text);

/// Escapes a text for HTML and XML, for elements and attributes, as it can be shown (shown_text).
std::string escaped_markup(std::string_view text);

/// Returns a colour as "#0072b2", the form of HTML, SVG and layer styles.
std::string hex(Rgb colour);

}  // namespace frana
