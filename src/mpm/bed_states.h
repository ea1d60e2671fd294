// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mpm/update_nodes.h"

namespace frana {

/// Sets thickness and support of each node with mass; the laws then add their parts. Reads NodeForces mass, area, px,
/// py (curved only), bed; writes BedState.
template <class Slope>
void fill_bed_states(const NodeRange& range, const NodeUpdate& k, const NodeGrid& nodes, BedState* states) {
    range.for_each(nodes.stride(), [&](std::size_t i, std::int64_t column, std::int64_t row) {
        const NodeForces& node = nodes.forces()[i];
        if (!(node.mass > 0)) return;
        const NodeDrive ground = ground_of<Slope>(nodes, k, i, column, row);
        const double root = Slope::metric ? std::sqrt(ground.n) : 1;
        states[i] = {node.mass / node.area / root, (k.gravity + ground.load) / root, 0, 0, 0, 0};
    });
}

/// Adds one law to the nodes of a tile.
template <class Law>
void add_friction(const NodeRange& range, const NodeUpdate& k, Law law, const NodeGrid& nodes, BedState* states) {
    if constexpr (requires { law.effective_fraction; }) law.effective_fraction = k.effective_fraction;
    range.for_each(nodes.stride(), [&](std::size_t i, std::int64_t, std::int64_t) {
        if (nodes.mass(i) > 0) law(states[i], i);
    });
}

}  // namespace frana
