// SPDX-License-Identifier: Apache-2.0
#include "mpm/active_tiles.h"

#include <algorithm>
#include <numeric>

namespace frana {

bool ActiveTiles::rests(const ParticleTile& tile) const {
    bool rests = true;
    for_touched(tile, [&](std::int64_t t) { rests = rests && still_[static_cast<std::size_t>(t)] == k_still_steps; });
    return rests;
}

bool ActiveTiles::any_rests(const TileOrder& order) const {
    return std::any_of(order.tiles().begin(), order.tiles().end(),
                       [&](const ParticleTile& tile) { return rests(tile); });
}

void ActiveTiles::activate(const TileOrder& order) {
    for (const std::int64_t tile : order.node_tiles()) reset(tile);
}

void ActiveTiles::activate_round(std::int64_t tile) {
    for_round(tile, [&](std::int64_t near) { reset(near); });
}

void ActiveTiles::list_all(const TileOrder& order) {
    bringing_ = order.colours();
    moved_.resize(order.tiles().size());
    std::iota(moved_.begin(), moved_.end(), 0U);
    cleared_ = updated_ = order.node_tiles();
    gathered_.clear();
    kept_tiles_.clear();
}

// Raises the role of the neighbours of tiles with role `from` or higher to `to`, where it is lower.
void ActiveTiles::spread(const TileOrder& order, Role from, Role to) {
    for (const std::int64_t tile : order.node_tiles()) {
        if (role(tile) < from) continue;
        for_round(tile, [&](std::int64_t near) { role(near) = std::max<std::uint8_t>(role(near), to); });
    }
}

void ActiveTiles::choose(const TileOrder& order, bool may_rest) {
    const auto& tiles = order.tiles();
    if (!may_rest || !any_rests(order)) return list_all(order);

    for (const std::int64_t tile : order.node_tiles()) role(tile) = idle;
    for (const ParticleTile& tile : tiles) {
        if (!rests(tile)) for_touched(tile, [&](std::int64_t t) { role(t) = changes; });
    }
    spread(order, changes, updates);
    spread(order, updates, gathers);
    for (auto& colour : bringing_) colour.clear();
    moved_.clear();
    const auto plays = [&](const ParticleTile& tile, Role least) {
        bool found = false;
        for_touched(tile, [&](std::int64_t t) { found = found || role(t) >= least; });
        return found;
    };
    for (std::size_t c = 0; c < bringing_.size(); ++c) {
        for (const std::uint32_t t : order.colours()[c]) {
            if (plays(tiles[t], gathers)) bringing_[c].push_back(t);
        }
    }
    for (std::uint32_t t = 0; t < tiles.size(); ++t) {
        if (plays(tiles[t], updates)) moved_.push_back(t);
    }
    for (const auto& colour : bringing_) {
        for (const std::uint32_t t : colour) {
            for_touched(tiles[t], [&](std::int64_t n) { role(n) = std::max<std::uint8_t>(role(n), overwritten); });
        }
    }
    cleared_.clear();
    gathered_.clear();
    updated_.clear();
    kept_tiles_.clear();
    for (const std::int64_t tile : order.node_tiles()) {
        const std::uint8_t r = role(tile);
        if (r == idle) continue;
        cleared_.push_back(tile);
        if (r >= updates) {
            updated_.push_back(tile);
        } else {
            kept_tiles_.push_back(tile);
            if (r == gathers) gathered_.push_back(tile);
        }
    }
    // Clears roles beyond the listed tiles, which must not persist after this step.
    for (const std::int64_t tile : order.node_tiles()) for_round(tile, [&](std::int64_t near) { role(near) = idle; });
}

std::size_t ActiveTiles::moved_particles(const TileOrder& order) const {
    std::size_t count = 0;
    for (const std::uint32_t t : moved_) count += order.tiles()[t].end - order.tiles()[t].begin;
    return count;
}

void ActiveTiles::keep(const NodeGrid& nodes) {
    kept_.clear();
    for (const std::int64_t tile : kept_tiles_) {
        NodeRange(tile, grid_, nodes).for_each(nodes.stride(), [&](std::size_t n, std::int64_t, std::int64_t) {
            kept_.push_back(nodes.records[n]);
        });
    }
}

void ActiveTiles::put_back(NodeGrid& nodes) const {
    std::size_t next = 0;
    for (const std::int64_t tile : kept_tiles_) {
        NodeRange(tile, grid_, nodes).for_each(nodes.stride(), [&](std::size_t n, std::int64_t, std::int64_t) {
            nodes.records[n] = kept_[next++];
        });
    }
}

}  // namespace frana
