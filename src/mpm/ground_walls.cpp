// SPDX-License-Identifier: Apache-2.0
#include "mpm/ground_walls.h"

#include "mpm/shape.h"

namespace frana {

namespace {

std::int64_t cell_of(double at, const NodeScale& grid) noexcept {
    return whole_below(at * grid.inverse_dx);
}

// Whether a point moves to another cell of the terrain.
bool changes_cell(const NodeGrid& nodes, Point from, Point to) noexcept {
    const NodeScale grid = nodes.scale();
    return nodes.bounds().contains(to.x, to.y) && grid.node_of(from.x, from.y) != grid.node_of(to.x, to.y);
}

// A way along one axis.
struct Way {
    double from, motion;
    std::int64_t next;     // from a node to the one ahead
    std::int64_t at, end;  // cells

    Way(double begin, double to, std::int64_t to_next, const NodeScale& grid) noexcept
        : from(begin),
          motion(to - begin),
          next(motion > 0 ? to_next : -to_next),
          at(cell_of(begin, grid)),
          end(cell_of(to, grid)) {}

    // To the next face [m].
    [[nodiscard]] double distance(double dx) const noexcept {
        return std::abs(static_cast<double>(motion > 0 ? at + 1 : at) * dx - from);
    }
    // When it is crossed [parts of the way].
    [[nodiscard]] double crossing(double dx) const noexcept { return at == end ? 2 : distance(dx) / std::abs(motion); }
    void cross() noexcept { at += motion > 0 ? 1 : -1; }
};

// Multiplies the motion along each axis by kept(motion, node, node ahead) of the first wall on the way through the
// cells, in the order in which it crosses them; where a wall shortens it, it is another way. Neither axis comes first:
// what goes through a corner meets the walls of both sides, and those of the cell beyond if they stop it on both ways.
template <class Keep>
Kept pass_walls(const NodeGrid& nodes, Point from, Point& to, const Keep& kept) noexcept {
    const NodeScale grid = nodes.scale();
    Kept part;
    const auto meet = [&](const Way& way, double before, std::size_t node) {
        const std::size_t ahead = node + static_cast<std::size_t>(way.next);
        return before < 1 || !is_wall_ahead(nodes, node, way.next) ? 1.0 : kept(way.motion, node, ahead);
    };
    Way x(from.x, to.x, 1, grid), y(from.y, to.y, grid.stride, grid);
    while (x.at != x.end || y.at != y.end) {
        const std::size_t node = grid.index(x.at, y.at);
        const double by_x = x.crossing(grid.dx), by_y = y.crossing(grid.dx);
        Kept here;
        if (by_x <= by_y) here.x = meet(x, part.x, node);
        if (by_y <= by_x) here.y = meet(y, part.y, node);
        if (by_x == by_y && here.x == 1 && here.y == 1) {
            here.x = meet(x, part.x, node + static_cast<std::size_t>(y.next));
            here.y = meet(y, part.y, node + static_cast<std::size_t>(x.next));
            if (here.x == 1 || here.y == 1) here = {};
        }
        if (here.x < 1 || here.y < 1) {
            to = {from.x + here.x * x.motion, from.y + here.y * y.motion};
            part = {part.x * here.x, part.y * here.y};
            x = Way(from.x, to.x, 1, grid);
            y = Way(from.y, to.y, grid.stride, grid);
            continue;
        }
        if (by_x <= by_y) x.cross();
        if (by_y <= by_x) y.cross();
    }
    return part;
}

// The part of a flow that goes over a wall: what is above it, at its speed or, slower than its waves, by that of a
// broad-crested weir under its head, q = sqrt(g) (2 E / 3)^(3/2) with E = h + u^2 / 2 g (Henderson 1966, Open Channel
// Flow, chapter 6).
double over_crest(double motion, double root, double depth, double height) noexcept {
    const double over = depth - height, own = std::abs(motion);
    if (!(over > 0)) return 0;
    const double critical = root * std::sqrt(over), head = (2 + (own / critical) * (own / critical)) / 3;
    return std::min(1.0, over / depth * (own < critical ? critical / own * head * std::sqrt(head) : 1));
}

}  // namespace

Kept keep_at_walls(const NodeGrid& nodes, double depth, double root, Point from, Point& to) noexcept {
    Kept kept;
    if (!nodes.bounds().contains(to.x, to.y)) return kept;
    const NodeScale grid = nodes.scale();
    const std::size_t start = grid.node_of(from.x, from.y);
    const auto height = [&](std::size_t node, std::size_t ahead) { return nodes.bed[ahead] - nodes.bed[node]; };
    const auto before = [&](const Way& way, double& end, double& part) {
        if (way.motion == 0 || !is_wall_ahead(nodes, start, way.next)) return;
        const double wall = height(start, start + static_cast<std::size_t>(way.next));
        const double over = over_crest(way.motion, root, depth, wall), courant = std::abs(way.motion) * grid.inverse_dx;
        if (over < 1) {
            const double held = 1 - over, reach = way.distance(grid.dx) + over / held * grid.dx;
            end = way.from + std::copysign(reach * (1 - std::exp(-held * courant)), way.motion);
        }
        part = 1 / (1 + std::min(1.0, wall / depth) * courant);
        if (!(depth > wall)) kept.part.met += courant;
    };
    before(Way(from.x, to.x, 1, grid), to.x, kept.x);
    before(Way(from.y, to.y, grid.stride, grid), to.y, kept.y);
    if (grid.node_of(to.x, to.y) == start) return kept;
    const Kept beyond = pass_walls(nodes, from, to, [&](double motion, std::size_t node, std::size_t ahead) {
        const double over = over_crest(motion, root, depth, height(node, ahead));
        if (node != start || over == 0) return over;
        kept.part.passed = 1;
        return 1.0;
    });
    return {kept.x * beyond.x, kept.y * beyond.y, kept.part};
}

bool stop_jet_at_walls(const NodeGrid& nodes, double height, Point from, Point& to) noexcept {
    if (!changes_cell(nodes, from, to)) return false;
    const Kept kept = pass_walls(
        nodes, from, to, [&](double, std::size_t, std::size_t ahead) { return height < nodes.bed[ahead] ? 0.0 : 1.0; });
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
