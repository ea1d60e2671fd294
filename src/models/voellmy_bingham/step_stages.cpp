// SPDX-License-Identifier: Apache-2.0
// The stages of a step that sweep over particles and nodes.
#include <algorithm>
#include <cmath>

#include "models/voellmy_bingham/step_stages.h"
#include "mpm/bed_exchange.h"
#include "mpm/boundary.h"
#include "mpm/held_state.h"
#include "mpm/levels.h"
#include "mpm/shifting.h"
#include "mpm/update_nodes.h"

namespace frana::voellmy_bingham {
namespace {

// Runs a stage over the active particle tiles, colour after colour: tiles of one colour share no node.
template <class Task>
void for_tiles_by_colour(const State& state, ThreadPool& pool, const Task& task) {
    for (const auto& colour : state.active.bringing()) {
        pool.for_each(colour.size(), [&](std::size_t i) { task(state.order.tiles()[colour[i]]); });
    }
}

template <class Task>
void for_node_tiles(const State& state, const std::vector<std::int64_t>& tiles, ThreadPool& pool, const Task& task) {
    pool.for_each(tiles.size(), [&](std::size_t t) { task(NodeRange(tiles[t], state.order.grid(), state.nodes)); });
}

// Runs a sweep over these tiles, by the fast kernel where it computes a tile.
template <class Plain>
void sweep_nodes(Step& now, const std::vector<std::int64_t>& tiles, VectorNodeKernels::Sweep VectorNodeKernels::*fast,
                 const Plain& plain) {
    const VectorNodeKernels* const kernels = now.stages.fast_nodes;
    NodeGrid& nodes = now.state.nodes;
    for_node_tiles(now.state, tiles, now.pool, [&](const NodeRange& range) {
        if (kernels != nullptr && four_at_a_time(range, nodes)) {
            (kernels->*fast)(range, nodes);
        } else {
            plain(range, nodes);
        }
    });
}

// Whether material at rest stays unchanged while nothing near it moves: with friction that holds it, and without terms
// that change with time or act across the edges.
bool may_rest(const Laws& laws, const Stages& stages) {
    return laws.skips_rest && laws.friction.keeps_rest() && stages.pore_pressure_to_nodes == nullptr && !laws.wall &&
           !laws.exchange.at_nodes;
}

void mix_with_bed(State& state, const PorePressure::State& bed, ThreadPool& pool) {
    const auto& tiles = state.order.tiles();
    std::vector<ExchangeReport> reports(tiles.size());
    pool.for_each(tiles.size(), [&](std::size_t t) {
        mix_particles(tiles[t].begin, tiles[t].end, state.kept.data(), state.lost.data(), bed, state.particles,
                      reports[t]);
    });
    for (const ExchangeReport& r : reports) state.exchanged.merge(r);
}

// Whether walls of the ground are within reach of the particles, for each tile that is moved.
std::vector<std::uint8_t> near_walls(Step& now) {
    State& state = now.state;
    const TileGrid& grid = state.order.grid();
    std::vector<std::uint8_t> near(state.active.moved().size());
    if (!now.stages.follows_bed) return near;
    if (state.nodes.bed_changes) state.walled.forget(state.order.node_tiles());
    for (std::size_t i = 0; i < near.size(); ++i) {
        const ParticleTile& tile = state.order.tiles()[state.active.moved()[i]];
        for (std::int64_t b = tile.y0; b <= tile.y1; ++b)
            for (std::int64_t a = tile.x0; a <= tile.x1; ++a)
                if (state.walled.examine(b * grid.tiles_x() + a, grid, state.nodes)) near[i] = 1;
    }
    return near;
}

}  // namespace

void choose_length(Step& now, double dt_limit) {
    const State& state = now.state;
    const double stable =
        stable_step(state.nodes.cell_size(), now.laws.step, state.speeds, now.laws.gravity, state.diffusivity);
    now.drift = std::min(stable, dt_limit);
    now.kick = state.velocity_lag + now.drift - (now.stages.leapfrog ? 0.5 * now.drift : 0);
}

void choose_active_tiles(Step& now) {
    ActiveTiles& active = now.state.active;
    active.choose(now.state.order, may_rest(now.laws, now.stages));
    active.keep(now.state.nodes);
    now.report.dt = now.drift;
    now.report.moved = active.moved_particles(now.state.order);
}

void particles_to_nodes(Step& now) {
    State& state = now.state;
    state.nodes.phase = NodePhase::sums;
    for_node_tiles(state, state.active.cleared(), now.pool,
                   [&](const NodeRange& range) { clear_nodes(range, state.nodes); });
    for_tiles_by_colour(state, now.pool, [&](const ParticleTile& tile) {
        now.stages.particles_to_nodes(tile, state.particles, state.nodes);
    });
    if (now.laws.wall) mirror_sums(state.nodes);
}

void reference_levels(Step& now) {
    State& state = now.state;
    const ActiveTiles& active = state.active;
    if (!now.stages.references) {
        state.nodes.phase = NodePhase::forces;
        return;
    }
    sweep_nodes(now, active.updated(), &VectorNodeKernels::mean_levels, mean_levels);
    for_node_tiles(state, active.gathered(), now.pool,
                   [&](const NodeRange& range) { clear_squares(range, state.nodes); });
    state.nodes.phase = NodePhase::forces;
    sweep_nodes(now, active.updated(), &VectorNodeKernels::node_references, node_references);
    for_node_tiles(state, active.updated(), now.pool,
                   [&](const NodeRange& range) { hold_on_grid(range, now.laws.gravity, now.laws.wall, state.nodes); });
    if (now.laws.wall) mirror_levels(state.nodes);
}

void forces_to_nodes(Step& now) {
    State& state = now.state;
    if (now.stages.follows_bed) {  // momenta in map view; levels show ponding
        for (const auto* tiles : {&state.active.updated(), &state.active.gathered()})
            sweep_nodes(now, *tiles, &VectorNodeKernels::momenta_to_map, momenta_to_map);
    }
    for_tiles_by_colour(state, now.pool, [&](const ParticleTile& tile) {
        now.stages.pressure_to_nodes(tile, state.particles, now.laws.gravity, state.nodes);
    });
    if (now.laws.wall) fold_forces(state.nodes);
}

void pore_pressure(Step& now) {
    if (now.stages.pore_pressure_to_nodes == nullptr) return;
    State& state = now.state;
    double* const sums = state.pore_sums.data();
    for_node_tiles(state, state.active.cleared(), now.pool, [&](const NodeRange& range) {
        range.for_each(state.nodes.stride(), [&](std::size_t i, std::int64_t, std::int64_t) { sums[i] = 0; });
    });
    for_tiles_by_colour(state, now.pool, [&](const ParticleTile& tile) {
        now.stages.pore_pressure_to_nodes(tile, now.laws.friction.pore_pressure, now.kick, now.laws.gravity,
                                          now.stages.follows_bed, state.nodes, state.particles, sums);
    });
    if (now.laws.wall) mirror_scalar(state.nodes, sums);
}

void bed_resistance(Step& now) {
    State& state = now.state;
    const Laws& laws = now.laws;
    now.nodes = {now.kick, laws.gravity, laws.gravity_x, laws.gravity_y, laws.minimum_depth};
    now.nodes.moving_speed = laws.moving_speed;
    now.nodes.kept = now.stages.kept;
    now.nodes.wall = laws.wall;
    now.nodes.drift = now.drift;
    if (state.gathered.size() != 0) now.nodes.gathered = state.gathered.data();
    if (now.stages.pore_pressure_to_nodes != nullptr) now.nodes.pore_sums = state.pore_sums.data();
    BedState* const bed_states = state.bed_states.data();
    if (now.stages.fill_bed_states != nullptr) {
        for_node_tiles(state, state.active.updated(), now.pool, [&](const NodeRange& range) {
            now.stages.fill_bed_states(range, now.nodes, state.nodes, bed_states);
            for (const FrictionSweep& sweep : laws.friction.sweeps) sweep(range, state.nodes, bed_states);
        });
    }
    if (laws.friction.keeps_rest()) {
        for_node_tiles(state, state.active.updated(), now.pool, [&](const NodeRange& range) {
            now.stages.find_held_nodes(range, now.nodes, laws.friction, bed_states, state.nodes);
        });
    }
}

void update_nodes(Step& now) {
    State& state = now.state;
    ActiveTiles& active = state.active;
    now.pool.for_each(active.updated().size(), [&](std::size_t t) {
        const std::int64_t tile = active.updated()[t];
        NodeReport& report = state.node_reports[static_cast<std::size_t>(tile)];
        report = now.stages.update_nodes(NodeRange(tile, state.order.grid(), state.nodes), now.nodes, now.laws.friction,
                                         state.bed_states.data(), state.time, state.nodes, now.maxima);
        active.record_motion(tile, report.moves);
    });
    for (const std::int64_t tile : state.order.node_tiles())
        now.report.nodes.merge(state.node_reports[static_cast<std::size_t>(tile)]);
    state.nodes.phase = NodePhase::motion;
    active.put_back(state.nodes);
    if (now.laws.wall) mirror_velocities(state.nodes);
}

void exchange_with_bed(Step& now) {
    if (!now.exchanges()) return;
    State& state = now.state;
    for_node_tiles(state, state.order.node_tiles(), now.pool, [&](const NodeRange& range) {
        now.laws.exchange.at_nodes(range, now.drift, now.laws.resample.minimum_depth, state.bed_states.data(),
                                   state.nodes, state.erodible_beds.data());
    });
    for_node_tiles(state, state.order.node_tiles(), now.pool,
                   [&](const NodeRange& range) { move_bed(range, state.erodible_beds.data(), state.nodes); });
    if (now.laws.wall) {
        mirror_exchange(state.nodes, state.erodible_beds.data());
        mirror_bed(state.nodes);
    }
    state.kept.resize(state.particles.size());
    state.lost.resize(state.particles.size());
    const auto& tiles = state.order.tiles();
    std::vector<ExchangeReport> reports(tiles.size());
    now.pool.for_each(tiles.size(), [&](std::size_t t) {
        now.stages.exchange_with_particles(tiles[t].begin, tiles[t].end, state.nodes, state.erodible_beds.data(),
                                           state.particles, state.kept.data(), state.lost.data(), reports[t]);
    });
    for (const ExchangeReport& r : reports) state.exchanged.merge(r);
}

void nodes_to_particles(Step& now) {
    State& state = now.state;
    const Laws& laws = now.laws;
    ParticleUpdate update{now.drift, laws.gravity * laws.stress.wave_factor, laws.resample.minimum_depth, laws.wall,
                          laws.origin};
    update.kept = now.stages.kept;
    update.critical = std::sqrt(laws.gravity);
    if (shifts_now(state, now.stages)) update.shift = k_shift;
    const auto& tiles = state.order.tiles();
    for (const ParticleTile& tile : tiles) {
        ParticleReport& last = state.particle_reports[static_cast<std::size_t>(tile.tile)];
        last.longest = 0;
        last.walls = {};
    }
    const std::vector<std::uint8_t> walls = near_walls(now);
    now.pool.for_each(state.active.moved().size(), [&](std::size_t i) {
        const ParticleTile& tile = tiles[state.active.moved()[i]];
        ParticleUpdate own = update;
        own.ground_walls = walls[i] != 0;
        state.particle_reports[static_cast<std::size_t>(tile.tile)] =
            now.stages.nodes_to_particles(tile, own, laws.stress, state.nodes, state.particles);
    });
    for (const std::size_t i : state.active.moved()) {  // what is piled up spreads its areas without motion
        const std::int64_t tile = tiles[i].tile;
        if (state.particle_reports[static_cast<std::size_t>(tile)].piled > 0) state.active.reset(tile);
    }
    for (const ParticleTile& tile : tiles)
        now.report.particles.merge(state.particle_reports[static_cast<std::size_t>(tile.tile)]);
    state.walls.merge(now.report.particles.walls);
    if (now.exchanges()) mix_with_bed(state, laws.exchange.bed, now.pool);
}

void gather_on_nodes(State& state, const Laws& laws, const Stages& stages, Maxima& maxima, ThreadPool& pool) {
    Step now(state, laws, stages, maxima, pool);
    state.active.choose(state.order, false);
    particles_to_nodes(now);
    reference_levels(now);
    state.active.activate(state.order);
}

}  // namespace frana::voellmy_bingham
