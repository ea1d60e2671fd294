// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace frana::app {

/// Returns a unit as print has it: "m³/s" for m3/s, "°" for degrees.
std::string unit_sign(const std::string& unit);

/// Formats to three digits, with a plus before a positive number.
std::string signed_number_text(double value);

}  // namespace frana::app
