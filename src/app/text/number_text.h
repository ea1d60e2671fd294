// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "core/grid_spec.h"

namespace frana::app {

/// Returns a unit as print has it: "m³/s" for m3/s, "°" for degrees.
std::string unit_sign(const std::string& unit);

/// Returns "Run-out [m]"; the title alone without a unit ("" or "-").
std::string with_unit(const std::string& title, const std::string& unit);

/// Formats to three digits, with a plus before a positive number.
std::string signed_number_text(double value);

/// Formats for messages: `digits` significant digits, no exponent between 1e-4 and 1e15.
std::string number_text(double value, int digits = 4);
/// Formats in groups of three, "1 200 000"; below 10 with two significant digits, "0.015".
std::string grouped(double value);
std::string grouped(std::int64_t value);
/// Returns "12.3 MB".
std::string bytes_text(double bytes);
/// Returns "95 s", "2.5 min", "3 h".
std::string duration_text(double seconds);

/// Returns the local date, "2026-11-24".
std::string today();

}  // namespace frana::app
