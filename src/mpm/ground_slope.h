// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/geometry.h"
#include "mpm/node_grid.h"

namespace frana {

/// Ground at a node between the differences to the nodes before and after it.
struct Corner {
    double slope;
    double turn;  ///< its angle over the difference of the slopes
};

/// Flow passes a sharp corner between two nodes: a node keeps the slope of the flatter side, which at the lip of a
/// cliff is that of the ground before it. With the mean of both it would go down the cliff there, slow in map view and
/// deep. Elsewhere the mean.
inline Corner corner_between(double before, double after, double cell_size) noexcept {
    const double a = before / cell_size, b = after / cell_size, mean = 0.5 * (a + b);
    const double flatter = a * b > 0 ? (std::abs(a) < std::abs(b) ? a : b) : 0;
    const double most = 0.25 * (1 + flatter * flatter);
    const double turn = std::abs(b - a) > 1e-6 ? (std::atan(b) - std::atan(a)) / (b - a) : 1;
    return {flatter + std::clamp(mean - flatter, -most, most), turn};
}

/// At a node, towards the nodes `next` before and after it.
inline Corner corner_at(const NodeGrid& nodes, std::size_t k, std::int64_t next) noexcept {
    const double* const z = nodes.bed.data() + k;
    return corner_between(z[0] - z[-next], z[next] - z[0], nodes.cell_size());
}

/// The slope of the ground at a node inside the padded grid.
inline Point ground_slope(const NodeGrid& nodes, std::size_t k) noexcept {
    return {corner_at(nodes, k, 1).slope, corner_at(nodes, k, nodes.stride()).slope};
}

}  // namespace frana
