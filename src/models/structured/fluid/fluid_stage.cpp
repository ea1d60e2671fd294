// SPDX-License-Identifier: Apache-2.0
#include "models/structured/fluid/fluid_stage.h"

#include <limits>

#include "models/structured/fluid/fluid_step.h"
#include "models/structured/fluid/fluid_sweep.h"

namespace frana::structured {
namespace {

// A tile's window on the padded arrays, and the direction of the sweep.
struct Window {
    std::int64_t i0, j0;         // padded, of the tile's first cell
    std::int64_t columns, rows;  // of the padded arrays
    bool along_x;

    // Padded index of a cell by its place along the sweep (halo included) and across it; outside the arrays, where
    // there is no fluid, that of the nearest cell.
    [[nodiscard]] std::size_t index(int c, int a) const noexcept {
        const std::int64_t i = std::clamp<std::int64_t>(i0 + (along_x ? c - k_halo : a), 0, columns - 1);
        const std::int64_t j = std::clamp<std::int64_t>(j0 + (along_x ? a : c - k_halo), 0, rows - 1);
        return static_cast<std::size_t>(j * columns + i);
    }
};

void load(const Window& window, const NodeGrid& nodes, const FluidLaws& laws, const FluidState& state,
          const double* solid_depth, const FluidFields& from, SweepCells& cells) {
    const double* along = window.along_x ? from.qx.data() : from.qy.data();
    const double* across = window.along_x ? from.qy.data() : from.qx.data();
    const auto fill = [&](int c, int a, std::size_t cell) {
        const double h = from.depth[cell];
        const double inverse = h >= laws.dry ? 1 / h : 0;
        cells.depth[c][a] = h;
        cells.along[c][a] = along[cell] * inverse;
        cells.across[c][a] = across[cell] * inverse;
        cells.bed[c][a] = nodes.bed[cell] + (solid_depth != nullptr ? solid_depth[cell] : 0);
        cells.factor[c][a] = state.slope_factor.size() == 0 ? 1 : state.slope_factor[cell];
        cells.kind[c][a] = state.cell_kind[cell];
    };
    // Rows of the arrays are along x: read in that order.
    if (window.along_x) {
        for (int a = 0; a < k_side; ++a)
            for (int c = 0; c < k_length; ++c) fill(c, a, window.index(c, a));
    } else {
        for (int c = 0; c < k_length; ++c)
            for (int a = 0; a < k_side; ++a) fill(c, a, window.index(c, a));
    }
}

bool is_plain(const SweepCells& cells) {
    int sum = 0;
    for (const auto& row : cells.kind)
        for (const std::uint8_t kind : row) sum |= kind;
    return sum == k_fluid_cell;
}

void sweep_tile(const SweepCells& cells, const FluidLaws& laws, SweepRates& rates) {
    const bool plain = is_plain(cells);
    if (laws.second_order) {
        plain ? sweep<true, true>(cells, laws.gravity, laws.dry, rates)
              : sweep<true, false>(cells, laws.gravity, laws.dry, rates);
    } else {
        plain ? sweep<false, true>(cells, laws.gravity, laws.dry, rates)
              : sweep<false, false>(cells, laws.gravity, laws.dry, rates);
    }
}

}  // namespace

TileReport fluid_stage(const NodeRange& range, const NodeGrid& nodes, const FluidLaws& laws, const FluidState& state,
                       const double* solid_depth, double dt, double fraction, const FluidFields& from,
                       const FluidFields& before, FluidFields& to) {
    // Tolerance for rounding in a cell that becomes empty; a more negative depth means that the step was too long.
    const double grain = 1e-12 * laws.dry;
    SweepCells cells;
    SweepRates x, y;
    // The first tile may begin outside the arrays: a window is as wide as a tile all the same, and ends where it ends.
    const std::int64_t i0 = range.i0 == 0 ? range.i1 - k_side : range.i0,
                       j0 = range.j0 == 0 ? range.j1 - k_side : range.j0;
    Window window{i0, j0, nodes.stride(), nodes.padded_rows(), true};
    load(window, nodes, laws, state, solid_depth, from, cells);
    sweep_tile(cells, laws, x);
    window.along_x = false;
    load(window, nodes, laws, state, solid_depth, from, cells);
    sweep_tile(cells, laws, y);

    TileReport report;
    report.left = nodes.cell_size() * (x.left + y.left);
    report.into_gaps = nodes.cell_size() * (x.into_gaps + y.into_gaps);
    const double ratio = dt / nodes.cell_size();
    range.for_each(nodes.stride(), [&](std::size_t cell, std::int64_t i, std::int64_t j) {
        if (state.cell_kind[cell] != k_fluid_cell) return;
        const auto a = static_cast<int>(i - i0), b = static_cast<int>(j - j0);
        double depth = from.depth[cell] + ratio * (x.depth[a][b] + y.depth[b][a]);
        double qx = from.qx[cell] + ratio * (x.along[a][b] + y.across[b][a]);
        double qy = from.qy[cell] + ratio * (x.across[a][b] + y.along[b][a]);
        if (!(std::isfinite(depth) && std::isfinite(qx) && std::isfinite(qy))) ++report.non_finite;
        report.lowest = std::min(report.lowest, depth < -grain ? depth : 0.0);
        depth = std::max(depth, 0.0);
        if (fraction < 1) {
            depth = fraction * depth + (1 - fraction) * before.depth[cell];
            qx = fraction * qx + (1 - fraction) * before.qx[cell];
            qy = fraction * qy + (1 - fraction) * before.qy[cell];
        }
        const bool wet = depth >= laws.dry;
        report.wet_cells += wet;
        to.depth[cell] = depth;
        to.qx[cell] = wet ? qx : 0;
        to.qy[cell] = wet ? qy : 0;
    });
    return report;
}

}  // namespace frana::structured
