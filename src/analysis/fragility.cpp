// SPDX-License-Identifier: Apache-2.0
#include "analysis/fragility.h"

#include <cmath>
#include <numbers>

namespace frana {

double DamageState::probability(double intensity) const {
    if (!(intensity > 0)) return 0;
    if (beta == 0) return intensity > median ? 1 : 0;
    return 0.5 * std::erfc(-std::log(intensity / median) / (beta * std::numbers::sqrt2));
}

double FragilityClass::loss(double intensity) const {
    double sum = 0, likely = 1, before = 0;
    for (const DamageState& state : states) {
        likely = std::min(likely, state.probability(intensity));
        sum += likely * (state.loss - before);
        before = state.loss;
    }
    return sum;
}

}  // namespace frana
