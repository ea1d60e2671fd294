// SPDX-License-Identifier: Apache-2.0
#include "mpm/levels.h"

#include <algorithm>

namespace frana {
namespace {

double support_of(const NodeGrid& nodes, const NodeForces* forces, std::size_t n, std::int64_t i, std::int64_t j,
                  double inverse_dx2) {
    const std::int64_t stride = nodes.stride(), rows = nodes.padded_rows();
    const NodeLevel& level = nodes.levels[n];
    const double* const bed = nodes.bed.data() + n;
    const std::uint8_t* const solid = nodes.solid();
    return least_filled<double>(
        level.level, level.ponding, level.ponding > 0,
        [&](std::int64_t a, std::int64_t b) { return forces[n + b * stride + a].area * inverse_dx2; },
        [&](std::int64_t a, std::int64_t b) { return bed[b * stride + a]; },
        [&](std::int64_t a, std::int64_t b) {
            // The outermost ring has no slope: it can be filled if it lies below the level at all.
            if (i + a <= 0 || j + b <= 0 || i + a >= stride - 1 || j + b >= rows - 1) return 0.0;
            const double* const z = bed + b * stride + a;
            return half_rise<double>(z[1] - z[-1], z[stride] - z[-stride]);
        },
        [&](std::int64_t a, std::int64_t b) {
            return solid != nullptr && solid[static_cast<std::int64_t>(n) + b * stride + a] != 0;
        });
}

}  // namespace

void mean_levels(const NodeRange& range, NodeGrid& nodes) {
    NodeSums* const sums = nodes.sums();
    const double flat = k_flat * nodes.cell_size() * nodes.cell_size();
    range.for_each(nodes.stride(), [&](std::size_t n, std::int64_t, std::int64_t) {
        NodeSums& s = sums[n];
        nodes.levels[n] = NodeLevel{};
        if (!(s.area > 0)) return;
        const auto mean =
            mean_level<double>(s.mass, s.area, s.area_bed, s.bed_squares, s.surface_squares, nodes.bed[n], flat);
        nodes.levels[n] = {mean.depth, mean.level, mean.ponding, 0, mean.held, 0};
        s.bed_squares = s.surface_squares = 0;
    });
}

void clear_squares(const NodeRange& range, NodeGrid& nodes) {
    NodeSums* const sums = nodes.sums();
    range.for_each(nodes.stride(), [&](std::size_t n, std::int64_t, std::int64_t) {
        sums[n].bed_squares = sums[n].surface_squares = 0;
    });
}

void node_references(const NodeRange& range, NodeGrid& nodes) {
    NodeForces* const forces = nodes.forces();
    const std::int64_t stride = nodes.stride(), rows = nodes.padded_rows();
    const double inverse_dx2 = 1 / (nodes.cell_size() * nodes.cell_size());
    range.for_each(stride, [&](std::size_t n, std::int64_t i, std::int64_t j) {
        if (!(forces[n].area > 0)) return;
        forces[n].crowding = nodes.is_ghost(i, j) ? 1 : crowding(nodes, forces, n, i, j);
        if (i == 0 || j == 0 || i == stride - 1 || j == rows - 1) return;  // outermost ghosts: never read
        double least = forces[n].area;
        for (std::int64_t b = -1; b <= 1; ++b) {
            const NodeForces* row = forces + n + b * stride;
            least = std::min(least, std::min(row[-1].area, std::min(row[0].area, row[1].area)));
        }
        nodes.levels[n].support =
            least * inverse_dx2 >= k_filled_fraction ? 1 : support_of(nodes, forces, n, i, j, inverse_dx2);
    });
}

}  // namespace frana
