// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mpm/node_grid.h"
#include "mpm/node_tiles.h"

namespace frana {

/// Each node's mean depth and free surface, and how level that surface is. Reads NodeSums and clears
/// its squares, since forces are summed in their place; writes NodeLevel depth, level, ponding.
///
/// Ponding tells a pool from a layer on a slope: it compares the spread of the particles' free surface round
/// the node with the spread of the bed under them. 1 where the surface spreads less than a fifth of the bed,
/// 0 where more than half, smooth between. On a level bed, and for a single particle, both references are the
/// same.
void mean_levels(const NodeRange& range, NodeGrid& nodes);

/// Clears the squares of NodeSums where the levels of the step before still hold.
void clear_squares(const NodeRange& range, NodeGrid& nodes);

/// Each node's support: the least fraction of any neighbour whose bed lies under the surface, full at 0.6
/// (share/doc/numerics.md, "Reference level"); and NodeForces::crowding. Needs mean_levels of the whole neighbourhood.
void node_references(const NodeRange& range, NodeGrid& nodes);

}  // namespace frana
