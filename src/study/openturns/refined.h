// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "study/openturns/functions.h"

namespace frana::study {

/// OpenturnsFunctions::refined.
RefinedPlaces refined(const Places& design, const std::vector<double>& weights, const std::vector<double>& widths,
                      double prior_part, std::size_t count, std::int64_t seed);

}  // namespace frana::study
