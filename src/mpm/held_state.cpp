// SPDX-License-Identifier: Apache-2.0
#include "mpm/held_state.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/lanes.h"
#include "core/quad.h"
#include "mpm/shifting.h"

namespace frana {
namespace {

// Variation of the bed over the nodes used, as a fraction of the depth: full share, none.
constexpr double k_level_bed = 0.1, k_uneven_bed = 0.3;
// Least fraction of the cells used that particles claim: no share, full share.
constexpr double k_front = k_filled_fraction, k_inside = 0.9;
// Least depth of the nodes used over the greatest: no share, full share. A film beside deep water has too little mass
// to carry the difference between the water's force on the grid and that of the particles.
constexpr double k_film = 0.02, k_comparable = 0.1;

// The nodes of a tile and two more on each side, an array per quantity, in rows that whole fours can read.
struct Patch {
    static constexpr std::int64_t k_reach = 2, k_rows = k_tile + 2 * k_reach, k_columns = k_rows + 4;
    static constexpr std::size_t k_size = k_rows * k_columns;
    alignas(32) double fraction[k_size];  // of the cell that particles claim; 0: not to be used
    alignas(32) double bed[k_size], depth[k_size], ponding[k_size], crowding[k_size], share[k_size];
    alignas(32) double tilt[k_size];  // squares of the surface's differences over two nodes, over 8 [m2]

