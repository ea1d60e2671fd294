// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "core/zero_array.h"
#include "mpm/node_grid.h"
#include "mpm/node_tiles.h"
#include "particles/tile_order.h"

namespace frana {

/// Which tiles a step computes: those where anything moves or could begin to. What rests is left as it is, and its
/// result is what the step would have given again.
///
/// A node tile is still in a step when no node of it moves after the update. Particles whose node tiles were all still
/// for two steps bring the nodes what they brought before: their velocities are zero and nothing else of them changed.
/// So, from the inside out:
///   changing   node tiles that any other particles touch
///   updated    those and their neighbours, since levels and holding look one node further; their nodes get a new
///              velocity, and particles that touch them are moved
///   gathered   the neighbours of those, whose sums and forces the updated nodes look at
/// Particles that touch an updated or gathered tile bring their sums. What these overwrite outside the updated tiles is
/// kept aside and put back (keep, put_back).
class ActiveTiles {
  public:
    explicit ActiveTiles(const TileGrid& grid)
        : grid_(grid),
          still_(static_cast<std::size_t>(grid.tiles_x() * grid.tiles_y())),
          role_(static_cast<std::size_t>(grid.tiles_x() * grid.tiles_y())) {}

    /// Lists the tiles of the next step. Without `may_rest` they are all there.
    void choose(const TileOrder& order, bool may_rest);
    /// Everything is changing until seen still: someone else wrote to nodes or particles.
    void activate(const TileOrder& order);
    /// Particles crossed into or out of a tile: what they bring is no longer told of in their tile's last report.
    void activate_round(std::int64_t tile);
    /// A node tile that nothing touches any more.
    void reset(std::int64_t tile) { still_[static_cast<std::size_t>(tile)] = 0; }
    /// Tells of an updated node tile whether any of its nodes moves. Tiles may be told of side by side.
    void record_motion(std::int64_t tile, bool moves) {
        std::uint8_t& steps = still_[static_cast<std::size_t>(tile)];
        steps = moves ? 0 : steps < k_still_steps ? static_cast<std::uint8_t>(steps + 1) : steps;
    }
    /// Whether the tile's particles brought the nodes the same in the last two steps.
    [[nodiscard]] bool rests(const ParticleTile& tile) const;
    [[nodiscard]] bool any_rests(const TileOrder& order) const;

    /// Keeps the sums of the nodes that will be overwritten but not updated; puts them back.
    void keep(const NodeGrid& nodes);
    void put_back(NodeGrid& nodes) const;

    /// Indices into TileOrder::tiles() of the particles that bring their sums, by colour; of those that are moved.
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
        archive(still);  // the rest is chosen again in every step
    }

  private:
    static constexpr std::uint8_t k_still_steps = 2;
    enum Role : std::uint8_t { idle, overwritten, gathers, updates, changes };

    void list_all(const TileOrder& order);
    void spread(const TileOrder& order, Role from, Role to);
    // A tile and its eight neighbours, as far as there are any.
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
    ZeroArray<std::uint8_t> still_;  // by tile: for how many steps, at most k_still_steps
    ZeroArray<std::uint8_t> role_;   // by tile; of this step
    std::array<std::vector<std::uint32_t>, 4> bringing_;
    std::vector<std::uint32_t> moved_;
    std::vector<std::int64_t> cleared_, gathered_, updated_, kept_tiles_;
    std::vector<NodeRecord> kept_;
};

}  // namespace frana
