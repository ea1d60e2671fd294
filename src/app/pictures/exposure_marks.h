// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/words/words.h"
#include "render/map/map2d.h"

namespace frana::app {

/// Returns the exposed features of a result for its maps: those that are reached, those that are not, and those of
/// which the map says nothing, each kind with its number; the reached ones uppermost. Throws Error(input) for a damaged
/// file.
/// @param gpkg the result's exposure.gpkg; need not exist
std::vector<render::Outline> exposure_marks(const std::string& gpkg, const std::string& crs_wkt, const Words& words);

}  // namespace frana::app
