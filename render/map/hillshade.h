// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/raster.h"

namespace frana::render {

/// Returns shaded relief lit from several directions around the north-west, so that slopes parallel to the light remain
/// visible: 0 dark to 1 bright on the terrain's own grid, NaN where the terrain has no value. `exaggeration` multiplies
/// heights before shading.
Raster hillshade(const Raster& terrain, double exaggeration = 1.0);

}  // namespace frana::render
