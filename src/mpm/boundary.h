// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mpm/erodible_bed.h"
#include "mpm/node_grid.h"

namespace frana {

/// Walls by mirroring (share/doc/numerics.md, "Walls"). The wall is along the outer edge of the outermost cells, half a
/// cell beyond the nodes there, so a ghost node is the mirror image of a node inside: contributions of particles to the
/// ghost belong to that node, with the normal component reversed.
///
/// Adds the ghosts' mass, momentum, area (sums) to the inner nodes and makes the ghosts their mirror images.
void mirror_sums(NodeGrid& nodes);
/// The same for a padded array of sums of a scalar.
void mirror_scalar(const NodeGrid& nodes, double* sums);
/// Copies the reference levels of the mirror images to the ghosts.
void mirror_levels(NodeGrid& nodes);
/// Adds the ghosts' forces to the inner nodes and sets them to zero.
void fold_forces(NodeGrid& nodes);
/// Sets the ghosts to the mirror image of the inner nodes' updated velocities, fractions and supports.
void mirror_velocities(NodeGrid& nodes);
/// Copies the mirror images' fractions of exchange with the bed to the ghosts.
void mirror_exchange(const NodeGrid& nodes, ErodibleBed* beds);
/// Sets the ghosts' bed to the mirror image of the bed inside.
void mirror_bed(NodeGrid& nodes);

}  // namespace frana
