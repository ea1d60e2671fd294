// SPDX-License-Identifier: Apache-2.0
#include "particles/tile_order.h"

#include <algorithm>
#include <limits>

namespace frana {
namespace {

// Returns the tile of a node in one direction; the nearest for nodes outside all tiles.
std::int64_t tile_at(std::int64_t node, std::int64_t count) {
    return std::clamp<std::int64_t>(node / k_tile, 0, count - 1);
}

// Particles that one task sorts, of n.
std::size_t block_of(std::size_t n) {
    constexpr std::size_t k_smallest = 16384, k_most_blocks = 64;
    return std::max(k_smallest, (n + k_most_blocks - 1) / k_most_blocks);
}

}  // namespace

// Blocks are counted in parallel and placed one after another, tile by tile: a stable counting sort whose result
// depends neither on the blocks nor on the threads.
void TileOrder::plan(const ParticleSet& particles, const std::vector<std::uint8_t>& keep, ThreadPool& pool) {
    const std::size_t n = particles.size(), block = block_of(n);
    keys_.resize(n);
    within_.resize(n);
    source_.resize(n);
    cells_.resize(n);
    blocks_.resize((n + block - 1) / block);
    pool.for_blocks(n, block, [&](std::size_t begin, std::size_t end) {
        std::vector<std::int32_t>& found = blocks_[begin / block].found;
        found.clear();
        // Copies, which writing bytes cannot change.
        const NodeNumbers nodes = nodes_;
        const std::int64_t tiles_x = tiles_x_;
        const double* const x = particles[Field::x];
        const double* const y = particles[Field::y];
        const std::uint8_t* const kept = keep.empty() ? nullptr : keep.data();
        std::int32_t* const keys = keys_.data();
        std::uint8_t* const within = within_.data();
        std::int32_t last = -1;
        for (std::size_t p = begin; p < end; ++p) {
            const std::int64_t i = nodes.x(x[p]), j = nodes.y(y[p]);
            const bool drops = kept != nullptr && kept[p] == 0;
            const std::int32_t key = drops ? -1 : static_cast<std::int32_t>(j / k_tile * tiles_x + i / k_tile);
            keys[p] = key;
            within[p] = static_cast<std::uint8_t>((j & (k_tile - 1)) * k_tile + (i & (k_tile - 1)));
            if (key != last && key >= 0) found.push_back(key);
            last = key;
        }
    });
    list_tiles();
    pool.for_blocks(n, block, [&](std::size_t begin, std::size_t end) {
        std::vector<std::uint32_t>& places = blocks_[begin / block].places;
        places.assign(tiles_.size(), 0);
        const std::int32_t *const keys = keys_.data(), *const rank = rank_.data();
        std::uint32_t* const count = places.data();
        for (std::size_t p = begin; p < end; ++p) {
            if (keys[p] >= 0) ++count[rank[keys[p]] - 1];
        }
    });
    place_blocks();
    const std::size_t kept = tiles_.empty() ? 0 : tiles_.back().end;
    pool.for_blocks(n, block, [&](std::size_t begin, std::size_t end) {
        Block& b = blocks_[begin / block];
        const std::int32_t *const keys = keys_.data(), *const rank = rank_.data();
        std::uint32_t *const places = b.places.data(), *const source = source_.data();
        std::uint8_t *const cells = cells_.data(), *const within = within_.data();
        bool in_order = true;
        for (std::size_t p = begin; p < end; ++p) {
            if (keys[p] < 0) continue;
            const std::uint32_t to = places[rank[keys[p]] - 1]++;
            source[to] = static_cast<std::uint32_t>(p);
            cells[to] = within[p];
            in_order = in_order && to == p;
        }
        b.in_order = in_order;
    });
    source_.resize(kept);
    cells_.resize(kept);
    in_place_ = kept == n && std::all_of(blocks_.begin(), blocks_.end(), [](const Block& b) { return b.in_order; });
    index_tiles();
}

void TileOrder::apply(ParticleSet& particles, ThreadPool& pool) {
    if (in_place_) return;
    in_place_ = true;
    const std::size_t n = source_.size(), block = block_of(n);
    particles.rebuild(
        n, (n + block - 1) / block,
        [&](Field, const double* from, double* to, std::size_t part) {
            const std::size_t end = std::min(n, (part + 1) * block);
            for (std::size_t i = part * block; i < end; ++i) to[i] = from[source_[i]];
        },
        pool);
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
    in_place_ = true;
}

// The nodes that the particles of each tile can touch follow from the cells that they are in.
void TileOrder::index_tiles() {
    for (ParticleTile& tile : tiles_) {
        std::uint8_t west = k_tile - 1, east = 0, south = k_tile * k_tile - 1, north = 0;
        for (std::size_t i = tile.begin; i < tile.end; ++i) {
            const std::uint8_t cell = cells_[i], column = cell % k_tile;
            west = std::min(west, column);
            east = std::max(east, column);
            south = std::min(south, cell);
            north = std::max(north, cell);
        }
        const std::int64_t i = tile.tile % tiles_x_ * k_tile, j = tile.tile / tiles_x_ * k_tile;
        tile.x0 = tile.y0 = std::numeric_limits<std::int64_t>::max();
        reach_from(tile, i + west, i + east, j + south / k_tile, j + north / k_tile);
    }
    list_nodes();
}

// Lets a tile touch what particles on these nodes can.
void TileOrder::reach_from(ParticleTile& tile, std::int64_t west, std::int64_t east, std::int64_t south,
                           std::int64_t north) const noexcept {
    // One cell more than the drift for the stencil, one for rounding.
    constexpr auto k_reach = static_cast<std::int64_t>(k_drift_limit) + 2;
    static_assert(static_cast<double>(k_reach) >= k_drift_limit + 2);
    const std::int64_t tiles_y = grid_.tiles_y();
    tile.x0 = std::min(tile.x0, tile_at(west - k_reach, tiles_x_));
    tile.x1 = std::max(tile.x1, tile_at(east + k_reach, tiles_x_));
    tile.y0 = std::min(tile.y0, tile_at(south - k_reach, tiles_y));
    tile.y1 = std::max(tile.y1, tile_at(north + k_reach, tiles_y));
}

void TileOrder::amend(ParticleSet& particles, const std::vector<std::size_t>& dropped, std::size_t first) {
    struct Appended {
        std::int64_t tile;
        ParticleRow row;
    };
    std::vector<Appended> appended;
    const auto before = [](const auto& a, const auto& b) { return a.tile < b.tile; };
    for (std::size_t p = first; p < particles.size(); ++p) {
        const double x = particles[Field::x][p], y = particles[Field::y][p];
        appended.push_back({tile_of(x, y), particles.row(p)});
        ParticleTile tile{0, 0, appended.back().tile, tiles_x_, -1, grid_.tiles_y(), -1};
        auto at = std::lower_bound(tiles_.begin(), tiles_.end(), tile, before);
        if (at == tiles_.end() || at->tile != tile.tile) {
            tile.begin = tile.end = at == tiles_.end() ? first : at->begin;
            at = tiles_.insert(at, tile);
        }
        reach_from(*at, nodes_.x(x), nodes_.x(x), nodes_.y(y), nodes_.y(y));
    }
    std::stable_sort(appended.begin(), appended.end(), before);

    // Runs of particles that move alike, in ascending order of their places before and after.
    struct Run {
        std::size_t from, to, size;
    };
    std::vector<Run> runs;
    std::size_t next = 0;  // place
    const auto keep = [&](std::size_t begin, std::size_t end) {
        const bool goes_on =
            !runs.empty() && runs.back().from + runs.back().size == begin && runs.back().to + runs.back().size == next;
        if (!goes_on) runs.push_back({begin, next, 0});
        runs.back().size += end - begin;
        next += end - begin;
    };
    auto drop = dropped.begin();
    auto one = appended.begin();
    std::vector<std::size_t> places;  // of the appended
    for (ParticleTile& tile : tiles_) {
        const std::size_t begin = next;
        std::size_t p = tile.begin;
        for (; drop != dropped.end() && *drop < tile.end; p = *drop++ + 1) keep(p, *drop);
        keep(p, tile.end);
        for (; one != appended.end() && one->tile == tile.tile; ++one) places.push_back(next++);
        tile.begin = begin;
        tile.end = next;
    }
    // In this order no run is written over before it has moved.
    for (std::size_t f = 0; f < k_fields; ++f) {
        double* const values = particles[static_cast<Field>(f)];
        if (values == nullptr) continue;
        for (const Run& r : runs)
            if (r.to < r.from) std::copy(values + r.from, values + r.from + r.size, values + r.to);
        for (auto r = runs.rbegin(); r != runs.rend(); ++r)
            if (r->to > r->from)
                std::copy_backward(values + r->from, values + r->from + r->size, values + r->to + r->size);
    }
    for (std::size_t i = 0; i < places.size(); ++i) particles.set_row(places[i], appended[i].row);
    particles.resize(next);
    list_nodes();
}

void TileOrder::list_nodes() {
    for (auto& colour : colours_) colour.clear();
    node_tiles_.clear();
    for (std::uint32_t t = 0; t < tiles_.size(); ++t) {
        const std::int64_t tx = tiles_[t].tile % tiles_x_, ty = tiles_[t].tile / tiles_x_;
        colours_[static_cast<std::size_t>((ty & 1) * 2 + (tx & 1))].push_back(t);
        for (std::int64_t b = tiles_[t].y0; b <= tiles_[t].y1; ++b) {
            for (std::int64_t a = tiles_[t].x0; a <= tiles_[t].x1; ++a) {
                node_tiles_.push_back(b * tiles_x_ + a);
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
           tile_at(nodes_.x(x - reach), grid_.tiles_x()) >= tile.x0 &&
           tile_at(nodes_.x(x + reach), grid_.tiles_x()) <= tile.x1 &&
           tile_at(nodes_.y(y - reach), grid_.tiles_y()) >= tile.y0 &&
           tile_at(nodes_.y(y + reach), grid_.tiles_y()) <= tile.y1;
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
