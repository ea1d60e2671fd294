// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mpm/update_nodes.h"
#include "mpm/vector/levels.h"

namespace frana {
namespace {

/// The input of four nodes of a row, none in the outermost ring.
template <class Slope>
FRANA_INLINE NodeInput<Quad> inputs_of(const NodeGrid& nodes, std::size_t i) {
    const double* const record = &nodes.records[i].forces.px;
    const double* const level = &nodes.levels[i].depth;
    const double* const z = nodes.bed.data() + i;
    const std::int64_t stride = nodes.stride();
    Quad first[4], second[4], levels[4];
    load_rows(record, k_record_doubles, first);
    load_rows(record + 4, k_record_doubles, second);
    load_rows(level, sizeof(NodeLevel) / sizeof(double), levels);
    const double half_inverse_dx = 0.5 / nodes.cell_size();
    NodeBed<Quad> bed{(Quad::load(z + 1) - Quad::load(z - 1)) * half_inverse_dx,
                      (Quad::load(z + stride) - Quad::load(z - stride)) * half_inverse_dx,
                      {}};
    if constexpr (Slope::curved) bed.curvature = bed_curvature<Quad>(z, stride, nodes.cell_size());
    const NodeLevel* const l = &nodes.levels[i];
    const Quad share(l[0].share, l[1].share, l[2].share, l[3].share);
    return {first[0],  first[1],  first[2],  first[3], second[0],     second[1],     second[2],
            second[3], levels[2], levels[3], share,    1 - levels[2], Quad::load(z), bed};
}

/// update_nodes, four nodes of a row at a time, for tiles of whole fours inside the outermost ring and, with walls, the
/// ghosts (four_at_a_time), with reference levels.
template <class Slope, class Friction>
NodeReport vector_update_nodes(const NodeRange& range, const NodeUpdate& k, const Friction& friction, double time,
                               NodeGrid& nodes, Maxima& maxima) {
    NodeSweep<Quad, Slope, Friction> sweep{k, friction, nodes, maxima, time};
    const bool keeps_rest = friction.keeps_rest();
    const std::uint8_t* const solid = nodes.solid();
    for (std::int64_t j = range.j0; j < range.j1; ++j) {
        for (std::int64_t column = range.i0; column < range.i1; column += 4) {
            const auto i = static_cast<std::size_t>(j * nodes.stride() + column);
            const NodeRecord* const r = nodes.records.data() + i;
            if (!(r[0].forces.mass > 0) && !(r[1].forces.mass > 0) && !(r[2].forces.mass > 0) &&
                !(r[3].forces.mass > 0))
                continue;
            const NodeInput<Quad> in = inputs_of<Slope>(nodes, i);
            Quad stopped = keeps_rest ? in.held : Quad(0.0);
            for (std::size_t l = 0; solid != nullptr && l < 4; ++l)
                if (solid[i + l] != 0) stopped.v[static_cast<int>(l)] = 1;
            const Quad::Mask held = (stopped > 0.0) | (stopped < 0.0);
            sweep(i, 4, in.mass > 0.0, held, false, in);
        }
    }
    return sweep.report();
}

}  // namespace
}  // namespace frana
