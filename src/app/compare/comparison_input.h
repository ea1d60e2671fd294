// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/compare/comparison.h"
#include "app/input/prepare.h"

namespace frana::app {

/// What a scene's survey and threshold say of a comparison; the simulated part is still to be filled in.
ComparisonInput surveyed(const Prepared& prepared);

}  // namespace frana::app
