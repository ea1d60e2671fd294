// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <type_traits>

#include "core/lanes.h"
#include "mpm/node_grid.h"

namespace frana {

/// The area of a node's cell that particles claim, and that of the full cell: as an area before the motion [m2], as a
/// fraction after it.
inline double claimed(const NodeForces& node) noexcept {
    return node.area;
}
inline double claimed(const NodeMotion& node) noexcept {
    return node.fraction;
}
inline double full_claim(const NodeGrid& nodes, const NodeForces*) noexcept {
    return nodes.cell_size() * nodes.cell_size();
}
inline double full_claim(const NodeGrid&, const NodeMotion*) noexcept {
    return 1;
}

/// Returns what is claimed in the cell at a distance along rows and columns from a node's.
template <class Node>
auto claims_around(const Node* node, std::int64_t stride) noexcept {
    return [node, stride](std::int64_t a, std::int64_t b) { return claimed(node[b * stride + a]); };
}

/// Fraction of the cells around a node that particles claim, itself included, with binomial weights over (2 Reach +
/// 1)^2 nodes. All of them must exist.
/// @param claim returns what is claimed in a cell, by its distance along rows and columns from the node's
/// @param full claim of a full cell
template <std::int64_t Reach, class Number, class Claim>
[[gnu::always_inline]] inline Number mean_fraction(const Claim& claim, double full) noexcept {
    static_assert(Reach >= 1 && Reach <= 3);
    constexpr std::array<double, 4> weights = Reach == 1   ? std::array<double, 4>{2, 1}
                                              : Reach == 2 ? std::array<double, 4>{6, 4, 1}
                                                           : std::array<double, 4>{20, 15, 6, 1};
    // In pairs, so that a mirrored arrangement has the same sum.
    const auto row = [&](std::int64_t b) __attribute__((always_inline)) {
        Number sum = weights[0] * claim(0, b);
        for (std::int64_t a = 1; a <= Reach; ++a)
            sum += weights[static_cast<std::size_t>(a)] * (claim(-a, b) + claim(a, b));
        return sum;
    };
    Number sum = weights[0] * row(0);
    for (std::int64_t b = 1; b <= Reach; ++b) sum += weights[static_cast<std::size_t>(b)] * (row(-b) + row(b));
    constexpr double all = 1 << (4 * Reach);
    return sum / (all * full);
}

/// Mean fraction of 7 x 7 nodes from which particles are permanently crowded, and from which the crowding counts in
/// full. Lower values are the unevenness of an arrangement: 0.01 for random particles.
inline constexpr double k_lasting_from = 1.015, k_lasting_full = 1.03;

/// Returns the ratio of the area claimed by particles around a node to the available area, at least 1. It exceeds 1
/// where flow converges, in deposits and in gullies; the flow is deeper there than each particle's own depth by that
/// factor.
/// @param near, wide mean fractions of 3 x 3 and of 7 x 7 nodes
template <class Number>
[[gnu::always_inline]] inline Number crowding_of(Number near, Number wide) noexcept {
    using std::max;
    using std::min;
    const Number zero(0.0), one(1.0);
    const Number lasting = (wide - k_lasting_from) / (k_lasting_full - k_lasting_from);
    return select(near > 1, 1 + min(max(lasting, zero), one) * (near - 1), one);
}

/// Returns crowding_of a node.
/// @param records of the grid  @param column, row padded indices of a node inside the ghosts
template <class Node>
double crowding(const NodeGrid& nodes, const Node* records, std::size_t node, std::int64_t column,
                std::int64_t row) noexcept {
    const std::int64_t stride = nodes.stride();
    const auto claim = claims_around(records + node, stride);
    const double full = full_claim(nodes, records), near = mean_fraction<1, double>(claim, full);
    if (!(near > 1)) return 1;
    const bool inner = std::min(column, row) >= 3 && column < stride - 3 && row < nodes.padded_rows() - 3;
    return crowding_of<double>(near,
                               inner ? mean_fraction<3, double>(claim, full) : mean_fraction<2, double>(claim, full));
}

/// Returns the depth of a node for maps [m]: the mean depth of its particles times their crowding where the node and
/// its surroundings are filled, independent of the unevenness of their arrangement; volume over cell area at fronts and
/// in thin flow, where the cell is only partly covered.
template <class Number = double>
[[gnu::always_inline]] inline Number shown_depth(std::type_identity_t<Number> mass, std::type_identity_t<Number> area,
                                                 std::type_identity_t<Number> support,
                                                 std::type_identity_t<Number> crowding, double inverse_cell_area) {
    using std::min;
    const Number by_volume = mass * inverse_cell_area;
    const Number filled = min(Number(1.0), area * inverse_cell_area / k_filled_fraction);
    return select(area > 0, by_volume + support * filled * (crowding * mass / area - by_volume), by_volume);
}

/// Returns the depth for maps of a node inside the ghosts after a step [m].
inline double shown_depth(const NodeGrid& nodes, std::size_t node) noexcept {
    const NodeMotion& motion = nodes.motion()[node];
    const double cell_area = nodes.cell_size() * nodes.cell_size();
    const auto n = static_cast<std::int64_t>(node), stride = nodes.stride();
    return shown_depth<double>(motion.mass, motion.fraction * cell_area, std::min(1.0, motion.support),
                               crowding(nodes, nodes.motion(), node, n % stride, n / stride), 1 / cell_area);
}

}  // namespace frana
