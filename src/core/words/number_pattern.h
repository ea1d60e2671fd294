// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/words/words.h"

namespace frana {

/// An English text with its numbers taken out, so that one text of the catalogues serves for all values.
struct NumberPattern {
    std::string text;                  ///< "{1}, a smooth wide bed"; at most nine places, later numbers stay
    std::vector<std::string> numbers;  ///< "24"; with groups of three digits: "63 071"

    explicit NumberPattern(std::string_view english);
    [[nodiscard]] std::string in(const Words& words) const;
};

}  // namespace frana
