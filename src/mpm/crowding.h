// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "mpm/node_grid.h"
#include "particles/particle_set.h"
#include "particles/tile_order.h"

namespace frana {

/// Makes room for particles that were appended from `first` on, where there was material already: together they are
/// deeper. Those that claim too much get the depth of all that lies there, then the areas of all shrink until they
/// claim no cell more than once. Otherwise they would overlap and press each with its own depth, not with that on the
/// ground. Volumes are unchanged.
/// @param order of the particles before `first`
/// @return the particles whose area changed
std::vector<std::size_t> fit_appended(const NodeGrid& nodes, const TileOrder& order, std::size_t first,
                                      ParticleSet& particles);

}  // namespace frana
