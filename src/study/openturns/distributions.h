// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "study/study_spec.h"

namespace frana::study {

/// OpenturnsFunctions::quantiles.
std::vector<double> quantiles(const Distribution& distribution, const std::vector<double>& places);

}  // namespace frana::study
