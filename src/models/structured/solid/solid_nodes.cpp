// SPDX-License-Identifier: Apache-2.0
#include "models/structured/solid/solid_nodes.h"

#include <algorithm>

namespace frana::structured {

SolidNodes::SolidNodes(const NodeGrid& grid, bool gaps_are_walls, bool coupled)
    : sums(static_cast<std::size_t>(grid.stride() * grid.padded_rows())),
      push(sums.size()),
      depth(sums.size()),
      u(sums.size()),
      v(sums.size()),
      solid_fraction(sums.size()),
      structured(sums.size()),
      active_(sums.size(), 0),
      whole_(sums.size(), 0) {
    if (coupled) coupling = ZeroArray<CouplingSums>(sums.size());
    for (std::int64_t j = 0; j < grid.rows(); ++j) {
        for (std::int64_t i = 0; i < grid.columns(); ++i) {
            const std::size_t node = grid.index(i, j);
            active_[node] = !grid.is_wall(node) && !(gaps_are_walls && grid.is_gap(node));
        }
    }
    for (std::int64_t j = 0; j + 3 < grid.padded_rows(); ++j) {
        for (std::int64_t i = 0; i + 3 < grid.stride(); ++i) {
            const auto first = static_cast<std::size_t>(j * grid.stride() + i);
            bool all = true;
            for (std::int64_t b = 0; b < 4; ++b) {
                const std::uint8_t* row = active_.data() + first + static_cast<std::size_t>(b * grid.stride());
                all = all && std::all_of(row, row + 4, [](std::uint8_t a) { return a != 0; });
            }
            whole_[first] = all;
        }
    }
}

void SolidNodes::clear(const NodeBox& where, std::int64_t stride, ThreadPool& pool) {
    pool.for_each(static_cast<std::size_t>(where.j1 - where.j0), [&](std::size_t row) {
        const auto begin = static_cast<std::size_t>((where.j0 + static_cast<std::int64_t>(row)) * stride + where.i0);
        const auto count = static_cast<std::size_t>(where.i1 - where.i0);
        std::fill_n(sums.data() + begin, count, SolidSums{});
        if (coupling.size() > 0) std::fill_n(coupling.data() + begin, count, CouplingSums{});
        for (ZeroArray<double>* field : {&depth, &u, &v, &solid_fraction, &structured})
            std::fill_n(field->data() + begin, count, 0.0);
    });
}

}  // namespace frana::structured
