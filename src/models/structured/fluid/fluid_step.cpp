// SPDX-License-Identifier: Apache-2.0
#include "models/structured/fluid/fluid_step.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "models/finite_volume/step.h"
#include "models/structured/fluid/fluid_resistance.h"
#include "models/structured/fluid/rain.h"

namespace frana::structured {
namespace {

template <class Task>
void for_tiles(const FluidState& state, ThreadPool& pool, const Task& task) {
    const finite_volume::State& now = state.now;
    pool.for_each(now.wet.size(), [&](std::size_t t) { task(t, NodeRange(now.wet[t], now.tiles, now.nodes)); });
}

// What flowed into cells without terrain has left.
void empty_gaps(FluidState& state, const finite_volume::Laws& sweeps) {
    finite_volume::State& now = state.now;
    double left = 0;
    for (const std::int64_t tile : now.wet)
        NodeRange(tile, now.tiles, now.nodes)
            .for_each(now.nodes.stride(), [&](std::size_t cell, std::int64_t, std::int64_t) {
                if (!now.nodes.is_gap(cell)) return;
                left += std::exchange(now.depth[cell], 0) * now.cell_area();
                now.qx[cell] = now.qy[cell] = 0;
            });
    now.volume_left += left;
    state.volume_into_gaps += left;
    finite_volume::settle(now, sweeps, now.wet);
}

}  // namespace

FluidState::FluidState(NodeGrid& nodes, const FluidLaws& laws) : now(nodes) {
    for (ZeroArray<double>* force : {&force_x, &force_y})
        if (has_viscosity(laws)) *force = ZeroArray<double>(nodes.size());
    if (laws.manning_in_sweeps) now.bed_states = ZeroArray<BedState>(nodes.size());
    find_open_ground(*this, laws);
}

finite_volume::Laws sweeps_of(const FluidLaws& laws, const NodeGrid& nodes, const double* solid_depth) {
    finite_volume::Laws sweeps;
    sweeps.values.cell_size = nodes.cell_size();
    sweeps.values.gravity = laws.gravity;
    sweeps.values.dry = laws.dry;
    sweeps.values.weight_of_bed = true;  // that of the solids: what floats is not pushed uphill
    sweeps.cfl = laws.cfl;
    sweeps.along_bed = sweeps.curved = laws.steep;
    sweeps.wall = laws.wall;
    sweeps.gap_is_wall = !laws.gaps_are_open;
    sweeps.flies = false;
    if (!laws.manning_in_sweeps) return sweeps;
    sweeps.films = sweeps.friction.summed = true;
    sweeps.friction.sweeps.emplace_back([law = ManningFriction{laws.gravity, laws.manning}, solid_depth](
                                            const NodeRange& range, const NodeGrid& grid, BedState* states) {
        range.for_each(grid.stride(), [&](std::size_t cell, std::int64_t, std::int64_t) {
            const bool has_solids = solid_depth != nullptr && solid_depth[cell] > 0;
            if (grid.mass(cell) > 0 && !has_solids) law(states[cell], cell);
        });
    });
    return sweeps;
}

void set_ground(FluidState& state, const FluidLaws& laws) {
    finite_volume::renew_ground(state.now, sweeps_of(laws, state.now.nodes));
    find_open_ground(state, laws);
}

double receive(std::span<const FluidSource> sources, FluidState& state, const FluidLaws& laws) {
    const NodeGrid& nodes = state.now.nodes;
    const finite_volume::Laws sweeps = sweeps_of(laws, nodes);
    std::vector<std::int64_t> tiles;
    double refused = 0;
    for (const FluidSource& s : sources) {
        const auto node = static_cast<std::int64_t>(s.cell);
        const std::int64_t i = node % nodes.stride(), j = node / nodes.stride();
        nodes.cover({i, i + 1, j, j + 1});
        if (nodes.is_ghost(i, j) || nodes.is_gap(s.cell) || nodes.is_wall(s.cell)) {
            refused += s.depth;
        } else if (s.depth > 0) {
            tiles.push_back(
                finite_volume::add_to_cell(state.now, sweeps, i, j, s.depth, {s.qx / s.depth, s.qy / s.depth}, {}));
        }
    }
    finite_volume::settle(state.now, sweeps, std::move(tiles));
    return refused;
}

double stable_step(FluidState& state, const FluidLaws& laws, const SolidsOnGrid& solid, ThreadPool& pool) {
    finite_volume::State& now = state.now;
    if (now.wet.empty()) return std::numeric_limits<double>::infinity();
    const finite_volume::Laws sweeps = sweeps_of(laws, now.nodes);
    // Solids have pushed it since the sweeps took the speed of its waves.
    if (!has_viscosity(laws) && solid.depth == nullptr) return finite_volume::stable_step(now, sweeps);
    std::vector<double> fastest(now.wet.size()), thickest(now.wet.size());
    const bool viscous = has_viscosity(laws);
    for_tiles(state, pool, [&](std::size_t t, const NodeRange& range) {
        range.for_each(now.nodes.stride(), [&](std::size_t cell, std::int64_t, std::int64_t) {
            const double h = now.depth[cell];
            if (!(h > laws.dry)) return;
            const Point u = state.velocity(cell);
            const double wave = std::sqrt(laws.gravity * h) / now.root[cell];
            const double speed = std::max(std::abs(u.x), std::abs(u.y)) + wave;
            fastest[t] = std::max(fastest[t], std::isnan(speed) ? std::numeric_limits<double>::infinity() : speed);
            if (!viscous) return;
            const double solids = solid.solid_fraction != nullptr ? solid.solid_fraction[cell] : 0;
            const double solid_depth = solid.depth != nullptr ? solid.depth[cell] : 0;
            const double free_fraction = std::max(h / (h + solid_depth), k_least_free_fraction);
            const double enhanced = solid.u != nullptr ? laws.mobility / free_fraction : 0;
            thickest[t] = std::max(thickest[t], kinematic_viscosity(laws, solids) * std::max(1.0, enhanced));
        });
    });
    now.wave = now.diffusivity = 0;
    for (const double f : fastest) now.wave = std::max(now.wave, f);
    for (const double v : thickest) now.diffusivity = std::max(now.diffusivity, 2.5 * v);
    return finite_volume::stable_step(now, sweeps);
}

FluidReport advance(FluidState& state, const FluidLaws& laws, const SolidsOnGrid& solid, double dt, ThreadPool& pool) {
    constexpr double k_least_fraction = 1e-6;  // least stable fraction of a step: below it the run would not end
    FluidReport report;
    finite_volume::State& now = state.now;
    const finite_volume::Laws sweeps = sweeps_of(laws, now.nodes, solid.depth);
    now.lying = solid.depth;
    for (const std::int64_t tile : std::exchange(state.resisted, {}))
        NodeRange(tile, now.tiles, now.nodes)
            .for_each(now.nodes.stride(), [&](std::size_t cell, std::int64_t, std::int64_t) {
                state.resistance_x[cell] = state.resistance_y[cell] = 0;
            });
    double left = dt;
    while (left > 0 && report.non_finite == 0 && !now.wet.empty()) {
        const double stable = stable_step(state, laws, solid, pool);
        if (!(stable > k_least_fraction * dt)) {  // an infinite or undefined speed, or almost one
            ++report.non_finite;
            break;
        }
        double step = std::min(left, stable);
        if (step < left && left < 2 * step) step = 0.5 * left;  // two equal steps, not a full and a tiny one
        const finite_volume::StepReport done = finite_volume::step(now, sweeps, step, nullptr, pool);
        if (done.no_data > 0) empty_gaps(state, sweeps);
        if (has_viscosity(laws))
            for_tiles(state, pool, [&](std::size_t, const NodeRange& range) { shear(range, laws, solid, state); });
        if (has_resistance(laws))
            for_tiles(state, pool,
                      [&](std::size_t, const NodeRange& range) { resist(range, laws, solid, step, state); });
        if (state.resistance_x.size() > 0) {
            state.resisted.insert(state.resisted.end(), now.wet.begin(), now.wet.end());
            make_ascending(state.resisted);
        }
        for (std::size_t n = 0; n < now.n_strips; ++n) {
            const finite_volume::Region& r = now.strips[n].region;
            report.updated_cells += (r.i1 - r.i0) * (r.j1 - r.j0);
        }
        report.non_finite += done.not_finite;
        left = step < left ? left - step : 0;
        ++report.steps;
    }
    return report;
}

double fluid_volume(const FluidState& state) {
    double sum = 0;
    for (const std::int64_t tile : state.now.wet) sum += state.now.records[static_cast<std::size_t>(tile)].depth;
    return sum * state.now.cell_area();
}

}  // namespace frana::structured
