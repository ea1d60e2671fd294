// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "core/colour.h"

namespace frana {

/// Escapes a text for HTML and XML, for elements and attributes, as it can be shown (shown_text).
std::string escaped_markup(std::string_view text);

/// Returns a colour as "#0072b2", the form of HTML, SVG and layer styles.
std::string hex(Rgb colour);

}  // namespace frana
