// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/text.h"

namespace frana {

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
