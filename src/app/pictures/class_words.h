// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/words/words.h"
#include "params/keys/result_rasters.h"

namespace frana::app {

/// Returns the title of a raster of this row: "Probability of more than 0.5 m" for probability_depth_0.5.
std::string raster_title(const ResultRaster& row, const std::string& name, const Words& words);

/// Puts the label of a class, as files contain it in English, into a language: "High intensity: depth > 1 m and speed >
/// 1 m/s", "Hit: simulated and observed". Parts that no table has stay as they are.
std::string class_label(const std::string& english, const Words& words);

/// Returns the name of a hazard scheme that readers of a map know: "Switzerland, debris flows" for swiss-debris-flow.
std::string scheme_title(const std::string& scheme, const Words& words);

/// Returns the name in such a label, before the colon.
std::string class_name(const std::string& label);

}  // namespace frana::app
