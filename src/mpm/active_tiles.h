// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "core/zero_array.h"
#include "mpm/node_grid.h"
#include "particles/tile_order.h"

namespace frana {

/// Selects the tiles that a step computes: those where anything moves or may begin to move. Tiles at rest are skipped;
/// computing them would give the values they have.
///
/// A node tile is still in a step if no node of it moves after the update. Particles whose node tiles were all still
/// for two steps contribute the same sums to the nodes: their velocities are zero and nothing else of them changed.
/// Hence, from the inside out:
///   changing   node tiles touched by any other particles
///   updated    those and their neighbours, since levels and static friction read one node further; their nodes get a
///              new velocity, and particles that touch them are moved
///   gathered   the neighbours of those, whose sums and forces the updated nodes read
/// Particles that touch an updated or gathered tile contribute their sums. Values that these overwrite outside the
/// updated tiles are saved before and restored after (keep, put_back).
class ActiveTiles {
  public:
    explicit ActiveTiles(const TileGrid& grid)
        : grid_(grid),
          still_(static_cast<std::size_t>(grid.tiles_x() * grid.tiles_y())),
          role_(static_cast<std::size_t>(grid.tiles_x() * grid.tiles_y())) {}

    /// Lists the tiles of the next step; all tiles unless `may_rest`.
    void choose(const TileOrder& order, bool may_rest);
    /// Marks all tiles as changing until they are still again: nodes or particles were changed outside a step.
    void activate(const TileOrder& order);
    /// Marks a tile that particles entered or left: their contributions are not in the tile's last report.
    void activate_round(std::int64_t tile);
    /// Resets a node tile that no particle touches any more.
    void reset(std::int64_t tile) { still_[static_cast<std::size_t>(tile)] = 0; }
    /// Records whether any node of an updated tile moves. Callable concurrently for different tiles.
    void record_motion(std::int64_t tile, bool moves) {
        std::uint8_t& steps = still_[static_cast<std::size_t>(tile)];
        steps = moves ? 0 : steps < k_still_steps ? static_cast<std::uint8_t>(steps + 1) : steps;
    }
    /// Returns whether the tile's particles contributed the same sums in the last two steps.
    [[nodiscard]] bool rests(const ParticleTile& tile) const;
    [[nodiscard]] bool any_rests(const TileOrder& order) const;

    /// Saves the sums of nodes that will be overwritten but not updated; restores them.
    void keep(const NodeGrid& nodes);
    void put_back(NodeGrid& nodes) const;

    /// Indices into TileOrder::tiles() of the particles that contribute sums, by colour; of those that are moved.
    [[nodiscard]] const std::array<std::vector<std::uint32_t>, 4>& bringing() const noexcept { return bringing_; }
    [[nodiscard]] const std::vector<std::uint32_t>& moved() const noexcept { return moved_; }
    /// Node tiles to clear at the start, to gather levels' squares from only, and to update.
    [[nodiscard]] const std::vector<std::int64_t>& cleared() const noexcept { return cleared_; }
    [[nodiscard]] const std::vector<std::int64_t>& gathered() const noexcept { return gathered_; }
    [[nodiscard]] const std::vector<std::int64_t>& updated() const noexcept { return updated_; }
    [[nodiscard]] std::size_t moved_particles(const TileOrder& order) const;

    template <class Archive>
    void serialise(Archive& archive) {
        [[maybe_unused]] auto& [grid, still, role, bringing, moved, cleared, gathered, updated, kept_tiles, kept] =
            *this;
        archive(still);  // the others are chosen again in every step
    }

  private:
    static constexpr std::uint8_t k_still_steps = 2;
    enum Role : std::uint8_t { idle, overwritten, gathers, updates, changes };

    void list_all(const TileOrder& order);
    void spread(const TileOrder& order, Role from, Role to);
    // A tile and those of its eight neighbours that exist.
    template <class Visit>
    void for_round(std::int64_t tile, const Visit& visit) const {
        const std::int64_t i = tile % grid_.tiles_x(), j = tile / grid_.tiles_x();
        for (std::int64_t b = std::max<std::int64_t>(j - 1, 0); b <= std::min(j + 1, grid_.tiles_y() - 1); ++b)
            for (std::int64_t a = std::max<std::int64_t>(i - 1, 0); a <= std::min(i + 1, grid_.tiles_x() - 1); ++a)
                visit(b * grid_.tiles_x() + a);
    }
    [[nodiscard]] std::uint8_t& role(std::int64_t tile) { return role_[static_cast<std::size_t>(tile)]; }
    template <class Visit>
    void for_touched(const ParticleTile& tile, const Visit& visit) const {
        for (std::int64_t b = tile.y0; b <= tile.y1; ++b)
            for (std::int64_t a = tile.x0; a <= tile.x1; ++a) visit(b * grid_.tiles_x() + a);
    }

    TileGrid grid_;
    ZeroArray<std::uint8_t> still_;  // by tile: number of steps, at most k_still_steps
    ZeroArray<std::uint8_t> role_;   // by tile; valid in this step
    std::array<std::vector<std::uint32_t>, 4> bringing_;
    std::vector<std::uint32_t> moved_;
    std::vector<std::int64_t> cleared_, gathered_, updated_, kept_tiles_;
    std::vector<NodeRecord> kept_;
};

}  // namespace frana
