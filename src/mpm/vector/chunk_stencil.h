// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/quad.h"
#include "mpm/node_grid.h"

namespace frana {
namespace {

/// Position on the quadratic splines of four particles in one direction (QuadraticSplineShape).
struct ChunkAxis {
    Quad base;    ///< the middle node of three, relative to that of the origin
    Quad offset;  ///< of the particle from it, in node spacings, -1/2 to 1/2

    FRANA_INLINE ChunkAxis(Quad position, const NodeScale& grid) {
        const Quad s = position * grid.inverse_dx - 0.5;
        base = floor(s + 0.5);  // cppcheck-suppress useInitializationList; both need s
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
    /// Padded index of the first of the three nodes.
    /// @param origin that of the origin's node
    [[nodiscard]] FRANA_INLINE Quad first(std::int64_t origin) const { return base + static_cast<double>(origin - 1); }
};

/// Indices of the south-western nodes of four particles.
FRANA_INLINE void first_nodes(const ChunkAxis& x, const ChunkAxis& y, const NodeScale& grid, std::size_t (&first)[4]) {
    // Exact below 2^53.
    const Quad index = y.base * static_cast<double>(grid.stride) + (x.base + static_cast<double>(grid.index(-1, -1)));
    for (int k = 0; k < 4; ++k) first[k] = static_cast<std::size_t>(static_cast<std::int64_t>(index[k]));
}

}  // namespace
}  // namespace frana
