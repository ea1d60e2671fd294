// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/words/number_text.h"

namespace frana::app {

using frana::grouped;
using frana::number_text;

/// Returns a unit as print has it: "m³/s" for m3/s, "°" for degrees.
std::string unit_sign(const std::string& unit);

/// Returns "Run-out [m]"; the title alone without a unit ("" or "-").
std::string with_unit(const std::string& title, const std::string& unit);

/// Formats to three digits, with a plus before a positive number.
std::string signed_number_text(double value);

/// Returns "12.3 MB".
std::string bytes_text(double bytes);
/// Returns "95 s", "2.5 min", "3 h".
std::string duration_text(double seconds);

/// Returns the local date, "2026-11-24".
std::string today();

}  // namespace frana::app
