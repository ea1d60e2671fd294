// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/thread_pool.h"
#include "core/zero_array.h"
#include "particles/particle_set.h"

namespace frana {

/// Side of a tile, in nodes.
inline constexpr std::int64_t k_tile = 16;
/// How many cells a particle may drift from the cell in which it was sorted before the next sort. With one node of the
/// stencil it must stay below half a tile: then tiles of one colour never touch the same node.
inline constexpr double k_drift_limit = 3;

/// A run of particles in one tile (up to the drift), and the nodes that they can touch.
struct ParticleTile {
    std::size_t begin = 0, end = 0;
    std::int64_t tile = 0;                          ///< row-major number of the tile
    std::int64_t x0 = 0, x1 = -1, y0 = 0, y1 = -1;  ///< tiles whose nodes they can touch until the next sort
};

template <class Archive>
void serialise(Archive& archive, ParticleTile& tile) {
    auto& [begin, end, number, x0, x1, y0, y1] = tile;
    archive(begin, end, number, x0, x1, y0, y1);
}

/// The region of particles: the grid in cells.
struct TileGrid {
    std::int64_t columns = 0, rows = 0;  ///< of cells
    std::int64_t ghost = 0;              ///< nodes before cell 0
    double cell_size = 1;
    /// Cell of the local origin. Tiles and their colours are anchored at it independent of the extent of the grid, so
    /// that sums keep their order: tiles begin outside the grid if necessary.
    std::int64_t origin_x = 0, origin_y = 0;

    [[nodiscard]] std::int64_t before_x() const noexcept { return before(origin_x); }  ///< nodes before the grid
    [[nodiscard]] std::int64_t before_y() const noexcept { return before(origin_y); }
    [[nodiscard]] std::int64_t tiles_x() const noexcept {
        return (before_x() + columns + 2 * ghost + k_tile - 1) / k_tile;
    }
    [[nodiscard]] std::int64_t tiles_y() const noexcept {
        return (before_y() + rows + 2 * ghost + k_tile - 1) / k_tile;
    }

  private:
    [[nodiscard]] static std::int64_t before(std::int64_t origin) noexcept {
        constexpr std::int64_t k_pair = 2 * k_tile;  // of different colours
        return (k_pair - origin % k_pair) % k_pair;
    }
};

/// The greatest whole number not above a value. floor() is a call of the library.
[[nodiscard]] inline std::int64_t whole_below(double value) noexcept {
    const auto whole = static_cast<std::int64_t>(value);
    return whole - (value < static_cast<double>(whole) ? 1 : 0);
}

/// Numbers the nodes of local positions, counted from the first node of the first tile.
class NodeNumbers {
  public:
    explicit NodeNumbers(const TileGrid& grid) noexcept
        : inverse_cell_(1 / grid.cell_size),
          first_x_(grid.origin_x + grid.ghost + grid.before_x()),
          first_y_(grid.origin_y + grid.ghost + grid.before_y()) {}
    [[nodiscard]] std::int64_t x(double x) const noexcept { return whole_below(x * inverse_cell_) + first_x_; }
    [[nodiscard]] std::int64_t y(double y) const noexcept { return whole_below(y * inverse_cell_) + first_y_; }

  private:
    double inverse_cell_;
    std::int64_t first_x_, first_y_;
};

/// The order of particles by tile. It fixes the order of every sum over particles, for any number of threads: tiles of
/// one colour run in parallel, colours one after another, particles of a tile in their order.
class TileOrder {
  public:
    explicit TileOrder(TileGrid grid) : grid_(grid), rank_(static_cast<std::size_t>(grid.tiles_x() * grid.tiles_y())) {}

