// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "analysis/ground_doubts.h"
#include "core/raster.h"

namespace frana {

/// The part of the path that the flow takes: where water from its highest cells runs, over what dams it up, and as wide
/// to both sides as the mass where it starts. The start is marked with 2. Finds narrow dams across it.
Raster taken_path(const Raster& ground, const Raster& path, double cell_size, std::optional<GroundDoubts::Dam>& dam);

}  // namespace frana
