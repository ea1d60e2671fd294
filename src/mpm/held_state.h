// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mpm/node_grid.h"

namespace frana {

/// Sets each node's share of the state held on the grid, and adds that state's force. Needs mean_levels and
/// node_references of the whole neighbourhood; reads NodeForces area, crowding; writes NodeLevel::share, 0 before,
/// adds to NodeForces fx, fy.
///
/// A reference that each node takes for itself (NodeLevel) exerts no force in sum only where the particles' areas are
/// even; at a shock they are not, and momentum would not be conserved: plateau and shock would converge to a wrong
/// state. Instead, nodes hold a common state of depth r over their bed Z, whose force is a difference on the grid, and
/// particles carry the deviation from it alone: with r_p = sum w r of the particle's nodes and s the share,
///
///     particles  f = sum A g/2 (h^2 - s r_p^2) grad w - ...
///     grid       f = -s g dx^2 [ D(r^2) / 2 + r D(Z) + D(|d e|^2) / 8 ],   e = r + Z
///
/// in each direction. D is the difference over two and four nodes of fourth order; d e are the differences of the
/// surface over two nodes, whose squares offset what the smoothing by the splines does where the surface is steep. The
/// force is zero for a level surface on any bed, and on a level bed each term is a difference, so that their sum over
/// the nodes is that at the ends. r and the pull of the slope are those of a pool or of a thin flow, as in NodeLevel.
///
/// The share is 1 where the bed is level compared with the depth, 0 where it varies by three tenths of it over the
/// nodes used: on steep ground, near shores, and also near free fronts (nodes that are not filled), beside solid cells
/// where particles lie on top of each other and where the depth varies tenfold, each node has its own reference as
/// before. A node's form is a choice between two that are both consistent, so that a gradual change leaves no seam; but
/// momentum is exact only where the share of all nodes around is 1.
/// @param wall what is beyond the terrain's edges mirrors what is inside
void hold_on_grid(const NodeRange& range, double gravity, bool wall, NodeGrid& nodes);

}  // namespace frana
