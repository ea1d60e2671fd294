// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "core/quad.h"
#include "mpm/levels.h"

namespace frana {
namespace {

constexpr std::size_t k_record_doubles = sizeof(NodeRecord) / sizeof(double);

/// The same entries of four records (or levels) in a row.
FRANA_INLINE void load_rows(const double* from, std::size_t step, Quad (&to)[4]) {
    for (std::size_t l = 0; l < 4; ++l) to[l] = Quad::load(from + l * step);
    transpose(to[0], to[1], to[2], to[3]);
}

/// mean_levels, four nodes of a row at a time, for tiles of whole fours.
void vector_mean_levels(const NodeRange& range, NodeGrid& nodes) {
    const double flat = k_flat * nodes.cell_size() * nodes.cell_size();
    const Quad zero(0.0);
    for (std::int64_t j = range.j0; j < range.j1; ++j) {
        for (std::int64_t column = range.i0; column < range.i1; column += 4) {
            const auto i = static_cast<std::size_t>(j * nodes.stride() + column);
            NodeSums* const sums = &nodes.records[i].sums;
            double* const to = &nodes.levels[i].depth;
            Quad first[4], second[4], rows[4] = {zero, zero, zero, zero}, held = zero;
            load_rows(&sums->mass, k_record_doubles, second);
            const Quad area = second[1];
            const Quad::Mask real = area > 0;
            if (any(real)) {
                load_rows(&sums->px, k_record_doubles, first);
                const auto mean = mean_level<Quad>(second[0], select(real, area, Quad(1.0)), second[2], first[2],
                                                   first[3], Quad::load(nodes.bed.data() + i), flat);
                rows[0] = select(real, mean.depth, zero);
                rows[1] = select(real, mean.level, zero);
                rows[2] = select(real, mean.ponding, zero);
                held = select(real, mean.held, zero);
                transpose(rows[0], rows[1], rows[2], rows[3]);
                for (std::size_t l = 0; l < 4; ++l) sums[l].bed_squares = sums[l].surface_squares = 0;
            }
            for (std::size_t l = 0; l < 4; ++l) {
                rows[l].store(to + l * sizeof(NodeLevel) / sizeof(double));
                nodes.levels[i + l].held = held[static_cast<int>(l)];
                nodes.levels[i + l].share = 0;
            }
        }
    }
}

/// node_references, four nodes of a row at a time, for tiles of whole fours with three nodes around them.
void vector_node_references(const NodeRange& range, NodeGrid& nodes) {
    // Areas of the tile and three nodes around it, side by side.
    constexpr std::int64_t k_reach = 3, k_row = k_tile + 2 * k_reach;
    std::array<double, k_row * k_row> areas;
    NodeForces* const forces = &nodes.records.data()->forces;
    const std::int64_t stride = nodes.stride();
    for (std::int64_t j = range.j0 - k_reach; j < range.j1 + k_reach; ++j) {
        const NodeForces* const row = forces + j * stride;
        double* const to = areas.data() + (j - range.j0 + k_reach) * k_row;
        for (std::int64_t i = range.i0 - k_reach; i < range.i1 + k_reach; ++i) to[i - range.i0 + k_reach] = row[i].area;
    }
    const std::uint8_t* const solid = nodes.solid();
    const double full = nodes.cell_size() * nodes.cell_size(), inverse = 1 / full;
    const Quad one(1.0);
    for (std::int64_t j = range.j0; j < range.j1; ++j) {
        for (std::int64_t column = range.i0; column < range.i1; column += 4) {
            const double* const area = areas.data() + (j - range.j0 + k_reach) * k_row + column - range.i0 + k_reach;
            const auto claim = [area](std::int64_t a, std::int64_t b)
                                   FRANA_INLINE_LAMBDA { return Quad::load(area + b * k_row + a); };
            const Quad own = claim(0, 0);
            const Quad::Mask real = own > 0;
            if (!any(real)) continue;
            const std::size_t i = static_cast<std::size_t>(j * stride + column);
            const Quad near = mean_fraction<1, Quad>(claim, full);
            Quad crowding = one;
            if (any(near > 1)) crowding = crowding_of<Quad>(near, mean_fraction<3, Quad>(claim, full));
            Quad least = own;
            for (std::int64_t b = -1; b <= 1; ++b) least = min(least, min(claim(-1, b), min(claim(0, b), claim(1, b))));
            Quad support = one;
            if (any(real & (least * inverse < k_filled_fraction))) {
                Quad level[4];
                load_rows(&nodes.levels[i].depth, sizeof(NodeLevel) / sizeof(double), level);
                const double* const bed = nodes.bed.data() + i;
                support = least_filled<Quad>(
                    level[1], level[2], any(level[2] > 0),
                    [&](std::int64_t a, std::int64_t b) FRANA_INLINE_LAMBDA { return claim(a, b) * inverse; },
                    [&](std::int64_t a, std::int64_t b)
                        FRANA_INLINE_LAMBDA { return Quad::load(bed + b * stride + a); },
                    [&](std::int64_t a, std::int64_t b) FRANA_INLINE_LAMBDA {
                        const double* const z = bed + b * stride + a;
                        return half_rise<Quad>(Quad::load(z + 1) - Quad::load(z - 1),
                                               Quad::load(z + stride) - Quad::load(z - stride));
                    },
                    [&](std::int64_t a, std::int64_t b) FRANA_INLINE_LAMBDA {
                        Quad::Mask mask{};
                        if (solid == nullptr) return mask;
                        const std::uint8_t* const s = solid + static_cast<std::int64_t>(i) + b * stride + a;
                        for (int l = 0; l < 4; ++l) mask[l] = s[l] != 0 ? -1 : 0;
                        return mask;
                    });
                support = select(least * inverse >= k_filled_fraction, one, support);
            }
            for (int l = 0; l < 4; ++l) {
                if (real[l] == 0) continue;
                forces[i + static_cast<std::size_t>(l)].crowding = crowding[l];
                nodes.levels[i + static_cast<std::size_t>(l)].support = support[l];
            }
        }
    }
}

/// momenta_to_map, four nodes of a row at a time, for tiles of whole fours inside the outermost ring.
void vector_momenta_to_map(const NodeRange& range, NodeGrid& nodes) {
    const double half_inverse_dx = 0.5 / nodes.cell_size();
    const std::int64_t stride = nodes.stride();
    for (std::int64_t j = range.j0; j < range.j1; ++j) {
        for (std::int64_t column = range.i0; column < range.i1; column += 4) {
            const auto i = static_cast<std::size_t>(j * stride + column);
            NodeForces* const forces = &nodes.records[i].forces;
            const Quad mass(forces[0].mass, forces[1].mass, forces[2].mass, forces[3].mass);
            const Quad::Mask real = mass > 0;
            if (!any(real)) continue;
            const double* const z = nodes.bed.data() + i;
            const NodeLevel* const levels = nodes.levels.data() + i;
            const Quad follows = 1 - Quad(levels[0].ponding, levels[1].ponding, levels[2].ponding, levels[3].ponding);
            const Quad px(forces[0].px, forces[1].px, forces[2].px, forces[3].px),
                py(forces[0].py, forces[1].py, forces[2].py, forces[3].py);
            const auto frame =
                BedFrameOf<Quad>::of({follows * ((Quad::load(z + 1) - Quad::load(z - 1)) * half_inverse_dx),
                                      follows * ((Quad::load(z + stride) - Quad::load(z - stride)) * half_inverse_dx)});
            const auto momentum = frame.in_map(px, py);
            for (int l = 0; l < 4; ++l) {
                if (real[l] == 0) continue;
                forces[l].px = momentum.x[l];
                forces[l].py = momentum.y[l];
            }
        }
    }
}

}  // namespace
}  // namespace frana
