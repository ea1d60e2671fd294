// SPDX-License-Identifier: Apache-2.0
#include "core/shortest_text.h"

#include <array>
#include <charconv>
#include <cmath>

namespace frana {

std::string shortest_text(double value) {
    if (std::isnan(value)) return "nan";
    if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
    std::array<char, 32> buffer{};
    const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    return {buffer.data(), result.ptr};
}

}  // namespace frana
