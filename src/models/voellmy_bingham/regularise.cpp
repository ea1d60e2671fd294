// SPDX-License-Identifier: Apache-2.0
// Between two steps: order and number of the particles, take-off and landing.
#include <algorithm>
#include <cmath>

#include "models/voellmy_bingham/step_stages.h"
#include "models/voellmy_bingham/tail.h"
#include "mpm/boundary.h"
#include "mpm/crowding.h"
#include "mpm/shifting.h"

namespace frana::voellmy_bingham {
namespace {

// Particles whose shape has a trace above this many cells' areas are split before the next regular sort (a front would
// tear otherwise: splitting early reduces the error of the dry dam break by a third), but sorts are at least this many
// steps apart.
constexpr double k_long_shape = 1;
constexpr int k_sort_pause = 3;
// Slopes, curvatures and levels read at most this many nodes beyond those that particles can touch.
constexpr std::int64_t k_round = 8;

void activate_where_crossed(State& state, ThreadPool& pool) {
    const double *x = state.particles[Field::x], *y = state.particles[Field::y];
    const auto& tiles = state.order.tiles();
    std::vector<std::uint8_t> crossed(tiles.size(), 0);
    pool.for_each(tiles.size(), [&](std::size_t t) {
        for (std::size_t p = tiles[t].begin; p < tiles[t].end && crossed[t] == 0; ++p)
            crossed[t] = state.order.tile_of(x[p], y[p]) != tiles[t].tile;
    });
    for (std::size_t t = 0; t < tiles.size(); ++t) {
        if (crossed[t] != 0) state.active.activate_round(tiles[t].tile);
    }
}

// One byte per tile of particles: those at rest need neither splitting nor merging.
std::vector<std::uint8_t> resting(const State& state) {
    std::vector<std::uint8_t> rests;
    for (const ParticleTile& tile : state.order.tiles()) rests.push_back(state.active.rests(tile) ? 1 : 0);
    return rests;
}

void mark_tails(State& state, const Maxima& maxima, ThreadPool& pool) {
    const auto& tiles = state.order.node_tiles();
    pool.for_each(tiles.size(), [&](std::size_t t) {
        mark_tail(NodeRange(tiles[t], state.order.grid(), state.nodes), state.nodes, maxima.depth.data(),
                  state.tail.data());
    });
}

// Plans the order by tile when particles may have drifted to the limit, drops those outside the terrain, if there may
// be any, and clears the nodes that no particle can touch any more: their old sums must not be read as a neighbour's.
// The particles are still to be moved.
void plan_order(State& state, bool drop, ThreadPool& pool) {
    std::vector<std::uint8_t> keep;
    if (drop) {
        const double *x = state.particles[Field::x], *y = state.particles[Field::y];
        const double* volume = state.particles[Field::volume];
        keep.resize(state.particles.size(), 1);
        for (std::size_t p = 0; p < keep.size(); ++p) {
            if (state.nodes.bounds().contains(x[p], y[p])) continue;
            keep[p] = 0;
            state.volume_left += volume[p];
        }
    }
    if (state.active.any_rests(state.order)) activate_where_crossed(state, pool);
    const std::vector<std::int64_t> before = state.order.node_tiles();
    state.order.plan(state.particles, keep, pool);
    const auto& now = state.order.node_tiles();
    cover_ground(state);
    for (const std::int64_t tile : before) {
        if (!std::binary_search(now.begin(), now.end(), tile)) {
            clear_nodes(NodeRange(tile, state.order.grid(), state.nodes), state.nodes);
            state.active.reset(tile);
        }
    }
    state.drift = 0;
    state.since_sort = 0;
}

FlowSpeeds speeds_of(const ParticleSet& particles, std::size_t p, const Laws& laws) {
    const double speed = std::hypot(particles[Field::u][p], particles[Field::v][p]);
    const double celerity =
        std::sqrt(laws.gravity * laws.stress.wave_factor * particles[Field::volume][p] / particles[Field::area][p]);
    return {speed + celerity, k_carried * speed + celerity, speed};
}

// Viscosity of the in-plane stress of a particle without strain [m2/s].
double diffusivity_of(const ParticleSet& particles, std::size_t p, const Laws& laws) {
    const double depth = particles[Field::volume][p] / particles[Field::area][p];
    const StrainRate<double> rate{0, 0, 0, particles[Field::u][p], particles[Field::v][p], depth};
    return laws.stress.law ? laws.stress.law(rate).diffusivity : 0;
}

// Shortens the next step as a particle requires that no step has moved yet.
void bound_by(State& state, std::size_t p, const Laws& laws) {
    state.speeds.merge(speeds_of(state.particles, p, laws));
    state.diffusivity = std::max(state.diffusivity, diffusivity_of(state.particles, p, laws));
}

}  // namespace

void cover_ground(const State& state) {
    if (!state.nodes.is_on_demand()) return;
    for (const std::int64_t tile : state.order.node_tiles()) {
        const NodeRange range(tile, state.order.grid(), state.nodes);
        state.nodes.cover({range.i0 - k_round, range.i1 + k_round, range.j0 - k_round, range.j1 + k_round});
    }
}

bool shifts_now(const State& state, const Stages& stages) {
    return stages.resamples && state.since_sort % k_shift_steps == 0;
}

void prepare(State& state, const Laws& laws, ThreadPool& pool) {
    plan_order(state, true, pool);
    state.order.apply(state.particles, pool);
    state.active.activate(state.order);
    state.speeds = {};
    for (std::size_t p = 0; p < state.particles.size(); ++p) bound_by(state, p, laws);
    if (laws.wall) mirror_bed(state.nodes);
}

void advance_time(Step& now) {
    State& state = now.state;
    state.time += now.drift;
    state.velocity_lag = now.stages.leapfrog ? 0.5 * now.drift : 0;
    state.speeds = now.report.particles.speeds;
    state.diffusivity = now.report.particles.diffusivity;
}

void regularise(Step& now) {
    State& state = now.state;
    const ParticleReport& report = now.report.particles;
    const double dx = state.nodes.cell_size();
    const double moved = report.speeds.flow * now.drift / dx, shift = now.stages.resamples ? shift_reach(moved) : 0;
    state.drift += moved + (shifts_now(state, now.stages) ? shift : 0);
    ++state.since_sort;
    const bool stretched =
        now.stages.resamples && report.longest > k_long_shape * dx * dx && state.since_sort >= k_sort_pause;
    if (!(report.outside > 0 || stretched || state.drift + moved + shift > k_drift_limit)) return;
    plan_order(state, report.outside > 0, now.pool);
    if (!now.stages.resamples) state.order.apply(state.particles, now.pool);
    if (!now.stages.resamples) return;
    const bool film = now.laws.resample.film_depth > 0;
    if (film) mark_tails(state, now.maxima, now.pool);
    now.report.resampled = resample(state.particles, state.order, now.laws.resample, resting(state),
                                    film ? state.tail.data() : nullptr, now.pool);
    if (now.report.resampled.split > 0) state.drift = k_split_reach;
}

void leave_and_land(Step& now) {
    if (!now.stages.flies) return;
    State& state = now.state;
    const JumpRules& rules = now.laws.jumps;
    state.flights.advance_to(state.time, rules);
    now.report.aloft = state.flights.volume();
    now.report.aloft_kinetic = state.flights.kinetic();
    const std::vector<std::size_t> leaving =
        state.flights.take_off(state.particles, state.order, state.nodes, rules, state.time, now.drift, now.pool);
    const Flights::Landed landed = state.flights.land(state.time, state.particles);
    now.report.aloft -= landed.left;
    state.volume_left += landed.left;
    if (leaving.empty() && landed.count == 0) return;
    const std::size_t first = state.particles.size() - landed.count;
    for (const std::size_t p : fit_appended(state.nodes, state.order, first, state.particles))
        bound_by(state, p, now.laws);
    for (std::size_t p = first; p < state.particles.size(); ++p) {
        bound_by(state, p, now.laws);
        state.active.activate_round(state.order.tile_of(state.particles[Field::x][p], state.particles[Field::y][p]));
    }
    state.order.amend(state.particles, leaving, first);
    cover_ground(state);
}

}  // namespace frana::voellmy_bingham
