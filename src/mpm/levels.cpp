// SPDX-License-Identifier: Apache-2.0
#include "mpm/levels.h"

#include <algorithm>
#include <limits>

namespace frana {
namespace {

constexpr double k_filled_share = 0.6;
constexpr double k_level_ratio = 0.2 * 0.2, k_sloping_ratio = 0.5 * 0.5;
// Squared slope under which a bed counts as level: the two references then differ by less than a part in a thousand.
constexpr double k_flat = 1e-6;

double smooth_step(double from, double to, double value) {
    const double t = std::clamp((value - from) / (to - from), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

// Squared surface slope along one direction, from the neighbours that hold material, and the steeper one-sided bed
// slope: a bed that bends under the node is not level however small its central difference.
struct SquaredSlopes {
    double surface, bed;
};

SquaredSlopes along(const NodeSums* sums, const NodeLevel* levels, const double* bed, std::size_t i, std::ptrdiff_t step) {
    const std::size_t a = i - static_cast<std::size_t>(step), b = i + static_cast<std::size_t>(step);
    const bool has_a = sums[a].area > 0, has_b = sums[b].area > 0;
    double surface = 0;
    if (has_a && has_b) {
        surface = 0.5 * (levels[b].level - levels[a].level);
    } else if (has_b) {
        surface = levels[b].level - levels[i].level;
    } else if (has_a) {
        surface = levels[i].level - levels[a].level;
    }
    const double before = bed[i] - bed[a], after = bed[b] - bed[i];
    return {surface * surface, std::max(before * before, after * after)};
}

}  // namespace

void mean_levels(const NodeRange& range, NodeGrid& nodes) {
    const NodeSums* sums = nodes.sums.data();
    NodeLevel* levels = nodes.levels.data();
    range.for_each(nodes.stride(), [&](std::size_t n, std::int64_t, std::int64_t) {
        const NodeSums& s = sums[n];
        levels[n] = NodeLevel{};
        if (s.area > 0) {
            levels[n].depth = s.mass / s.area;
            levels[n].level = (s.mass + s.area_bed) / s.area;
        }
    });
}

void node_references(const NodeRange& range, NodeGrid& nodes) {
    const NodeSums* sums = nodes.sums.data();
    NodeLevel* levels = nodes.levels.data();
    const double* bed = nodes.bed.data();
    const std::uint8_t* solid = nodes.solid();
    const std::int64_t stride = nodes.stride(), rows = nodes.padded_rows();
    const double inverse_dx2 = 1 / (nodes.cell_size() * nodes.cell_size());
    range.for_each(stride, [&](std::size_t n, std::int64_t i, std::int64_t j) {
        if (!(sums[n].area > 0)) return;
        if (i == 0 || j == 0 || i == stride - 1 || j == rows - 1) return;  // outermost ghosts: never read
        NodeLevel& level = levels[n];
        const SquaredSlopes x = along(sums, levels, bed, n, 1), y = along(sums, levels, bed, n, stride);
        const double ratio = (x.surface + y.surface) * inverse_dx2 / ((x.bed + y.bed) * inverse_dx2 + k_flat);
        level.ponding = 1 - smooth_step(k_level_ratio, k_sloping_ratio, ratio);
        double support = 1;
        for (std::int64_t b = -1; b <= 1; ++b) {
            for (std::int64_t a = -1; a <= 1; ++a) {
                const std::size_t k = n + static_cast<std::size_t>(b * stride + a);
                if (solid && solid[k]) continue;
                const double filled = std::min(1.0, sums[k].area * inverse_dx2 / k_filled_share);
                support = std::min(support, bed[k] >= level.level ? std::max(filled, level.ponding) : filled);
            }
        }
        level.support = support;
    });
}

}  // namespace frana
