// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/raster.h"

namespace frana::render {

/// Shaded relief lit from several directions round the north-west, so that no slope vanishes for lying along
/// the light: 0 dark to 1 bright on the terrain's own grid, NaN where the terrain has no value.
/// `exaggeration` multiplies heights before shading.
Raster hillshade(const Raster& terrain, double exaggeration = 1.0);

}  // namespace frana::render
