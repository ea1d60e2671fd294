// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "core/lanes.h"
#include "mpm/node_grid.h"
#include "mpm/shown_depth.h"

namespace frana {

/// Computes each node's mean depth and free surface, and how level that surface is. Reads NodeSums and clears its
/// squares, since forces are summed in the same slots; writes NodeLevel depth, level, ponding, held.
///
/// Ponding distinguishes a pool from flow on a slope by comparing the spread of the particles' free surface around the
/// node with the spread of the bed below them: 1 where the surface spreads less than a fifth of the bed, 0 where more
/// than half, smooth between. On a level bed, and for a single particle, both references are the same.
void mean_levels(const NodeRange& range, NodeGrid& nodes);

/// Clears the squares of NodeSums if the levels of the previous step are still valid.
void clear_squares(const NodeRange& range, NodeGrid& nodes);

/// Computes each node's support: the least fraction of any neighbour whose bed is below the surface, full at 0.6
/// (share/doc/numerics.md, "Reference level"); and NodeForces::crowding. Needs mean_levels of the whole neighbourhood.
void node_references(const NodeRange& range, NodeGrid& nodes);

// Formulas for one node (double) and for four in a row (Quad), always inlined as those of mpm/curvature.h.

/// NodeLevel without its support and share.
template <class Number>
struct MeanLevel {
    Number depth, level, ponding, held;
};

inline constexpr double k_level_ratio = 0.2 * 0.2, k_sloping_ratio = 0.5 * 0.5;
/// Squared spread of the bed, in cells, below which it counts as level: both references are then equal.
inline constexpr double k_flat = 1e-6;
/// Accuracy of the area flooded by a level, as a fraction of a cell: a smaller area does not make a shore a front.
inline constexpr double k_known_fraction = 0.06;

/// See mean_levels.
/// @param area more than 0  @param flat k_flat in m2
template <class Number>
[[gnu::always_inline]] inline MeanLevel<Number> mean_level(Number mass, Number area, Number area_bed,
                                                           Number bed_squares, Number surface_squares, Number bed,
                                                           double flat) {
    using std::max;
    using std::min;
    const Number zero(0.0), depth = mass / area, above = area_bed / area;
    const Number bed_spread = max(zero, bed_squares / area - above * above);
    const Number surface_spread = max(zero, surface_squares / area - (depth + above) * (depth + above));
    const Number ponding =
        1 - smooth_step<Number>(k_level_ratio, k_sloping_ratio, surface_spread / (bed_spread + flat));
    return {depth, bed + above + depth, ponding, ponding * (above + depth) + (1 - ponding) * depth};
}

/// Returns the rise of a bed over half a cell on either side [m], from the differences of its neighbours.
template <class Number>
[[gnu::always_inline]] inline Number half_rise(Number east_west, Number north_south) {
    using std::sqrt;
    return 0.5 * sqrt(east_west * east_west + north_south * north_south);
}

/// Returns the fraction of a node's cell below a level.
/// @param clearance of the level above the node's bed [m]  @param reach half_rise of the bed, a plane
template <class Number>
[[gnu::always_inline]] inline Number under_level(Number clearance, Number reach) {
    using std::abs;
    using std::min;
    const Number zero(0.0), one(1.0);
    const auto sloping = reach > 0;
    // Integral of the quadratic spline of a node up to a distance from it [cells]: the fraction of the node's area on
    // the near side of a straight shoreline.
    const Number distance = clearance / select(sloping, reach, one), off = min(abs(distance), Number(1.5));
    const Number far = 1.5 - off;
    const Number beyond = select(off < 0.5, 0.5 - off * (0.75 - off * off / 3), far * far * far / 6);
    return select(sloping, select(distance > 0, 1 - beyond, beyond), select(clearance > 0, one, zero));
}

/// Returns the support of a node: the least fraction to which it and its neighbours are filled.
/// @param fraction, bed, reach, closed of the cell at a distance along rows and columns: claimed fraction, elevation,
/// under_level's reach (needed only if pools), whether it is solid  @param pools whether ponding may exceed 0
template <class Number, class Fraction, class Bed, class Reach, class Closed>
[[gnu::always_inline]] inline Number least_filled(Number level, Number ponding, bool pools, const Fraction& fraction,
                                                  const Bed& bed, const Reach& reach, const Closed& closed) {
    using std::max;
    using std::min;
    const Number one(1.0);
    Number support = one;
    for (std::int64_t b = -1; b <= 1; ++b) {
        for (std::int64_t a = -1; a <= 1; ++a) {
            const Number clearance = level - bed(a, b), there = fraction(a, b);
            Number fillable = one;
            if (pools) fillable = 1 - ponding * (1 - under_level<Number>(clearance, reach(a, b)));
            const Number full = k_filled_fraction * fillable - k_known_fraction * ponding;
            const Number filled = select(there < full, there / full, one);
            const Number bound = select(clearance > 0, filled, max(filled, ponding));
            support = select(closed(a, b), support, min(support, bound));
        }
    }
    return support;
}

}  // namespace frana
