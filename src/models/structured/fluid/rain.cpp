// SPDX-License-Identifier: Apache-2.0
#include "models/structured/fluid/rain.h"

#include <algorithm>
#include <type_traits>
#include <vector>

#include "models/finite_volume/step.h"
#include "models/structured/fluid/fluid_step.h"
#include "physics/infiltration_green_ampt.h"
#include "physics/rain.h"

namespace frana::structured {
namespace {

/// Tight ground: nothing is computed for it.
struct Tight {};

template <class Visit>
void for_open_cells(const FluidState& state, std::int64_t tile, const Visit& visit) {
    const NodeGrid& nodes = state.now.nodes;
    NodeRange(tile, state.now.tiles, nodes)
        .for_each(nodes.stride(), [&](std::size_t cell, std::int64_t i, std::int64_t j) {
            if (!nodes.is_ghost(i, j) && !nodes.is_gap(cell) && !nodes.is_wall(cell)) visit(cell);
        });
}

struct Exchanged {
    double fallen = 0, gone = 0;  ///< depths, summed over cells [m]
};

// What falls on a tile and infiltrates in it. Six instantiations: rain everywhere or by place; tight ground, uniform
// soil, soil by place.
template <class RainOf, class SoilOf>
Exchanged exchange(FluidState& state, std::int64_t tile, const RainOf& rain_of, double dt, const SoilOf& soil_of) {
    finite_volume::State& now = state.now;
    Exchanged sum;
    for_open_cells(state, tile, [&](std::size_t cell) {
        const double rain = rain_of(cell);
        now.depth[cell] += rain;
        sum.fallen += rain;
        if constexpr (!std::is_same_v<SoilOf, Tight>) {
            const double depth = now.depth[cell], gone = soil_of(cell)(state.infiltrated[cell], depth, dt);
            if (!(gone > 0)) return;
            const double kept = 1 - gone / depth;
            state.infiltrated[cell] += gone;
            sum.gone += gone;
            now.depth[cell] = depth - gone;
            now.qx[cell] *= kept;
            now.qy[cell] *= kept;
        }
    });
    return sum;
}

// A map of rain, and for how much of a step it falls [s].
struct Falling {
    const ZeroArray<double>* intensity;
    double seconds;
};

std::vector<Falling> falling_between(const FluidState& state, double from, double until) {
    std::vector<Falling> all;
    for (const FluidState::RainMap& map : state.rain_maps)
        if (const double seconds = std::min(until, map.until) - std::max(from, map.from); seconds > 0)
            all.push_back({&map.intensity, seconds});
    return all;
}

}  // namespace

void find_open_ground(FluidState& state, const FluidLaws& laws) {
    if (!laws.rain.falls()) return;
    finite_volume::State& now = state.now;
    state.open_tiles.clear();
    state.open_cells = 0;
    for (std::int64_t tile = 0; tile < now.tiles.tiles_x() * now.tiles.tiles_y(); ++tile) {
        const NodeRange range(tile, now.tiles, now.nodes);
        if (range.i0 >= range.i1 || range.j0 >= range.j1) continue;
        finite_volume::require_ground(now, sweeps_of(laws, now.nodes), {range.i0, range.i1, range.j0, range.j1});
        const std::int64_t before = state.open_cells;
        for_open_cells(state, tile, [&](std::size_t) { ++state.open_cells; });
        if (state.open_cells > before) state.open_tiles.push_back(tile);
    }
}

void rain_and_infiltrate(FluidState& state, const FluidLaws& laws, double time, double dt, ThreadPool& pool) {
    const bool soaks = state.infiltrated.size() > 0;
    const double fallen = laws.rain.depth_by(time), rain = std::max(0.0, fallen - state.rained);
    const std::vector<Falling> falling = falling_between(state, time - dt, time);
    const bool rains = rain > 0 || !falling.empty();
    if (!rains && !soaks) return;
    state.rained = std::max(state.rained, fallen);
    const std::vector<std::int64_t>& tiles = rains ? state.open_tiles : state.now.wet;
    std::vector<Exchanged> sums(tiles.size());
    const auto over_tiles = [&](const auto& rain_of, const auto& soil_of) {
        pool.for_each(tiles.size(), [&](std::size_t t) { sums[t] = exchange(state, tiles[t], rain_of, dt, soil_of); });
    };
    const auto with_rain = [&](const auto& rain_of) {
        if (!soaks) {
            over_tiles(rain_of, Tight{});
        } else if (state.soils.size() == 0) {
            over_tiles(rain_of, [&](std::size_t) { return state.soil; });
        } else {
            over_tiles(rain_of, [&](std::size_t cell) { return state.soils[cell]; });
        }
    };
    if (falling.empty()) {
        with_rain([rain](std::size_t) { return rain; });
    } else {
        with_rain([&](std::size_t cell) {
            double depth = 0;
            for (const Falling& one : falling) depth += one.seconds * (*one.intensity)[cell];
            return depth;
        });
    }
    for (const Exchanged& sum : sums) {
        state.volume_infiltrated += sum.gone * state.now.cell_area();
        if (!falling.empty()) state.volume_rained_by_place += sum.fallen * state.now.cell_area();
    }
    finite_volume::settle(state.now, sweeps_of(laws, state.now.nodes), tiles, &pool);
}

}  // namespace frana::structured