    /// Sorts the particles by tile (stable) and drops those for which `keep` is 0. At most 2^32 particles.
    /// @param keep one byte per particle, or empty to keep all
    void sort(ParticleSet& particles, const std::vector<std::uint8_t>& keep, ThreadPool& pool) {
        plan(particles, keep, pool);
        apply(particles, pool);
    }
    /// The same in two parts: tiles and places of the particles, then their moves. resample() moves them likewise.
    void plan(const ParticleSet& particles, const std::vector<std::uint8_t>& keep, ThreadPool& pool);
    void apply(ParticleSet& particles, ThreadPool& pool);
    /// Between plan and apply: the present index of each place's particle, and its cell in its tile, row by row.
    [[nodiscard]] const std::vector<std::uint32_t>& source() const noexcept { return source_; }
    [[nodiscard]] const std::vector<std::uint8_t>& cells() const noexcept { return cells_; }
    /// Drops particles and puts those that were appended from `first` on at the ends of their tiles; tiles and order of
    /// the others stay, and so does the drift that they have left until the next sort. A tile may lose all particles.
    /// @param dropped indices below `first`, ascending
    void amend(ParticleSet& particles, const std::vector<std::size_t>& dropped, std::size_t first);
    /// Instead of apply, by who has moved the particles: their number in each of tiles().
    void set_counts(const std::vector<std::size_t>& counts);

    [[nodiscard]] const std::vector<ParticleTile>& tiles() const noexcept { return tiles_; }
    /// Indices into tiles(), by colour.
    [[nodiscard]] const std::array<std::vector<std::uint32_t>, 4>& colours() const noexcept { return colours_; }
    /// Tiles with nodes that any particle can touch until the next sort, in ascending order.
    [[nodiscard]] const std::vector<std::int64_t>& node_tiles() const noexcept { return node_tiles_; }
    [[nodiscard]] const TileGrid& grid() const noexcept { return grid_; }

    [[nodiscard]] std::int64_t tile_of(double x, double y) const noexcept {
        return (nodes_.y(y) / k_tile) * tiles_x_ + nodes_.x(x) / k_tile;
    }

    template <class Archive>
    void serialise(Archive& archive) {
        [[maybe_unused]] auto& [grid, nodes, tiles_x, tiles, colours, node_tiles, rank, keys, within, source, cells,
                                blocks, in_place] = *this;
        archive(tiles);  // the rest is derived or used by a sort only
    }
    /// After reading: returns whether the tiles are consistent with these particles, all of them on the grid; if so,
    /// the derived data is restored.
    [[nodiscard]] bool restore(const ParticleSet& particles);

  private:
    // Contributions of one block of particles, in the order before the sort, to each tile.
    struct Block {
        std::vector<std::int32_t> found;    // tiles, in order of first occurrence, each at least once
        std::vector<std::uint32_t> places;  // by rank of the tile: first a count, then the place of the next
        bool in_order = true;
    };

    void list_tiles();
    void place_blocks();
    void index_tiles();
    void reach_from(ParticleTile& tile, std::int64_t west, std::int64_t east, std::int64_t south,
                    std::int64_t north) const noexcept;
    void list_nodes();
    [[nodiscard]] bool contains(const ParticleTile& tile, double x, double y) const noexcept;

    TileGrid grid_;
    NodeNumbers nodes_{grid_};
    std::int64_t tiles_x_ = grid_.tiles_x();
    std::vector<ParticleTile> tiles_;
    std::array<std::vector<std::uint32_t>, 4> colours_;
    std::vector<std::int64_t> node_tiles_;
    ZeroArray<std::int32_t> rank_;       // rank of each tile of the grid, plus one; 0 for others
    std::vector<std::int32_t> keys_;     // tile of each particle, -1 for those dropped
    std::vector<std::uint8_t> within_;   // cell of each particle in its tile
    std::vector<std::uint32_t> source_;  // former index of the particle at each place
    std::vector<std::uint8_t> cells_;    // within_ of the particle at each place
    std::vector<Block> blocks_;
    bool in_place_ = true;  // whether all particles are at their places
};

}  // namespace frana
