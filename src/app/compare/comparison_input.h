// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/compare/comparison.h"
#include "app/input/prepare.h"

namespace frana::app {

/// Returns a scene's survey and threshold for a comparison; the simulated part remains to be filled in.
ComparisonInput surveyed(const Prepared& prepared);

}  // namespace frana::app
