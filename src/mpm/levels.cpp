// SPDX-License-Identifier: Apache-2.0
#include "mpm/levels.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mpm/shown_depth.h"

namespace frana {
namespace {

constexpr double k_level_ratio = 0.2 * 0.2, k_sloping_ratio = 0.5 * 0.5;
// Squared spread of the bed, in cells, below which it counts as level: both references are then equal.
constexpr double k_flat = 1e-6;

// Accuracy of the area flooded by a level, as a fraction of a cell: a smaller area does not make a shore a front.
constexpr double k_known_fraction = 0.06;

double smooth_step(double from, double to, double value) {
    const double t = std::clamp((value - from) / (to - from), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

/// Integral of the quadratic spline of a node up to a distance from it [cells]: the fraction of the node's area on the
/// near side of a straight shoreline.
double near_side(double distance) {
    const double far = 1.5 - std::min(std::abs(distance), 1.5);
    const double beyond =
        std::abs(distance) < 0.5 ? 0.5 - std::abs(distance) * (0.75 - distance * distance / 3) : far * far * far / 6;
    return distance > 0 ? 1 - beyond : beyond;
}

/// Returns the fraction of a node's area below a level; the bed is the plane through its neighbours.
double under_level(const double* bed, std::int64_t stride, double level, double dx) {
    const double slope = std::hypot(bed[1] - bed[-1], bed[stride] - bed[-stride]) / (2 * dx);
    const double clearance = level - *bed;
    return slope * dx > 0 ? near_side(clearance / (slope * dx)) : (clearance > 0 ? 1 : 0);
}

}  // namespace

void mean_levels(const NodeRange& range, NodeGrid& nodes) {
    NodeSums* const sums = nodes.sums();
    NodeLevel* levels = nodes.levels.data();
    const double flat = k_flat * nodes.cell_size() * nodes.cell_size();
    range.for_each(nodes.stride(), [&](std::size_t n, std::int64_t, std::int64_t) {
        NodeSums& s = sums[n];
        levels[n] = NodeLevel{};
        if (!(s.area > 0)) return;
        const double depth = s.mass / s.area, above = s.area_bed / s.area;
        const double bed_spread = std::max(0.0, s.bed_squares / s.area - above * above);
        const double surface_spread = std::max(0.0, s.surface_squares / s.area - (depth + above) * (depth + above));
        levels[n].depth = depth;
        levels[n].level = nodes.bed[n] + above + depth;
        levels[n].ponding = 1 - smooth_step(k_level_ratio, k_sloping_ratio, surface_spread / (bed_spread + flat));
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
    NodeLevel* levels = nodes.levels.data();
    const double* bed = nodes.bed.data();
    const std::uint8_t* solid = nodes.solid();
    const std::int64_t stride = nodes.stride(), rows = nodes.padded_rows();
    const double dx = nodes.cell_size(), inverse_dx2 = 1 / (dx * dx);
    range.for_each(stride, [&](std::size_t n, std::int64_t i, std::int64_t j) {
        if (!(forces[n].area > 0)) return;
        const bool ghost = i < k_ghost || j < k_ghost || i >= stride - k_ghost || j >= rows - k_ghost;
        forces[n].crowding = ghost ? 1 : crowding(nodes, forces, n, i, j);
        if (i == 0 || j == 0 || i == stride - 1 || j == rows - 1) return;  // outermost ghosts: never read
        NodeLevel& level = levels[n];
        double least = forces[n].area;
        for (std::int64_t b = -1; b <= 1; ++b) {
            const NodeForces* row = forces + n + b * stride;
            least = std::min(least, std::min(row[-1].area, std::min(row[0].area, row[1].area)));
        }
        if (least * inverse_dx2 >= k_filled_fraction) {  // filled all around, as most nodes are
            level.support = 1;
            return;
        }
        double support = 1;
        for (std::int64_t b = -1; b <= 1; ++b) {
            for (std::int64_t a = -1; a <= 1; ++a) {
                const std::size_t k = n + static_cast<std::size_t>(b * stride + a);
                if (solid && solid[k]) continue;
                double fillable = 1;
                if (level.ponding > 0 && i + a > 0 && j + b > 0 && i + a < stride - 1 && j + b < rows - 1)
                    fillable -= level.ponding * (1 - under_level(bed + k, stride, level.level, dx));
                const double fraction = forces[k].area * inverse_dx2;
                const double full = k_filled_fraction * fillable - k_known_fraction * level.ponding;
                const double filled = fraction < full ? fraction / full : 1;
                support = std::min(support, bed[k] >= level.level ? std::max(filled, level.ponding) : filled);
            }
        }
        level.support = support;
    });
}

}  // namespace frana
