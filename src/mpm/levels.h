// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mpm/node_grid.h"

namespace frana {

/// Computes each node's mean depth and free surface, and how level that surface is. Reads NodeSums and clears its
/// squares, since forces are summed in the same slots; writes NodeLevel depth, level, ponding.
///
/// Ponding distinguishes a pool from flow on a slope by comparing the spread of the particles' free surface around the
/// node with the spread of the bed below them: 1 where the surface spreads less than a fifth of the bed, 0 where more
/// than half, smooth between. On a level bed, and for a single particle, both references are the same.
void mean_levels(const NodeRange& range, NodeGrid& nodes);

/// Clears the squares of NodeSums if the levels of the previous step are still valid.
void clear_squares(const NodeRange& range, NodeGrid& nodes);

/// Computes each node's support: the least fraction of any neighbour whose bed is below the surface, full at 0.6
/// (share/doc/numerics.md, "Reference level"); and NodeForces::crowding. Needs mean_levels of the whole neighbourhood.
void node_references(const NodeRange& range, NodeGrid& nodes);

}  // namespace frana
