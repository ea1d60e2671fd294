// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "core/colour.h"

namespace frana {

/// A text for HTML and XML, in elements and in attributes: what they read as their own is written out, and so are bytes
/// that are not UTF-8 (valid_utf8).
std::string escaped_markup(std::string_view text);

/// "#0072b2", as HTML, SVG and the styles of layers write colours.
std::string hex(Rgb colour);

}  // namespace frana
