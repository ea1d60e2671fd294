// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mpm/bed_exchange.h"
#include "mpm/node_grid.h"

namespace frana {

/// Walls by mirroring (share/doc/numerics.md, "Walls"). The wall runs along the outer edge of the outermost cells,
/// half a cell beyond the nodes there, so a ghost node is the mirror image of a node inside: what particles
/// gave to the ghost belongs to that node, with the normal component turned round.
///
/// Adds the ghosts' mass, momentum, area (sums) to the inner nodes and makes the ghosts their mirror images.
void mirror_sums(NodeGrid& nodes);
/// Gives the ghosts the reference levels of their mirror images.
void mirror_levels(NodeGrid& nodes);
/// Adds the ghosts' forces to the inner nodes; the ghosts' forces become zero.
void fold_forces(NodeGrid& nodes);
/// Gives the ghosts the mirror image of the inner nodes' updated velocities, shares and supports.
void mirror_velocities(NodeGrid& nodes);
/// Gives the ghosts their mirror images' fractions of what is exchanged with the bed.
void mirror_exchange(const NodeGrid& nodes, ErodibleBed* beds);
/// Makes the ghosts' bed the mirror image of the bed inside.
void mirror_bed(NodeGrid& nodes);

}  // namespace frana
