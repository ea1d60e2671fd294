// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "app/text/run_log.h"
#include "gis/crs/crs_transform.h"

namespace frana::app {

/// Returns "none", or PROJ's name: "Inverse of Italy zone 1 + ...".
std::string transform_text(const gis::TransformInfo& transform);
/// Returns the accuracy stated by the register: "exact" (formulas alone), "4 m", "unknown".
std::string accuracy_text(const gis::TransformInfo& transform);

/// Logs how an input ("DTM", "perimeter") was transformed to the working CRS, and warns if its accuracy is worse than
/// half a cell or a better operation needs a grid file that is not installed.
void report_transform(const Sentence& input, const gis::TransformInfo& transform, double cell_size, RunLog& log);

}  // namespace frana::app
