// SPDX-License-Identifier: Apache-2.0
#include "models/finite_volume/jumps.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "models/finite_volume/step.h"

namespace frana::finite_volume {
namespace {

// The jump on the way from a cell to the next; its fraction is 0 where nothing flies.
Jump jump_from(const State& s, const Laws& laws, std::size_t k) {
    const double h = s.depth[k];
    const Point along{s.qx[k] / h, s.qy[k] / h};
    if (!(h > laws.values.dry) || !s.edges.may_jump(k, along, laws.jumps.gravity)) return {};
    JumpRules rules = laws.jumps;
    rules.bearing = 1 - s.pores(k).ratio;
    const CellMotion motion = motion_of(s, laws, k);
    const auto cell = static_cast<std::int64_t>(k);
    const Point middle = s.nodes.middle(cell % s.nodes.stride(), cell / s.nodes.stride());
    // A bend of the splines begins at the border of a cell; there the slope is least and the flow fastest in map view.
    const double size = s.nodes.cell_size(), reach = size / std::hypot(motion.u, motion.v),
                 begin = 0.501 * size / std::max(std::abs(motion.u), std::abs(motion.v));
    return find_jump(s.nodes, rules, {middle.x + begin * motion.u, middle.y + begin * motion.v}, along, h, reach)
        .value_or(Jump{});
}

}  // namespace

void find_jumps(State& s, const Laws& laws, double dt, ThreadPool& pool) {
    constexpr std::int64_t k_interval = 4;
    s.untested += dt;
    if (!laws.flies || s.steps % k_interval != 0) return;
    const double time = std::exchange(s.untested, 0);
    std::vector<std::int64_t> steep;
    if (s.nodes.bed_changes) s.edges.forget(s.wet);
    for (const std::int64_t tile : s.wet)
        if (s.records[static_cast<std::size_t>(tile)].i1 != 0 && s.edges.examine(tile, s.tiles, s.nodes, laws.jumps))
            steep.push_back(tile);
    std::vector<JumpStatistics> found(steep.size());
    pool.for_each(steep.size(), [&](std::size_t n) {
        NodeRange(steep[n], s.tiles, s.nodes)
            .for_each(s.nodes.stride(), [&](std::size_t k, std::int64_t, std::int64_t) {
                const Jump jump = jump_from(s, laws, k);
                if (!(jump.duration > 0)) return;
                const CellMotion motion = motion_of(s, laws, k);
                const double speed = std::hypot(motion.u, motion.v);
                const std::size_t before =
                    k - static_cast<std::size_t>(std::lround(motion.v / speed) * s.nodes.stride() +
                                                 std::lround(motion.u / speed));
                const double thrown = jump.fraction - jump_from(s, laws, before).fraction;
                const double flux = s.depth[k] * speed;
                if (thrown > 0) found[n].add(thrown * flux * time * s.nodes.cell_size(), jump);
            });
    });
    for (const JumpStatistics& jumps : found) s.jumps.merge(jumps);
}

}  // namespace frana::finite_volume
