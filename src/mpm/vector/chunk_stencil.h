// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/quad.h"
#include "mpm/node_grid.h"

namespace frana {
namespace {

/// What a grid's kernels ask of it again and again.
struct GridScale {
    double dx, inverse_dx;
    std::int64_t stride;
    explicit GridScale(const NodeGrid& nodes)
        : dx(nodes.cell_size()), inverse_dx(1 / nodes.cell_size()), stride(nodes.stride()) {}
};

/// Position on the quadratic splines of four particles in one direction (QuadraticSplineShape).
struct ChunkAxis {
    Quad base;      ///< the middle node of three; counts from the first node of the terrain
    Quad offset;    ///< of the particle from it, in node spacings, -1/2 to 1/2

    FRANA_INLINE ChunkAxis(Quad position, const GridScale& grid) {
        using Int [[gnu::vector_size(16)]] = int;
        const Quad s = position * grid.inverse_dx - 0.5;
        const Quad up = s + 0.5;  // never negative inside the grid, so that cutting off is rounding down
        base = Quad(__builtin_convertvector(__builtin_convertvector(up.v, Int), Quad::Lanes));
        offset = s - base;
    }
    FRANA_INLINE void weights(Quad (&w)[3]) const {
        const Quad before = 0.5 - offset, after = 0.5 + offset;
        w[0] = 0.5 * before * before;
        w[1] = 0.75 - offset * offset;
        w[2] = 0.5 * after * after;
    }
    FRANA_INLINE void slopes(double inverse_dx, Quad (&g)[3]) const {
        g[0] = (offset - 0.5) * inverse_dx;
        g[1] = -2 * offset * inverse_dx;
        g[2] = (offset + 0.5) * inverse_dx;
    }
    /// From the particle to the first of the three nodes [m].
    [[nodiscard]] FRANA_INLINE Quad to_first(Quad position, double dx) const { return (base - 0.5) * dx - position; }
    /// Number of the first of the three nodes, ghosts counted.
    [[nodiscard]] FRANA_INLINE Quad first() const { return base + static_cast<double>(k_ghost - 1); }
};

/// Indices of the south-western nodes of four particles.
FRANA_INLINE void first_nodes(const ChunkAxis& x, const ChunkAxis& y, std::int64_t stride, std::size_t (&first)[4]) {
    const Quad index = y.first() * static_cast<double>(stride) + x.first();  // exact under 2^53
    for (int k = 0; k < 4; ++k) first[k] = static_cast<std::size_t>(static_cast<std::int64_t>(index[k]));
}

}  // namespace
}  // namespace frana
