// SPDX-License-Identifier: Apache-2.0
#include "particles/tile_order.h"

#include <algorithm>

namespace frana {

void TileOrder::sort(ParticleSet& particles, const std::vector<std::uint8_t>& keep, ThreadPool& pool) {
    const std::size_t n = particles.size();
    const double* x = particles[Field::x];
    const double* y = particles[Field::y];
    keys_.resize(n);
    pool.for_blocks(n, 8192, [&](std::size_t begin, std::size_t end) {
        for (std::size_t p = begin; p < end; ++p) {
            keys_[p] = keep.empty() || keep[p] ? tile_of(x[p], y[p]) : -1;
        }
    });

    // Counting sort over the tiles met; their numbers are few, so the count array spans only [lowest,
    // highest].
    std::int64_t lowest = grid_.tiles_x() * grid_.tiles_y(), highest = -1;
    for (const std::int64_t key : keys_) {
        if (key < 0) continue;
        lowest = std::min(lowest, key);
        highest = std::max(highest, key);
    }
    std::vector<std::size_t> start(highest >= lowest ? static_cast<std::size_t>(highest - lowest + 2) : 1, 0);
    for (const std::int64_t key : keys_) {
        if (key >= 0) ++start[static_cast<std::size_t>(key - lowest + 1)];
    }
    tiles_.clear();
    for (std::size_t t = 1; t < start.size(); ++t) {
        if (start[t] > 0) {
            tiles_.push_back(
                {start[t - 1], start[t - 1] + start[t], lowest + static_cast<std::int64_t>(t) - 1});
        }
        start[t] += start[t - 1];
    }
    const std::size_t kept = start.back();
    target_.resize(n);
    bool in_order = kept == n;
    for (std::size_t p = 0; p < n; ++p) {
        target_[p] = keys_[p] < 0 ? n : start[static_cast<std::size_t>(keys_[p] - lowest)]++;
        in_order = in_order && target_[p] == p;
    }
    if (!in_order) particles.permute(target_, kept, pool);
    index_tiles(particles);
}

void TileOrder::set_counts(const std::vector<std::size_t>& counts) {
    std::size_t begin = 0;
    for (std::size_t t = 0; t < tiles_.size(); ++t) {
        tiles_[t].begin = begin;
        begin += counts[t];
        tiles_[t].end = begin;
    }
}

void TileOrder::index_tiles(const ParticleSet& particles) {
    for (auto& colour : colours_) colour.clear();
    node_tiles_.clear();
    const double* x = particles[Field::x];
    const double* y = particles[Field::y];
    // One cell more than the drift for the stencil, one for rounding.
    const double reach = (k_drift_limit + 2) * grid_.cell_size;
    const auto tile_at = [&](double position, std::int64_t count) {
        const auto cell =
            static_cast<std::int64_t>(position / grid_.cell_size + static_cast<double>(grid_.ghost));
        return std::clamp<std::int64_t>(cell / k_tile, 0, count - 1);
    };
    for (std::uint32_t t = 0; t < tiles_.size(); ++t) {
        const ParticleTile& tile = tiles_[t];
        const std::int64_t tx = tile.tile % grid_.tiles_x(), ty = tile.tile / grid_.tiles_x();
        colours_[static_cast<std::size_t>((ty & 1) * 2 + (tx & 1))].push_back(t);
        const auto [west, east] = std::minmax_element(x + tile.begin, x + tile.end);
        const auto [south, north] = std::minmax_element(y + tile.begin, y + tile.end);
        const std::int64_t x1 = tile_at(*east + reach, grid_.tiles_x()),
                           y1 = tile_at(*north + reach, grid_.tiles_y());
        for (std::int64_t b = tile_at(std::max(*south - reach, 0.0), grid_.tiles_y()); b <= y1; ++b) {
            for (std::int64_t a = tile_at(std::max(*west - reach, 0.0), grid_.tiles_x()); a <= x1; ++a) {
                node_tiles_.push_back(b * grid_.tiles_x() + a);
            }
        }
    }
    std::sort(node_tiles_.begin(), node_tiles_.end());
    node_tiles_.erase(std::unique(node_tiles_.begin(), node_tiles_.end()), node_tiles_.end());
}

}  // namespace frana
