// SPDX-License-Identifier: Apache-2.0
#include "models/voellmy_bingham/step.h"

#include <algorithm>
#include <cmath>

#include "mpm/boundary.h"
#include "mpm/levels.h"
#include "mpm/shifting.h"
#include "mpm/stable_step.h"

namespace frana::voellmy_bingham {
namespace {

// Particles whose shape has a trace above this many cells' areas wait no longer for the next sort to be split (a
// front that does tears: the error of the dry dam break is a third smaller so), but sorts come at least this many
// steps apart.
constexpr double k_long_shape = 1;
constexpr int k_sort_pause = 3;

// Runs a stage over the particle tiles that bring something, colour after colour: tiles of one colour share no node.
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

// Whether what is at rest stays as it is while nothing near it moves: with friction that holds, and nothing that
// changes with time or reaches across the edges.
bool may_rest(const Laws& laws, const Stages& stages) {
    return laws.skips_rest && laws.friction.holds() && !laws.friction.pore_pressure.active() && !laws.wall &&
           stages.exchange_at_nodes == nullptr;
}

void wake_where_crossed(State& state, ThreadPool& pool) {
    const double *x = state.particles[Field::x], *y = state.particles[Field::y];
    const auto& tiles = state.order.tiles();
    std::vector<std::uint8_t> crossed(tiles.size(), 0);
    pool.for_each(tiles.size(), [&](std::size_t t) {
        for (std::size_t p = tiles[t].begin; p < tiles[t].end && crossed[t] == 0; ++p)
            crossed[t] = state.order.tile_of(x[p], y[p]) != tiles[t].tile;
    });
    for (std::size_t t = 0; t < tiles.size(); ++t) {
        if (crossed[t] != 0) state.active.wake_round(tiles[t].tile);
    }
}

// Sorts by tile, dropping what has left, and forgets the nodes that no particle can touch any more: their old
// sums must not be read as a neighbour's.
// @param keep 0 for particles to drop besides; may be empty
void sort_particles(State& state, bool drop, std::vector<std::uint8_t> keep, ThreadPool& pool) {
    if (drop) {
        const double *x = state.particles[Field::x], *y = state.particles[Field::y];
        const double* volume = state.particles[Field::volume];
        keep.resize(state.particles.size(), 1);
        for (std::size_t p = 0; p < keep.size(); ++p) {
            if (keep[p] == 0 || state.nodes.bounds().holds(x[p], y[p])) continue;
            keep[p] = 0;
            state.volume_left += volume[p];
        }
    }
    if (state.active.any_rests(state.order)) wake_where_crossed(state, pool);
    const std::vector<std::int64_t> before = state.order.node_tiles();
    state.order.sort(state.particles, keep, pool);
    const auto& now = state.order.node_tiles();
    for (const std::int64_t tile : before) {
        if (!std::binary_search(now.begin(), now.end(), tile)) {
            clear_nodes(NodeRange(tile, state.order.grid(), state.nodes), state.nodes);
            state.active.forget(tile);
        }
    }
    state.drift = 0;
    state.since_sort = 0;
}

// Erosion and deposition: decided at the nodes, taken and given by the particles where they still are.
void exchange_with_bed(State& state, const Laws& laws, const Stages& stages, double dt, ThreadPool& pool) {
    for_node_tiles(state, state.order.node_tiles(), pool, [&](const NodeRange& range) {
        stages.exchange_at_nodes(range, laws.exchange, dt, laws.resample.minimum_depth,
                                 state.bed_states.data(), state.nodes, state.bed_layers.data());
    });
    for_node_tiles(state, state.order.node_tiles(), pool, [&](const NodeRange& range) {
        move_bed(range, state.bed_layers.data(), state.nodes);
    });
    if (laws.wall) {
        mirror_exchange(state.nodes, state.bed_layers.data());
        mirror_bed(state.nodes);
    }
    state.kept.resize(state.particles.size());
    state.lost.resize(state.particles.size());
    const auto& tiles = state.order.tiles();
    std::vector<ExchangeReport> reports(tiles.size());
    pool.for_each(tiles.size(), [&](std::size_t t) {
        stages.exchange_with_particles(tiles[t].begin, tiles[t].end, state.nodes, state.bed_layers.data(),
                                       state.particles, state.kept.data(), state.lost.data(), reports[t]);
    });
    for (const ExchangeReport& r : reports) state.exchanged.merge(r);
}

// What leaves the bed within the next step goes into the air, what has come down lies on the ground again. Particles are
// sorted for it, but neither shifted nor split: their number of steps since the last sort stays.
void leave_and_land(State& state, const Laws& laws, double dt, StepReport& report, ThreadPool& pool) {
    const JumpRules rules{laws.gravity, laws.wall, laws.flight_slope};
    report.aloft = state.flights.volume();
    report.aloft_kinetic = state.flights.kinetic(state.time, rules.gravity);
    std::vector<std::uint8_t> keep;
    if (report.nodes.unsupported > 0)
        state.flights.take_off(state.particles, state.order, state.nodes, state.nodes_seen.data(), rules, state.time, dt,
                               keep, pool);
    const Flights::Landed landed = state.flights.land(state.time, state.particles);
    report.aloft -= landed.left;
    state.volume_left += landed.left;
    if (keep.empty() && landed.count == 0) return;
    if (!keep.empty()) keep.resize(state.particles.size(), 1);
    const ParticleSet& particles = state.particles;
    for (std::size_t p = particles.size() - landed.count; p < particles.size(); ++p) {
        const Point place{particles[Field::x][p], particles[Field::y][p]};
        const double wave = std::hypot(particles[Field::u][p], particles[Field::v][p]) +
                            std::sqrt(laws.gravity * laws.stress.wave_factor * particles[Field::volume][p] /
                                      particles[Field::area][p]);
        state.wave_speed = std::max(state.wave_speed, wave);
        state.active.wake_round(state.order.tile_of(place.x, place.y));
    }
    const double drift = state.drift;
    const int since_sort = state.since_sort;
    sort_particles(state, false, std::move(keep), pool);
    state.drift = drift;
    state.since_sort = since_sort;
}

// Shifting needs what splitting does: the default scheme with its affine velocities.
bool shifts_now(const State& state, const Stages& stages) {
    return stages.resamples && state.since_sort % k_shift_steps == 0;
}

void slow_down(State& state, ThreadPool& pool) {
    const auto& tiles = state.order.tiles();
    std::vector<ExchangeReport> reports(tiles.size());
    pool.for_each(tiles.size(), [&](std::size_t t) {
        slow_particles(tiles[t].begin, tiles[t].end, state.kept.data(), state.lost.data(), state.particles,
                       reports[t]);
    });
    for (const ExchangeReport& r : reports) state.exchanged.merge(r);
}

}  // namespace

void prepare(State& state, const Laws& laws, ThreadPool& pool) {
    sort_particles(state, true, {}, pool);
    state.active.wake(state.order);
    state.wave_speed = 0;
    const double *u = state.particles[Field::u], *v = state.particles[Field::v];
    const double *volume = state.particles[Field::volume], *area = state.particles[Field::area];
    for (std::size_t p = 0; p < state.particles.size(); ++p) {
        const double wave =
            std::hypot(u[p], v[p]) + std::sqrt(laws.gravity * laws.stress.wave_factor * volume[p] / area[p]);
        state.wave_speed = std::max(state.wave_speed, wave);
    }
    if (laws.wall) mirror_bed(state.nodes);
}

namespace {

// gather_on_nodes for the tiles that the step computes.
void gather(State& state, const Laws& laws, const Stages& stages, ThreadPool& pool, StageWatch& watch) {
    const ActiveTiles& active = state.active;
    for_node_tiles(state, active.cleared(), pool, [&](const NodeRange& range) { clear_nodes(range, state.nodes); });
    for_tiles_by_colour(state, pool, [&](const ParticleTile& tile) {
        stages.particles_to_nodes(tile, state.particles, state.nodes);
    });
    if (laws.wall) mirror_sums(state.nodes);
    watch.ends(Stage::particles_to_nodes);
    if (stages.references) {
        for_node_tiles(state, active.updated(), pool, [&](const NodeRange& range) { mean_levels(range, state.nodes); });
        for_node_tiles(state, active.gathered(), pool,
                       [&](const NodeRange& range) { forget_squares(range, state.nodes); });
        for_node_tiles(state, active.updated(), pool,
                       [&](const NodeRange& range) { node_references(range, state.nodes); });
        if (laws.wall) mirror_levels(state.nodes);
        watch.ends(Stage::levels);
    }
}

// Forces change the velocities for a time `kick`, then the new velocities move the particles for a time `drift`.
StepReport kick_and_drift(State& state, const Laws& laws, const Stages& stages, double kick, double drift,
                          Maxima& maxima, ThreadPool& pool) {
    StepReport report;
    StageWatch watch(report.seconds);
    report.dt = drift;

    // Particles to nodes: mass, momentum, area, reference levels; then the force of pressure, slope and
    // stress.
    ActiveTiles& active = state.active;
    active.choose(state.order, may_rest(laws, stages));
    active.keep(state.nodes);
    report.moved = active.moved_particles(state.order);
    gather(state, laws, stages, pool, watch);
    if (stages.follows_bed) {
        for (const auto* tiles : {&active.updated(), &active.gathered()})
            for_node_tiles(state, *tiles, pool, [&](const NodeRange& range) { momenta_to_map(range, state.nodes); });
    }
    for_tiles_by_colour(state, pool, [&](const ParticleTile& tile) {
        stages.pressure_to_nodes(tile, state.particles, laws.gravity, state.nodes);
    });
    if (laws.wall) fold_forces(state.nodes);
    watch.ends(Stage::pressure);

    // Nodes: gravity along the bed, friction as a cap, maxima. Holding looks at neighbours, so it comes
    // first.
    NodeUpdate node_update{kick, laws.gravity, laws.gravity_x, laws.gravity_y, laws.minimum_depth};
    node_update.moving_speed = laws.moving_speed;
    node_update.change_only = stages.change_only;
    node_update.wall = laws.wall;
    if (state.brought.size() != 0) node_update.brought = state.brought.data();
    if (laws.friction.pore_pressure.active())
        node_update.effective_share = 1 - laws.friction.pore_pressure.ratio(state.time);
    BedState* const bed_states = state.bed_states.data();
    if (stages.fill_bed_states != nullptr) {
        for_node_tiles(state, active.updated(), pool, [&](const NodeRange& range) {
            stages.fill_bed_states(range, node_update, state.nodes, bed_states);
            for (const FrictionSweep& sweep : laws.friction.sweeps)
                sweep(range, node_update, state.nodes, bed_states);
        });
    }
    if (laws.friction.holds()) {
        for_node_tiles(state, active.updated(), pool, [&](const NodeRange& range) {
            stages.hold_nodes(range, node_update, laws.friction, bed_states, state.nodes);
        });
    }
    pool.for_each(active.updated().size(), [&](std::size_t t) {
        const std::int64_t tile = active.updated()[t];
        NodeReport& seen = state.nodes_seen[static_cast<std::size_t>(tile)];
        seen = stages.update_nodes(NodeRange(tile, state.order.grid(), state.nodes), node_update, laws.friction,
                                   bed_states, state.time, state.nodes, maxima);
        active.saw(tile, seen.moves);
    });
    for (const std::int64_t tile : state.order.node_tiles())
        report.nodes.merge(state.nodes_seen[static_cast<std::size_t>(tile)]);
    active.put_back(state.nodes);
    if (laws.wall) mirror_velocities(state.nodes);
    // Only while positions move: velocities alone take nothing from the bed.
    const bool exchanges = stages.exchange_at_nodes != nullptr && drift > 0;
    if (exchanges) exchange_with_bed(state, laws, stages, drift, pool);
    watch.ends(Stage::nodes);

    // Nodes to particles: velocity, position, depth, stress.
    ParticleUpdate particle_update{drift, laws.gravity * laws.stress.wave_factor, laws.resample.minimum_depth,
                                         laws.wall, laws.origin, laws.gravity * kick};
    if (shifts_now(state, stages)) particle_update.shift = k_shift;
    const auto& tiles = state.order.tiles();
    for (const ParticleTile& tile : tiles) state.particles_seen[static_cast<std::size_t>(tile.tile)].longest = 0;
    pool.for_each(active.moved().size(), [&](std::size_t i) {
        const ParticleTile& tile = tiles[active.moved()[i]];
        state.particles_seen[static_cast<std::size_t>(tile.tile)] =
            stages.nodes_to_particles(tile, particle_update, laws.stress, state.nodes, state.particles);
    });
    for (const ParticleTile& tile : tiles)
        report.particles.merge(state.particles_seen[static_cast<std::size_t>(tile.tile)]);
    if (exchanges) slow_down(state, pool);
    watch.ends(Stage::nodes_to_particles);
    return report;
}

// One byte a tile of particles: those that rest need neither splitting nor merging.
std::vector<std::uint8_t> resting(const State& state) {
    std::vector<std::uint8_t> rests;
    for (const ParticleTile& tile : state.order.tiles()) rests.push_back(state.active.rests(tile) ? 1 : 0);
    return rests;
}

}  // namespace

void gather_on_nodes(State& state, const Laws& laws, const Stages& stages, ThreadPool& pool, StageWatch& watch) {
    state.active.choose(state.order, false);
    gather(state, laws, stages, pool, watch);
    state.active.wake(state.order);
}

StepReport step(State& state, const Laws& laws, const Stages& stages, double dt_limit, Maxima& maxima,
                ThreadPool& pool) {
    const double dx = state.nodes.cell_size();
    const double dt =
        std::min(stable_step(dx, laws.cfl, state.wave_speed, laws.gravity, state.diffusivity), dt_limit);
    const double lag = stages.leapfrog ? 0.5 * dt : 0;
    StepReport report = kick_and_drift(state, laws, stages, state.velocity_lag + dt - lag, dt, maxima, pool);
    StageWatch watch(report.seconds);

    // Order and number of particles; the next step's bounds.
    state.time += dt;
    state.velocity_lag = lag;
    state.wave_speed = report.particles.wave_speed;
    state.diffusivity = report.particles.diffusivity;
    const double moved = report.particles.speed * dt / dx, shift = stages.resamples ? shift_reach(moved) : 0;
    state.drift += moved + (shifts_now(state, stages) ? shift : 0);
    ++state.since_sort;
    const bool stretched = stages.resamples && report.particles.longest > k_long_shape * dx * dx &&
                           state.since_sort >= k_sort_pause;
    if (report.particles.outside > 0 || stretched || state.drift + moved + shift > k_drift_limit) {
        sort_particles(state, report.particles.outside > 0, {}, pool);
        watch.ends(Stage::sort);
        if (stages.resamples) {
            report.resampled = resample(state.particles, state.order, laws.resample, resting(state), pool);
            if (report.resampled.split > 0) state.drift = k_split_reach;
            watch.ends(Stage::resample);
        }
    }
    if (stages.flies) {
        leave_and_land(state, laws, dt, report, pool);
        watch.ends(Stage::sort);
    }
    return report;
}

void synchronise(State& state, const Laws& laws, const Stages& stages, Maxima& maxima, ThreadPool& pool) {
    if (state.velocity_lag == 0) return;
    kick_and_drift(state, laws, stages, state.velocity_lag, 0, maxima, pool);
    state.velocity_lag = 0;
}

}  // namespace frana::voellmy_bingham
