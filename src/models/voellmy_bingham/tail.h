// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "mpm/node_grid.h"

namespace frana::voellmy_bingham {

/// The tail of a flow: what is left behind a wave that has passed and follows the bed. It has fewer particles
/// (ResampleLimits::tail), since no map of maxima depends on it, and since a flow whose depth varies by less than the
/// bed falls is driven by the bed rather than by its own pressure. Of the greatest depth of a node so far, less than
/// this is left.
inline constexpr double k_tail_depth = 0.3;
/// The bed falls over a cell by at least this many times the difference of depth to any neighbour. Water that leaves
/// its shore and may come back, as in a swinging bowl, keeps its particles: there the depth varies as the bed does.
inline constexpr double k_tail_fall = 4;

/// Marks each node of a range: 1 in the tail.
/// @param deepest greatest depth of each padded node so far [m]  @param tail marks of the padded nodes
inline void mark_tail(const NodeRange& range, const NodeGrid& nodes, const double* deepest, std::uint8_t* tail) {
    const NodeMotion* const motion = nodes.motion();
    const double* const bed = nodes.bed.data();
    const double inverse_area = 1 / (nodes.cell_size() * nodes.cell_size());
    const std::int64_t stride = nodes.stride();
    const auto depth = [&](std::size_t n) {
        return motion[n].fraction > 0 ? motion[n].mass * inverse_area / motion[n].fraction : 0;
    };
    range.for_each(stride, [&](std::size_t n, std::int64_t i, std::int64_t j) {
        tail[n] = 0;
        const double here = depth(n);
        if (!(here < k_tail_depth * deepest[n]) || nodes.is_ghost(i, j)) return;
        double varies = 0;
        for (const std::int64_t to : {std::int64_t{-1}, std::int64_t{1}, -stride, stride})
            varies = std::max(varies, std::abs(depth(n + static_cast<std::size_t>(to)) - here));
        const double fall_x = bed[n + 1] - bed[n - 1],
                     fall_y = bed[n + static_cast<std::size_t>(stride)] - bed[n - static_cast<std::size_t>(stride)];
        const double fall2 = 0.25 * (fall_x * fall_x + fall_y * fall_y), bound = k_tail_fall * varies;
        tail[n] = fall2 > bound * bound ? 1 : 0;
    });
}

}  // namespace frana::voellmy_bingham
