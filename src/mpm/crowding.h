// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "mpm/node_grid.h"
#include "particles/particle_set.h"
#include "particles/tile_order.h"

namespace frana {

/// Makes room for particles that were appended from `first` on, where there was material already: it becomes deeper.
/// The areas of both shrink until together they claim no more of the cells around than there is, or than was claimed
/// before. Without that they would overlap, each with its own depth, and press with that instead of with the depth on
/// the ground. Reads NodeMotion::fraction of the last step; volumes are unchanged.
/// @param order of the particles before `first`
/// @return the particles whose area changed, ascending
std::vector<std::size_t> make_room(const NodeGrid& nodes, const TileOrder& order, std::size_t first,
                                   ParticleSet& particles);

}  // namespace frana