    static std::int64_t at(std::int64_t column, std::int64_t row) {
        return (row + k_reach) * k_columns + column + k_reach;
    }
};

// The number of the node that another is, or whose mirror image it is; -1: there is none.
std::int64_t image(std::int64_t node, std::int64_t count, bool wall) {
    const std::int64_t first = wall ? k_ghost : 0, last = count - 1 - first;
    if (node >= first && node <= last) return node;
    return wall ? (node < first ? 2 * first - 1 - node : 2 * last + 1 - node) : -1;
}

// Returns whether the bed is level enough anywhere, by the nodes to both sides alone: on steep ground, nothing else is
// computed.
bool may_share(const NodeRange& range, const NodeGrid& nodes) {
    const std::int64_t stride = nodes.stride();
    for (std::int64_t j = std::max<std::int64_t>(range.j0, 1); j < std::min(range.j1, nodes.padded_rows() - 1); ++j) {
        for (std::int64_t i = std::max<std::int64_t>(range.i0, 1); i < std::min(range.i1, stride - 1); ++i) {
            const std::int64_t n = j * stride + i;
            const double most = k_uneven_bed * nodes.levels[static_cast<std::size_t>(n)].held;
            if (!(most > 0)) continue;
            const double* const bed = nodes.bed.data() + n;
            const double uneven = std::max(std::abs(bed[1] - bed[-1]), std::abs(bed[stride] - bed[-stride]));
            if (uneven < most) return true;
        }
    }
    return false;
}

void fill(Patch& patch, const NodeRange& range, bool wall, const NodeGrid& nodes) {
    const std::uint8_t* const solid = nodes.solid();
    const double inverse_area = 1 / (nodes.cell_size() * nodes.cell_size());
    std::array<std::int64_t, Patch::k_columns> columns;
    columns.fill(-1);
    for (std::int64_t i = 0; i < Patch::k_rows; ++i)
        columns[static_cast<std::size_t>(i)] = image(range.i0 - Patch::k_reach + i, nodes.stride(), wall);
    std::int64_t to = 0;
    for (std::int64_t j = 0; j < Patch::k_rows; ++j) {
        const std::int64_t row = image(range.j0 - Patch::k_reach + j, nodes.padded_rows(), wall);
        for (const std::int64_t column : columns) {
            const auto n = static_cast<std::size_t>(row * nodes.stride() + column);
            const bool used =
                row >= 0 && column >= 0 && nodes.forces()[n].area > 0 && !(solid != nullptr && solid[n] != 0);
            patch.fraction[to] = used ? nodes.forces()[n].area * inverse_area : 0;
            patch.crowding[to] = used ? nodes.forces()[n].crowding : 0;
            patch.bed[to] = used ? nodes.bed[n] : 0;
            patch.depth[to] = used ? nodes.levels[n].held : 0;
            patch.ponding[to] = used ? nodes.levels[n].ponding : 0;
            ++to;
        }
    }
}

// Calls visit(first) for fours of nodes that cover the tile and `round` nodes more on each side.
template <class Visit>
FRANA_INLINE void for_fours(const NodeRange& range, std::int64_t round, const Visit& visit) {
    for (std::int64_t j = -round; j < range.j1 - range.j0 + round; ++j)
        for (std::int64_t i = -round; i < range.i1 - range.i0 + round; i += 4) visit(Patch::at(i, j));
}

// Folds a quantity of the 13 nodes that a node uses.
template <class Fold>
FRANA_INLINE Quad fold_round(const double* at, const Fold& fold) {
    constexpr std::int64_t row = Patch::k_columns;
    Quad all = Quad::load(at);
    for (const std::int64_t to : {std::int64_t{1}, row, std::int64_t{2}, 2 * row, row + 1, row - 1})
        all = fold(all, fold(Quad::load(at - to), Quad::load(at + to)));
    return all;
}

FRANA_INLINE Quad share_of(const Patch& patch, std::int64_t n) {
    const auto least = [](Quad a, Quad b) FRANA_INLINE_LAMBDA { return min(a, b); };
    const auto most = [](Quad a, Quad b) FRANA_INLINE_LAMBDA { return max(a, b); };
    const Quad depth = Quad::load(patch.depth + n);
    const Quad uneven = fold_round(patch.bed + n, most) - fold_round(patch.bed + n, least);
    const Quad::Mask deep = uneven < k_uneven_bed * depth;
    if (!any(deep)) return 0.0;
    const Quad level = smooth_step<Quad>(k_uneven_bed * depth, k_level_bed * depth, uneven);
    const Quad filled = smooth_step<Quad>(k_front, k_inside, fold_round(patch.fraction + n, least));
    const Quad apart = smooth_step<Quad>(k_shift_none, k_shift_until, Quad::load(patch.crowding + n));
    const Quad shallow = fold_round(patch.depth + n, least), deepest = fold_round(patch.depth + n, most);
    const Quad comparable = smooth_step<Quad>(k_film * deepest, k_comparable * deepest, shallow);
    return select(deep, level * filled * apart * comparable, Quad(0.0));
}

// The difference of depth^2 / 2 + depth * bed, twice, between the nodes after and before one, as the product that
// vanishes for a level surface.
FRANA_INLINE Quad fall(const Patch& patch, Quad ponding, std::int64_t before, std::int64_t after) {
    const Quad r0 = Quad::load(patch.depth + before), r1 = Quad::load(patch.depth + after);
    const Quad rise = Quad::load(patch.bed + after) - Quad::load(patch.bed + before);
    return (r1 + r0) * ((r1 - r0) + ponding * rise);
}

FRANA_INLINE Quad tilt_of(const Patch& patch, std::int64_t n) {
    const Quad ponding = Quad::load(patch.ponding + n);
    const auto difference = [&](std::int64_t step) FRANA_INLINE_LAMBDA {
        return (Quad::load(patch.depth + n + step) - Quad::load(patch.depth + n - step)) +
               ponding * (Quad::load(patch.bed + n + step) - Quad::load(patch.bed + n - step));
    };
    const Quad x = difference(1), y = difference(Patch::k_columns);
    return 0.125 * (x * x + y * y);
}

// Force in one direction over g dx / 2.
FRANA_INLINE Quad force_of(const Patch& patch, std::int64_t n, std::int64_t step) {
    const Quad ponding = Quad::load(patch.ponding + n);
    const Quad near = fall(patch, ponding, n - step, n + step), far = fall(patch, ponding, n - 2 * step, n + 2 * step);
    const Quad tilts = Quad::load(patch.tilt + n + step) - Quad::load(patch.tilt + n - step);
    return (2.0 / 3) * near - (1.0 / 12) * far + 0.5 * tilts;
}

}  // namespace

void hold_on_grid(const NodeRange& range, double gravity, bool wall, NodeGrid& nodes) {
    if (!may_share(range, nodes)) return;
    Patch patch;
    fill(patch, range, wall, nodes);
    bool shares = false;
    for_fours(range, 0, [&](std::int64_t n) {
        const Quad share = share_of(patch, n);
        share.store(patch.share + n);
        shares = shares || any(share > Quad(0.0));
    });
    if (!shares) return;
    for_fours(range, 1, [&](std::int64_t n) { tilt_of(patch, n).store(patch.tilt + n); });
    const double weight = -0.5 * gravity * nodes.cell_size();
    for (std::int64_t j = range.j0; j < range.j1; ++j) {
        for (std::int64_t i = range.i0; i < range.i1; i += 4) {
            const std::int64_t n = Patch::at(i - range.i0, j - range.j0);
            const Quad share = Quad::load(patch.share + n);
            if (!any(share > Quad(0.0))) continue;
            const Quad x = weight * share * force_of(patch, n, 1);
            const Quad y = weight * share * force_of(patch, n, Patch::k_columns);
            for (int lane = 0; lane < 4 && i + lane < range.i1; ++lane) {
                const auto node = static_cast<std::size_t>(j * nodes.stride() + i + lane);
                if (!(share[lane] > 0)) continue;
                nodes.levels[node].share = share[lane];
                if (wall && nodes.is_ghost(i + lane, j)) continue;
                nodes.forces()[node].fx += x[lane];
                nodes.forces()[node].fy += y[lane];
            }
        }
    }
}

}  // namespace frana
