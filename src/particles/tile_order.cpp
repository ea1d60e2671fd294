// SPDX-License-Identifier: Apache-2.0
#include "particles/tile_order.h"

#include <algorithm>

namespace frana {
namespace {

// Returns the tile of a node in one direction; the nearest for nodes outside all tiles.
std::int64_t tile_at(std::int64_t node, std::int64_t count) {
    return std::clamp<std::int64_t>(node / k_tile, 0, count - 1);
}

}  // namespace

void TileOrder::sort(ParticleSet& particles, const std::vector<std::uint8_t>& keep, ThreadPool& pool) {
    // Blocks are counted in parallel and placed one after another, tile by tile: a stable counting sort whose result
    // depends neither on the blocks nor on the threads.
    constexpr std::size_t k_smallest_block = 16384, k_most_blocks = 64;
    const std::size_t n = particles.size();
    const std::size_t block = std::max(k_smallest_block, (n + k_most_blocks - 1) / k_most_blocks);
    const double* x = particles[Field::x];
    const double* y = particles[Field::y];
    keys_.resize(n);
    source_.resize(n);
    blocks_.resize((n + block - 1) / block);
    pool.for_blocks(n, block, [&](std::size_t begin, std::size_t end) {
        std::vector<std::int32_t>& found = blocks_[begin / block].found;
        found.clear();
        for (std::size_t p = begin; p < end; ++p) {
            const std::int32_t key = keep.empty() || keep[p] ? static_cast<std::int32_t>(tile_of(x[p], y[p])) : -1;
            keys_[p] = key;
            if (key >= 0 && (found.empty() || found.back() != key)) found.push_back(key);
        }
    });
    list_tiles();
    pool.for_blocks(n, block, [&](std::size_t begin, std::size_t end) {
        std::vector<std::uint32_t>& places = blocks_[begin / block].places;
        places.assign(tiles_.size(), 0);
        for (std::size_t p = begin; p < end; ++p) {
            if (keys_[p] >= 0) ++places[static_cast<std::size_t>(rank_[static_cast<std::size_t>(keys_[p])] - 1)];
        }
    });
    place_blocks();
    const std::size_t kept = tiles_.empty() ? 0 : tiles_.back().end;
    pool.for_blocks(n, block, [&](std::size_t begin, std::size_t end) {
        Block& b = blocks_[begin / block];
        b.in_order = true;
        for (std::size_t p = begin; p < end; ++p) {
            if (keys_[p] < 0) continue;
            const std::uint32_t to =
                b.places[static_cast<std::size_t>(rank_[static_cast<std::size_t>(keys_[p])] - 1)]++;
            source_[to] = static_cast<std::uint32_t>(p);
            b.in_order = b.in_order && to == p;
        }
    });
    const bool in_order = std::all_of(blocks_.begin(), blocks_.end(), [](const Block& b) { return b.in_order; });
    if (kept != n || !in_order) {
        particles.rebuild(
            kept, (kept + block - 1) / block,
            [&](Field, const double* from, double* to, std::size_t part) {
                const std::size_t end = std::min(kept, (part + 1) * block);
                for (std::size_t i = part * block; i < end; ++i) to[i] = from[source_[i]];
            },
            pool);
    }
    index_tiles(particles, pool);
}

// Lists the tiles of all blocks, in ascending order, and their ranks.
void TileOrder::list_tiles() {
    for (const ParticleTile& tile : tiles_) rank_[static_cast<std::size_t>(tile.tile)] = 0;
    tiles_.clear();
    for (const Block& block : blocks_) {
        for (const std::int32_t tile : block.found) {
            if (rank_[static_cast<std::size_t>(tile)] != 0) continue;
            rank_[static_cast<std::size_t>(tile)] = 1;
            tiles_.push_back({0, 0, tile});
        }
    }
    std::sort(tiles_.begin(), tiles_.end(),
              [](const ParticleTile& a, const ParticleTile& b) { return a.tile < b.tile; });
    std::int32_t rank = 0;
    for (const ParticleTile& tile : tiles_) rank_[static_cast<std::size_t>(tile.tile)] = ++rank;
}

// Converts the counts of the blocks to places, and sets the runs of the tiles.
void TileOrder::place_blocks() {
    std::uint32_t place = 0;
    for (std::size_t t = 0; t < tiles_.size(); ++t) {
        tiles_[t].begin = place;
        for (Block& block : blocks_) {
            const std::uint32_t count = block.places[t];
            block.places[t] = place;
            place += count;
        }
        tiles_[t].end = place;
    }
}

void TileOrder::set_counts(const std::vector<std::size_t>& counts) {
    std::size_t begin = 0;
    for (std::size_t t = 0; t < tiles_.size(); ++t) {
        tiles_[t].begin = begin;
        begin += counts[t];
        tiles_[t].end = begin;
    }
}

void TileOrder::index_tiles(const ParticleSet& particles, ThreadPool& pool) {
    const double* x = particles[Field::x];
    const double* y = particles[Field::y];
    // One cell more than the drift for the stencil, one for rounding.
    const double reach = (k_drift_limit + 2) * grid_.cell_size;
    pool.for_each(tiles_.size(), [&](std::size_t t) {
        ParticleTile& tile = tiles_[t];
        const auto [west, east] = std::minmax_element(x + tile.begin, x + tile.end);
        const auto [south, north] = std::minmax_element(y + tile.begin, y + tile.end);
        tile.x0 = tile_at(grid_.node_x(*west - reach), grid_.tiles_x());
        tile.x1 = tile_at(grid_.node_x(*east + reach), grid_.tiles_x());
        tile.y0 = tile_at(grid_.node_y(*south - reach), grid_.tiles_y());
        tile.y1 = tile_at(grid_.node_y(*north + reach), grid_.tiles_y());
    });
    list_nodes();
}

void TileOrder::list_nodes() {
    for (auto& colour : colours_) colour.clear();
    node_tiles_.clear();
    for (std::uint32_t t = 0; t < tiles_.size(); ++t) {
        const std::int64_t tx = tiles_[t].tile % grid_.tiles_x(), ty = tiles_[t].tile / grid_.tiles_x();
        colours_[static_cast<std::size_t>((ty & 1) * 2 + (tx & 1))].push_back(t);
        for (std::int64_t b = tiles_[t].y0; b <= tiles_[t].y1; ++b) {
            for (std::int64_t a = tiles_[t].x0; a <= tiles_[t].x1; ++a) {
                node_tiles_.push_back(b * grid_.tiles_x() + a);
            }
        }
    }
    std::sort(node_tiles_.begin(), node_tiles_.end());
    node_tiles_.erase(std::unique(node_tiles_.begin(), node_tiles_.end()), node_tiles_.end());
}

// Whether a particle is on the grid and all nodes of its stencil are in tiles that its own tile can touch.
bool TileOrder::contains(const ParticleTile& tile, double x, double y) const noexcept {
    const double dx = grid_.cell_size, reach = 1.5 * dx;
    const auto on = [dx](double place, std::int64_t cells, std::int64_t origin) {
        return place >= -dx * static_cast<double>(origin) && place <= dx * static_cast<double>(cells - origin);
    };  // false for non-finite values
    return on(x, grid_.columns, grid_.origin_x) && on(y, grid_.rows, grid_.origin_y) &&
           tile_at(grid_.node_x(x - reach), grid_.tiles_x()) >= tile.x0 &&
           tile_at(grid_.node_x(x + reach), grid_.tiles_x()) <= tile.x1 &&
           tile_at(grid_.node_y(y - reach), grid_.tiles_y()) >= tile.y0 &&
           tile_at(grid_.node_y(y + reach), grid_.tiles_y()) <= tile.y1;
}

bool TileOrder::restore(const ParticleSet& particles) {
    rank_ = ZeroArray<std::int32_t>(rank_.size());
    const double *x = particles[Field::x], *y = particles[Field::y];
    std::size_t begin = 0;
    std::int64_t before = -1;
    for (std::size_t t = 0; t < tiles_.size(); ++t) {
        const ParticleTile& tile = tiles_[t];
        const bool listed = tile.begin == begin && tile.end >= begin && tile.end <= particles.size() &&
                            tile.tile > before && tile.tile < grid_.tiles_x() * grid_.tiles_y() && tile.x0 >= 0 &&
                            tile.x1 < grid_.tiles_x() && tile.y0 >= 0 && tile.y1 < grid_.tiles_y();
        if (!listed) return false;
        for (std::size_t p = tile.begin; p < tile.end; ++p) {
            if (!contains(tile, x[p], y[p])) return false;
        }
        // One tile never touches another of its colour.
        const std::int64_t i = tile.tile % grid_.tiles_x(), j = tile.tile / grid_.tiles_x();
        if (tile.x0 < i - 1 || tile.x1 > i + 1 || tile.y0 < j - 1 || tile.y1 > j + 1) return false;
        rank_[static_cast<std::size_t>(tile.tile)] = static_cast<std::int32_t>(t) + 1;
        begin = tile.end;
        before = tile.tile;
    }
    list_nodes();
    return begin == particles.size();
}

}  // namespace frana
