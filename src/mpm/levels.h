// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mpm/node_grid.h"
#include "mpm/node_tiles.h"

namespace frana {

/// Each node's mean depth and free surface. Reads NodeSums mass, area, area_bed; writes NodeLevel depth, level.
void mean_levels(const NodeRange& range, NodeGrid& nodes);

/// Each node's ponding and support, from its neighbours; needs mean_levels of the whole neighbourhood.
///
/// Ponding tells a pool from a layer on a slope by comparing the slope of the free surface with that of the bed: 1
/// where the surface is less than a fifth as steep, 0 where it is more than half as steep, smooth between. On a level
/// bed both references are the same. Support is the least share of any neighbour whose bed lies under the surface,
/// full at 0.6 (specification 4, item 4).
void node_references(const NodeRange& range, NodeGrid& nodes);

}  // namespace frana
