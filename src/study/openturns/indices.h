// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "study/sensitivity.h"

namespace frana::study {

/// OpenturnsFunctions::indices.
std::vector<KeySensitivity> indices(const DesignPoints& points, const std::vector<double>& output, std::size_t groups,
                                    bool with_intervals);

}  // namespace frana::study
