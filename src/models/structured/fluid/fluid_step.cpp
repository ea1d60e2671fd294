// SPDX-License-Identifier: Apache-2.0
#include "models/structured/fluid/fluid_step.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "models/structured/fluid/fluid_resistance.h"
#include "models/structured/fluid/fluid_stage.h"

namespace frana::structured {
namespace {

template <class Task>
void for_tiles(const FluidState& state, const NodeGrid& nodes, ThreadPool& pool, const Task& task) {
    pool.for_each(state.tiles.size(), [&](std::size_t t) { task(t, NodeRange(state.tiles[t], state.grid, nodes)); });
}

void copy_tile(const NodeRange& range, const NodeGrid& nodes, const FluidFields& from, FluidFields& to) {
    range.for_each(nodes.stride(), [&](std::size_t cell, std::int64_t, std::int64_t) {
        to.depth[cell] = from.depth[cell];
        to.qx[cell] = from.qx[cell];
        to.qy[cell] = from.qy[cell];
    });
}

// Copies walls and gaps from the nodes of a tile, and the slopes of its bed, unless it has them.
void need_ground(FluidState& state, const NodeGrid& nodes, const FluidLaws& laws, std::int64_t tile) {
    std::uint8_t& has = state.has_ground[static_cast<std::size_t>(tile)];
    if (has != 0) return;
    has = 1;
    const NodeRange range(tile, state.grid, nodes);
    nodes.cover({range.i0 - 1, range.i1 + 1, range.j0 - 1, range.j1 + 1});
    const double half_inverse = 0.5 / nodes.cell_size();
    const std::int64_t last_column = nodes.stride() - 1, last_row = nodes.padded_rows() - 1;
    const auto up = static_cast<std::size_t>(nodes.stride());
    range.for_each(nodes.stride(), [&](std::size_t cell, std::int64_t i, std::int64_t j) {
        const bool outside = i < k_ghost || j < k_ghost || i > last_column - k_ghost || j > last_row - k_ghost;
        const bool gap = nodes.is_gap(cell), wall = nodes.is_wall(cell) || (gap && !laws.gaps_are_open);
        state.cell_kind[cell] = outside ? (laws.wall ? k_wall_cell : k_open_cell)
                                : wall  ? k_wall_cell
                                : gap   ? k_gap_cell
                                        : k_fluid_cell;
        if (!laws.steep) return;
        if (i == 0 || j == 0 || i == last_column || j == last_row) {
            state.slope_factor[cell] = 1;  // has no neighbour on one side, and never fluid
            return;
        }
        const double sx = (nodes.bed[cell + 1] - nodes.bed[cell - 1]) * half_inverse;
        const double sy = (nodes.bed[cell + up] - nodes.bed[cell - up]) * half_inverse;
        state.slope_factor[cell] = 1 / (1 + sx * sx + sy * sy);
    });
}

// Calls visit for a tile and those of its eight neighbours that exist.
template <class Visit>
void for_round(std::int64_t tile, const TileGrid& grid, const Visit& visit) {
    const std::int64_t tiles_x = grid.tiles_x(), i = tile % tiles_x, j = tile / tiles_x;
    for (std::int64_t b = std::max<std::int64_t>(j - 1, 0); b <= std::min(j + 1, grid.tiles_y() - 1); ++b)
        for (std::int64_t a = std::max<std::int64_t>(i - 1, 0); a <= std::min(i + 1, tiles_x - 1); ++a)
            visit(b * tiles_x + a);
}

// Lists the tiles that contain moving fluid and their neighbours, which a step may wet. A tile that is no longer listed
// keeps its fluid, which does not move; the buffers must contain it too, because neighbours read them.
void activate_tiles(FluidState& state, const NodeGrid& nodes, const FluidLaws& laws) {
    std::vector<std::int64_t> active;
    for (const std::int64_t tile : state.tiles) {
        if (state.wet[static_cast<std::size_t>(tile)] == 0) continue;
        for_round(tile, state.grid, [&](std::int64_t near) { active.push_back(near); });
    }
    make_ascending(active);
    // Tiles stay listed as touched once they were active: they may contain fluid below the dry depth.
    std::vector<std::int64_t> touched;
    std::set_union(state.touched.begin(), state.touched.end(), active.begin(), active.end(),
                   std::back_inserter(touched));
    for (const std::int64_t tile : state.tiles) {
        if (std::binary_search(active.begin(), active.end(), tile)) continue;
        const NodeRange range(tile, state.grid, nodes);
        copy_tile(range, nodes, state.now, state.stage);
        copy_tile(range, nodes, state.now, state.next);
    }
    state.tiles = std::move(active);
    // A tile reads two cells of its neighbours.
    for (const std::int64_t tile : state.tiles)
        for_round(tile, state.grid, [&](std::int64_t near) { need_ground(state, nodes, laws, near); });
    state.touched = std::move(touched);
}

TileReport run_stage(FluidState& state, const NodeGrid& nodes, const FluidLaws& laws, const SolidsOnGrid& solid,
                     double dt, double fraction, const FluidFields& from, FluidFields& to, bool last,
                     ThreadPool& pool) {
    std::vector<TileReport> reports(state.tiles.size());
    for_tiles(state, nodes, pool, [&](std::size_t t, const NodeRange& range) {
        reports[t] = fluid_stage(range, nodes, laws, state, solid.depth, dt, fraction, from, state.now, to);
        if (last) state.wet[static_cast<std::size_t>(state.tiles[t])] = reports[t].wet_cells > 0;
    });
    TileReport sum;
    for (const TileReport& r : reports) {
        sum.lowest = std::min(sum.lowest, r.lowest);
        sum.left += r.left;
        sum.into_gaps += r.into_gaps;
        sum.non_finite += r.non_finite;
        sum.wet_cells += r.wet_cells;
    }
    return sum;
}

// Adds the velocity in cells with solids, times `sign`, to the change by stress and resistance: -1 before, 1 after.
void add_resistance(FluidState& state, const NodeGrid& nodes, const FluidLaws& laws, const SolidsOnGrid& solid,
                    double sign, ThreadPool& pool) {
    for_tiles(state, nodes, pool, [&](std::size_t, const NodeRange& range) {
        range.for_each(nodes.stride(), [&](std::size_t cell, std::int64_t, std::int64_t) {
            const double h = state.next.depth[cell];
            if (!(solid.depth[cell] > 0 && h >= laws.dry)) return;
            state.resistance_x[cell] += sign * state.next.qx[cell] / h;
            state.resistance_y[cell] += sign * state.next.qy[cell] / h;
        });
    });
}

void clear_resistance(FluidState& state, const NodeGrid& nodes, ThreadPool& pool) {
    if (state.resistance_x.size() == 0) return;
    pool.for_each(state.touched.size(), [&](std::size_t t) {
        const NodeRange range(state.touched[t], state.grid, nodes);
        range.for_each(nodes.stride(), [&](std::size_t cell, std::int64_t, std::int64_t) {
            state.resistance_x[cell] = state.resistance_y[cell] = 0;
        });
    });
}

// One step of Heun's method (or Euler's), or nothing when a depth would become negative.
bool try_step(FluidState& state, const NodeGrid& nodes, const FluidLaws& laws, const SolidsOnGrid& solid, double dt,
              FluidReport& report, ThreadPool& pool) {
    // Pressure and terrain: U1 = U + dt R(U);  U2 = (U + U1 + dt R(U1)) / 2.
    const bool heun = laws.second_order;
    FluidFields& first = heun ? state.stage : state.next;
    TileReport done = run_stage(state, nodes, laws, solid, dt, 1, state.now, first, !heun, pool);
    if (done.lowest < 0) return false;
    double left = done.left, into_gaps = done.into_gaps;
    if (heun) {
        done = run_stage(state, nodes, laws, solid, dt, 0.5, state.stage, state.next, true, pool);
        if (done.lowest < 0) return false;
        left = 0.5 * (left + done.left);
        into_gaps = 0.5 * (into_gaps + done.into_gaps);
    }
    // In-plane stress, then bed resistance.
    const bool coupled = state.resistance_x.size() > 0 && solid.depth != nullptr && has_resistance(laws);
    if (coupled) add_resistance(state, nodes, laws, solid, -1, pool);
    if (has_viscosity(laws)) {
        for_tiles(state, nodes, pool, [&](std::size_t, const NodeRange& range) {
            shear(range, nodes, laws, state, solid, dt, state.next, state.stage);
        });
        std::swap(state.next.qx, state.stage.qx);
        std::swap(state.next.qy, state.stage.qy);
    }
    if (has_resistance(laws)) {
        for_tiles(state, nodes, pool, [&](std::size_t, const NodeRange& range) {
            resist(range, nodes, laws, state, solid, dt, state.next);
        });
    }
    if (coupled) add_resistance(state, nodes, laws, solid, 1, pool);
    std::swap(state.now, state.next);
    state.volume_left += dt * left;
    state.volume_into_gaps += dt * into_gaps;
    report.non_finite += done.non_finite;
    report.wet_cells = done.wet_cells;
    report.updated_cells += static_cast<std::int64_t>(state.tiles.size()) * k_tile * k_tile;
    return true;
}

}  // namespace

FluidState::FluidState(const NodeGrid& nodes, const FluidLaws& laws)
    : now(nodes.bed.size()),
      grid(tiles_on(nodes)),
      stage(nodes.bed.size()),
      next(nodes.bed.size()),
      wet(static_cast<std::size_t>(grid.tiles_x() * grid.tiles_y())),
      cell_kind(nodes.bed.size()),
      slope_factor(laws.steep ? nodes.bed.size() : 0),
      has_ground(wet.size()) {}

void set_ground(FluidState& state, const NodeGrid& nodes, const FluidLaws& laws) {
    state.has_ground = ZeroArray<std::uint8_t>(state.wet.size());
    for (const std::vector<std::int64_t>* list : {&state.touched, &state.tiles})
        for (const std::int64_t tile : *list) need_ground(state, nodes, laws, tile);
}

double receive(std::span<const FluidSource> sources, FluidState& state, const NodeGrid& nodes, const FluidLaws& laws) {
    const std::int64_t before_x = state.grid.before_x(), before_y = state.grid.before_y();
    double refused = 0;
    for (const FluidSource& s : sources) {
        const auto node = static_cast<std::int64_t>(s.cell);
        const std::int64_t tile = (node / nodes.stride() + before_y) / k_tile * state.grid.tiles_x() +
                                  (node % nodes.stride() + before_x) / k_tile;
        need_ground(state, nodes, laws, tile);
        if (state.cell_kind[s.cell] != k_fluid_cell) {
            refused += s.depth;
            continue;
        }
        state.now.depth[s.cell] += s.depth;
        state.now.qx[s.cell] += s.qx;
        state.now.qy[s.cell] += s.qy;
        for (FluidFields* buffer : {&state.stage, &state.next}) {
            buffer->depth[s.cell] = state.now.depth[s.cell];
            buffer->qx[s.cell] = state.now.qx[s.cell];
            buffer->qy[s.cell] = state.now.qy[s.cell];
        }
        if (state.now.depth[s.cell] >= laws.dry) state.wet[static_cast<std::size_t>(tile)] = 1;
        state.tiles.push_back(tile);
    }
    make_ascending(state.tiles);
    // Fluid below the dry depth is stored but never active.
    std::vector<std::int64_t> touched;
    std::set_union(state.touched.begin(), state.touched.end(), state.tiles.begin(), state.tiles.end(),
                   std::back_inserter(touched));
    state.touched = std::move(touched);
    return refused;
}

double stable_step(const FluidState& state, const NodeGrid& nodes, const FluidLaws& laws, const SolidsOnGrid& solid,
                   ThreadPool& pool) {
    std::vector<double> fastest(state.tiles.size()), thickest(state.tiles.size());
    const bool viscous = has_viscosity(laws);
    for_tiles(state, nodes, pool, [&](std::size_t t, const NodeRange& range) {
        range.for_each(nodes.stride(), [&](std::size_t cell, std::int64_t, std::int64_t) {
            const double h = state.now.depth[cell];
            if (h < laws.dry) return;
            const double speed = (std::abs(state.now.qx[cell]) + std::abs(state.now.qy[cell])) / h;
            fastest[t] = std::max(fastest[t], speed + 2 * std::sqrt(laws.gravity * h));
            if (!viscous) return;
            const double solids = solid.solid_fraction != nullptr ? solid.solid_fraction[cell] : 0;
            const double solid_depth = solid.depth != nullptr ? solid.depth[cell] : 0;
            const double free_fraction = std::max(h / (h + solid_depth), k_least_free_fraction);
            const double enhanced = solid.u != nullptr ? laws.mobility / free_fraction : 0;
            thickest[t] = std::max(thickest[t], kinematic_viscosity(laws, solids) * std::max(1.0, enhanced));
        });
    });
    double fast = 0, thick = 0;
    for (const double f : fastest) fast = std::max(fast, f);
    for (const double v : thickest) thick = std::max(thick, v);
    const double dx = nodes.cell_size();
    double dt = std::numeric_limits<double>::infinity();
    if (fast > 0) dt = laws.cfl * dx / fast;
    if (thick > 0) dt = std::min(dt, 0.1 * dx * dx / thick);
    return dt;
}

FluidReport advance(FluidState& state, const NodeGrid& nodes, const FluidLaws& laws, const SolidsOnGrid& solid,
                    double dt, ThreadPool& pool) {
    constexpr double k_least_fraction = 1e-6;  // least stable fraction of a step: below it the run would not end
    constexpr int k_most_retries = 40;         // of one step, each halving the length
    FluidReport report;
    clear_resistance(state, nodes, pool);
    double left = dt;
    while (left > 0 && report.non_finite == 0) {
        activate_tiles(state, nodes, laws);
        if (state.tiles.empty()) break;
        const double stable = stable_step(state, nodes, laws, solid, pool);
        if (!(stable > k_least_fraction * dt)) {  // an infinite or undefined speed, or almost one
            ++report.non_finite;
            break;
        }
        double step = std::min(left, stable);
        if (step < left && left < 2 * step) step = 0.5 * left;  // two equal steps, not a full and a tiny one
        for (int tries = 0; !try_step(state, nodes, laws, solid, step, report, pool); ++tries) {
            if (tries == k_most_retries) {
                ++report.non_finite;
                return report;
            }
            step *= 0.5;
            ++report.retries;
        }
        left = step < left ? left - step : 0;
        ++report.steps;
    }
    return report;
}

double fluid_volume(const FluidState& state, const NodeGrid& nodes, ThreadPool& pool) {
    std::vector<std::int64_t> tiles;
    std::set_union(state.touched.begin(), state.touched.end(), state.tiles.begin(), state.tiles.end(),
                   std::back_inserter(tiles));
    std::vector<double> sums(tiles.size());
    pool.for_each(tiles.size(), [&](std::size_t t) {
        const NodeRange range(tiles[t], state.grid, nodes);
        range.for_each(nodes.stride(),
                       [&](std::size_t cell, std::int64_t, std::int64_t) { sums[t] += state.now.depth[cell]; });
    });
    double sum = 0;
    for (const double s : sums) sum += s;
    return sum * nodes.cell_size() * nodes.cell_size();
}

}  // namespace frana::structured
