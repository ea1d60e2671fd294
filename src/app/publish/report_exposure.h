// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "app/publish/publish_exposure.h"

namespace frana::app {

/// The paragraph "What is exposed." of a report's answer; empty without exposed features.
std::string exposure_answer(const std::optional<ExposureTotals>& totals, ReachedBy by, const Words& words);

/// The section of the features that are reached, the deepest first, with its heading; empty if none is.
std::string exposure_section(const std::optional<ExposureTotals>& totals, const Words& words);

}  // namespace frana::app
