// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/words/sentence.h"
#include "params/keys/parameter.h"

namespace frana {

/// Values of a key that are possible and, outside this range, most probably a mistake.
struct PlausibleRange {
    const char* key;
    double least, most;
    const char* reading;  ///< what was probably meant, {1}: the value times `factor`; else the unit of that factor
    double factor = 1;
    bool is_refused = false;      ///< outside the range, but for 0; else a warning
    const char* above = nullptr;  ///< what is said of greater values; null: `reading`
    const char* zero = nullptr;   ///< what is said of 0; null: it is plausible

    [[nodiscard]] bool has(double value) const noexcept {
        return value == 0 ? zero == nullptr : value >= least && value <= most;
    }
    /// "0.32 as a coefficient is 17.7 degrees: use material.friction-coefficient"
    [[nodiscard]] Sentence meant(double value) const;
};

/// The name of a hydrograph's column in the table.
inline constexpr const char* k_hydrograph_velocity = "hydrograph velocity";

/// The range of a key; null: none.
const PlausibleRange* plausible_range(const std::string& key);
/// The range of a key, of several the widest, that does not have a value; null: none.
const PlausibleRange* range_without(const std::string& key, double value);

/// The warning about a value outside its plausible range; none for others.
std::optional<Sentence> implausible(const std::string& key, double value);

/// Makes the keys of this table refuse what it refuses, wherever a value of them is read.
void refuse_implausible(std::vector<Parameter>& parameters);

}  // namespace frana
