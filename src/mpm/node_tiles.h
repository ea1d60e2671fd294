// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>

#include "mpm/node_grid.h"
#include "particles/tile_order.h"

namespace frana {

/// The padded index range [i0, i1) x [j0, j1) of a tile's nodes; each node belongs to exactly one tile.
struct NodeRange {
    std::int64_t i0, i1, j0, j1;

    NodeRange(std::int64_t tile, const TileGrid& tiles, const NodeGrid& nodes) noexcept
        : i0(within(tile % tiles.tiles_x() * k_tile - tiles.before_x(), nodes.stride())),
          i1(within((tile % tiles.tiles_x() + 1) * k_tile - tiles.before_x(), nodes.stride())),
          j0(within(tile / tiles.tiles_x() * k_tile - tiles.before_y(), nodes.padded_rows())),
          j1(within((tile / tiles.tiles_x() + 1) * k_tile - tiles.before_y(), nodes.padded_rows())) {}

    /// Calls visit(index, i, j) for every node, i and j padded.
    template <class Visit>
    void for_each(std::int64_t stride, const Visit& visit) const {
        for (std::int64_t j = j0; j < j1; ++j) {
            for (std::int64_t i = i0; i < i1; ++i) visit(static_cast<std::size_t>(j * stride + i), i, j);
        }
    }

  private:
    static std::int64_t within(std::int64_t node, std::int64_t count) noexcept {
        return std::clamp<std::int64_t>(node, 0, count);
    }
};

/// Zeroes the records of one tile's nodes, in any phase.
inline void clear_nodes(const NodeRange& range, NodeGrid& nodes) {
    for (std::int64_t j = range.j0; j < range.j1; ++j) {
        NodeRecord* row = nodes.records.data() + j * nodes.stride();
        std::fill(row + range.i0, row + range.i1, NodeRecord{});
    }
}

}  // namespace frana
