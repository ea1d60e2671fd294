// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

namespace frana {

/// Formats for messages: `digits` significant digits, no exponent between 1e-4 and 1e15.
std::string number_text(double value, int digits = 4);
/// Formats in groups of three, "1 200 000"; below 10 with two significant digits, "0.015".
std::string grouped(double value);
std::string grouped(std::int64_t value);

}  // namespace frana
