// SPDX-License-Identifier: Apache-2.0
#include "mpm/ground_walls.h"

#include "mpm/shape.h"

namespace frana {

namespace {

// Multiplies the motion along each axis by kept(motion, bottom, top) of the first wall on the way, x before y.
template <class Keep>
Kept pass_walls(const NodeGrid& nodes, Point from, Point& to, const Keep& kept) noexcept {
    const NodeScale grid = nodes.scale();
    const auto cell = [&](double at) { return whole_below(at * grid.inverse_dx); };
    const auto along = [&](std::int64_t node, std::int64_t next, std::int64_t a, std::int64_t b, double motion) {
        const std::int64_t step = a < b ? next : -next;
        for (; a != b; a += a < b ? 1 : -1, node += step) {
            const auto k = static_cast<std::size_t>(node);
            if (is_wall_ahead(nodes, k, step))
                return kept(motion, nodes.bed[k], nodes.bed[static_cast<std::size_t>(node + step)]);
        }
        return 1.0;
    };
    const std::int64_t i = cell(from.x), j = cell(from.y);
    const auto start = static_cast<std::int64_t>(grid.index(i, j));
    Kept part;
    part.x = along(start, 1, i, cell(to.x), to.x - from.x);
    if (part.x < 1) to.x = from.x + part.x * (to.x - from.x);
    part.y = along(start + cell(to.x) - i, grid.stride, j, cell(to.y), to.y - from.y);
    if (part.y < 1) to.y = from.y + part.y * (to.y - from.y);
    return part;
}

bool changes_cell(const NodeGrid& nodes, Point from, Point to) noexcept {
    const NodeScale grid = nodes.scale();
    return nodes.bounds().contains(to.x, to.y) && grid.node_of(from.x, from.y) != grid.node_of(to.x, to.y);
}

}  // namespace

Kept keep_at_walls(const NodeGrid& nodes, double depth, double crest, Point from, Point& to) noexcept {
    if (!changes_cell(nodes, from, to)) return {};
    const Stencil<QuadraticSplineShape> s(from.x, from.y, nodes.scale());
    const double surface = depth + interpolate(s, nodes.bed.data(), nodes.stride()).value;
    return pass_walls(nodes, from, to, [&](double motion, double bottom, double top) {
        const double over = std::max(0.0, surface - top), critical = crest * std::sqrt(over);
        return std::min(1.0, std::max(over / (top - bottom), critical / std::abs(motion)));
    });
}

bool stop_jet_at_walls(const NodeGrid& nodes, double height, Point from, Point& to) noexcept {
    if (!changes_cell(nodes, from, to)) return false;
    const Kept kept = pass_walls(nodes, from, to, [&](double, double, double top) { return height < top ? 0.0 : 1.0; });
    return kept.x < 1 || kept.y < 1;
}

bool WalledTiles::examine(std::int64_t tile, const TileGrid& tiles, const NodeGrid& nodes) {
    constexpr std::int64_t k_reach = 2;
    known_.resize(static_cast<std::size_t>(tiles.tiles_x() * tiles.tiles_y()), k_unknown);
    std::uint8_t& known = known_[static_cast<std::size_t>(tile)];
    if (known != k_unknown) return known == k_some;
    const NodeRange range(tile, tiles, nodes);
    const std::int64_t stride = nodes.stride();
    // A wall is judged from the node before it to the one after it.
    const std::int64_t i0 = std::max<std::int64_t>(range.i0 - k_reach, 1),
                       i1 = std::min(range.i1 + k_reach, stride - 2);
    const std::int64_t j0 = std::max<std::int64_t>(range.j0 - k_reach, 1),
                       j1 = std::min(range.j1 + k_reach, nodes.padded_rows() - 2);
    nodes.cover({i0 - 1, i1 + 2, j0 - 1, j1 + 2});
    known = k_none;
    for (std::int64_t j = j0; j < j1 && known == k_none; ++j)
        for (std::int64_t i = i0; i < i1 && known == k_none; ++i) {
            const auto node = static_cast<std::size_t>(j * stride + i);
            const auto wall = [&](std::int64_t next) {
                return is_wall_ahead(nodes, node, next) ||
                       is_wall_ahead(nodes, node + static_cast<std::size_t>(next), -next);
            };
            if (wall(1) || wall(stride)) known = k_some;
        }
    return known == k_some;
}

}  // namespace frana
