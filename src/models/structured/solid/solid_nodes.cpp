// SPDX-License-Identifier: Apache-2.0
#include "models/structured/solid/solid_nodes.h"

#include <algorithm>

#include "models/structured/solid/cubic_stencil.h"
#include "mpm/tile_lists.h"

namespace frana::structured {
namespace {

// A step reads the bed beside a node with solids, and moves a particle by less than a cell, to a stencil of its own.
constexpr std::int64_t k_round = 4;

}  // namespace

SolidNodes::SolidNodes(const NodeGrid& on, bool walls_in_gaps, bool coupled)
    : sums(static_cast<std::size_t>(on.stride() * on.padded_rows())),
      push(sums.size()),
      depth(sums.size()),
      u(sums.size()),
      v(sums.size()),
      solid_fraction(sums.size()),
      structured(sums.size()),
      mass(sums.size()),
      pores(sums.size()),
      grid(tiles_on(on)),
      gaps_are_walls(walls_in_gaps) {
    if (coupled) coupling = ZeroArray<CouplingSums>(sums.size());
}

void SolidNodes::clear(const NodeGrid& on, ThreadPool& pool) {
    pool.for_each(tiles.size(), [&](std::size_t t) {
        const NodeRange range(tiles[t], grid, on);
        const auto count = static_cast<std::size_t>(range.i1 - range.i0);
        for (std::int64_t j = range.j0; j < range.j1; ++j) {
            const auto begin = static_cast<std::size_t>(j * on.stride() + range.i0);
            std::fill_n(sums.data() + begin, count, SolidSums{});
            if (coupling.size() > 0) std::fill_n(coupling.data() + begin, count, CouplingSums{});
            for (ZeroArray<double>* field : {&depth, &u, &v, &solid_fraction, &structured, &mass, &pores})
                std::fill_n(field->data() + begin, count, 0.0);
        }
    });
}

void SolidNodes::find_tiles(const ParticleSet& particles, const CellOrder& order, const NodeGrid& on,
                            ThreadPool& pool) {
    std::vector<std::vector<std::int64_t>> by_row(static_cast<std::size_t>(order.rows()));
    const NodeScale scale = on.scale();
    const auto tile_x = [&, before = grid.before_x()](std::int64_t node) {
        return (std::clamp<std::int64_t>(node, 0, on.stride() - 1) + before) / k_tile;
    };
    const auto tile_y = [&, before = grid.before_y()](std::int64_t node) {
        return (std::clamp<std::int64_t>(node, 0, on.padded_rows() - 1) + before) / k_tile;
    };
    pool.for_each(by_row.size(), [&](std::size_t row) {
        const auto r = static_cast<std::int64_t>(row);
        const ParticleRun run = order.whole_rows(r, r);
        std::vector<std::int64_t>& found = by_row[row];
        for (std::size_t p = run.begin; p < run.end; ++p) {
            const std::int64_t i = CubicSpline::first(particles[Field::x][p] * scale.inverse_dx - 0.5) + scale.origin_x,
                               j = CubicSpline::first(particles[Field::y][p] * scale.inverse_dx - 0.5) + scale.origin_y;
            for (std::int64_t b = tile_y(j); b <= tile_y(j + 3); ++b) {
                for (std::int64_t a = tile_x(i); a <= tile_x(i + 3); ++a) {
                    const std::int64_t touched = b * grid.tiles_x() + a;
                    if (std::find(found.rbegin(), found.rend(), touched) == found.rend()) found.push_back(touched);
                }
            }
        }
    });
    tiles.clear();
    for (const std::vector<std::int64_t>& found : by_row) tiles.insert(tiles.end(), found.begin(), found.end());
    make_ascending(tiles);
    if (!on.is_on_demand()) return;
    for (const std::int64_t tile : tiles) {
        const NodeRange range(tile, grid, on);
        on.cover({range.i0 - k_round, range.i1 + k_round, range.j0 - k_round, range.j1 + k_round});
    }
}

bool has_own_tiles(const SolidNodes& nodes) {
    return are_tiles_of(nodes.grid, nodes.tiles);
}

}  // namespace frana::structured
