// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <random>
#include <vector>

#include "particles/tile_order.h"

namespace frana {
namespace {

constexpr double k_side = 2, k_extent = 150;  // [m]: five tiles of 32 m along either axis

TileOrder empty_order() {
    return TileOrder({75, 75, 2, k_side, 3, 5});
}

ParticleRow numbered(double x, double y, double number) {
    ParticleRow r = ParticleSet::initial_row();
    get(r, Field::x) = x - 3 * k_side;  // from the origin, cell (3, 5)
    get(r, Field::y) = y - 5 * k_side;
    get(r, Field::volume) = number;
    return r;
}

ParticleSet scattered(int count, double extent, std::mt19937& random) {
    std::uniform_real_distribution<double> place(0, extent);
    ParticleSet particles;
    for (int i = 0; i < count; ++i) {
        const double x = place(random);
        particles.push_back(numbered(x, place(random), i));
    }
    return particles;
}

std::vector<double> numbers(const ParticleSet& particles, std::size_t begin, std::size_t end) {
    return {particles[Field::volume] + begin, particles[Field::volume] + end};
}

// The numbers of each tile's particles.
std::map<std::int64_t, std::vector<double>> by_tile(const TileOrder& order, const ParticleSet& particles) {
    std::map<std::int64_t, std::vector<double>> found;
    for (const ParticleTile& tile : order.tiles())
        if (tile.begin < tile.end) found[tile.tile] = numbers(particles, tile.begin, tile.end);
    return found;
}

TEST(TileOrder, SortsByTileAndKeepsTheOrderWithin) {
    std::mt19937 random(20240517);
    ThreadPool pool(2);
    ParticleSet particles = scattered(40000, k_extent, random);  // three blocks of the sort
    std::vector<std::uint8_t> keep(particles.size(), 1);
    for (std::size_t p = 0; p < keep.size(); p += 7) keep[p] = 0;
    TileOrder order = empty_order();
    std::map<std::int64_t, std::vector<double>> expected;
    for (std::size_t p = 0; p < keep.size(); ++p)
        if (keep[p] != 0)
            expected[order.tile_of(particles[Field::x][p], particles[Field::y][p])].push_back(
                particles[Field::volume][p]);
    order.plan(particles, keep, pool);
    for (const ParticleTile& tile : order.tiles()) {
        for (std::size_t i = tile.begin; i < tile.end; ++i) {
            // Tiles are anchored at the origin's cell, two ghosts before it.
            const std::size_t p = order.source()[i];
            const double column = std::floor(particles[Field::x][p] / k_side),
                         row = std::floor(particles[Field::y][p] / k_side);
            const auto within = [](double cell) { return (static_cast<int>(cell) + 2 + 32) % 16; };
            ASSERT_EQ(order.cells()[i], within(row) * 16 + within(column)) << i;
        }
    }
    order.apply(particles, pool);
    EXPECT_EQ(by_tile(order, particles), expected);
    EXPECT_EQ(particles.size(), 40000U - 5715U);
    EXPECT_TRUE(order.restore(particles));
    order.apply(particles, pool);  // nothing is left to do
    EXPECT_EQ(by_tile(order, particles), expected);
}

// Against the same done with lists; also when a tile loses all its particles, and when a tile gets its first.
TEST(TileOrder, IsAmendedByWhatLeavesAndWhatComes) {
    std::mt19937 random(7);
    ThreadPool pool(1);
    for (const int newcomers : {0, 1, 40, 400}) {
        for (const std::size_t every : {std::size_t{1}, std::size_t{3}, std::size_t{50}, std::size_t{100000}}) {
            ParticleSet particles = scattered(2000, 0.6 * k_extent, random);
            TileOrder order = empty_order();
            order.sort(particles, {}, pool);
            const std::size_t first = particles.size();
            auto expected = by_tile(order, particles);
            const std::int64_t emptied = order.tiles()[2].tile;
            std::vector<std::size_t> dropped;
            for (std::size_t p = 0; p < first; ++p) {
                const ParticleTile& tile = order.tiles()[2];
                if (p % every != every - 1 && (p < tile.begin || p >= tile.end)) continue;
                dropped.push_back(p);
                for (auto& [number, run] : expected) std::erase(run, particles[Field::volume][p]);
            }
            const ParticleSet more = scattered(newcomers, k_extent, random);
            for (std::size_t i = 0; i < more.size(); ++i) {
                ParticleRow row = more.row(i);
                get(row, Field::volume) += 1e6;
                particles.push_back(row);
                expected[order.tile_of(get(row, Field::x), get(row, Field::y))].push_back(get(row, Field::volume));
            }
            std::erase_if(expected, [](const auto& tile) { return tile.second.empty(); });
            order.amend(particles, dropped, first);
            EXPECT_EQ(by_tile(order, particles), expected) << newcomers << " newcomers, dropped every " << every;
            EXPECT_EQ(particles.size(), first - dropped.size() + more.size());
            // All their nodes are in the tiles that are listed, and tiles of a colour are apart.
            EXPECT_TRUE(order.restore(particles));
            for (std::size_t p = 0; p < particles.size(); ++p)
                EXPECT_TRUE(std::binary_search(order.node_tiles().begin(), order.node_tiles().end(),
                                               order.tile_of(particles[Field::x][p], particles[Field::y][p])));
            order.sort(particles, {}, pool);
            EXPECT_EQ(by_tile(order, particles), expected);
            EXPECT_TRUE(newcomers > 0 || expected.count(emptied) == 0);
        }
    }
}

}  // namespace
}  // namespace frana
