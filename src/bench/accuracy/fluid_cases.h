// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bench/accuracy/accuracy_case.h"

namespace frana::bench {

/// The structured model's free fluid: fluid-lake, fluid-stoker, fluid-ritter, fluid-wave (a smooth simple wave) and
/// fluid-thacker, each against its exact solution.
std::vector<AccuracyCase> fluid_cases();

}  // namespace frana::bench
