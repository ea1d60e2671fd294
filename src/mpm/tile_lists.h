// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <vector>

#include "mpm/node_grid.h"
#include "particles/tile_order.h"

namespace frana {

/// The tiles of a grid's nodes, anchored at the local origin as those of particles are.
[[nodiscard]] inline TileGrid tiles_on(const NodeGrid& nodes) {
    const NodeScale scale = nodes.scale();
    return {nodes.columns(),         nodes.rows(), k_ghost, nodes.cell_size(), scale.origin_x - k_ghost,
            scale.origin_y - k_ghost};
}

/// Sorts a list of tiles; each is then in it once.
inline void make_ascending(std::vector<std::int64_t>& tiles) {
    std::sort(tiles.begin(), tiles.end());
    tiles.erase(std::unique(tiles.begin(), tiles.end()), tiles.end());
}

/// Whether a list that was read is one of tiles of this grid, ascending.
[[nodiscard]] inline bool are_tiles_of(const TileGrid& grid, const std::vector<std::int64_t>& tiles) {
    return (tiles.empty() || (tiles.front() >= 0 && tiles.back() < grid.tiles_x() * grid.tiles_y())) &&
           std::adjacent_find(tiles.begin(), tiles.end(), std::greater_equal<>()) == tiles.end();
}

}  // namespace frana
