// SPDX-License-Identifier: Apache-2.0
#include "models/structured/step_stages.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "models/structured/coupling/couple_nodes.h"
#include "models/structured/coupling/release.h"
#include "models/structured/fluid/rain.h"

namespace frana::structured {
namespace {

template <class Task>
void over_solid_tiles(const State& state, ThreadPool& pool, const Task& task) {
    const SolidNodes& nodes = state.solid->nodes;
    pool.for_each(nodes.tiles.size(), [&](std::size_t t) { task(NodeRange(nodes.tiles[t], nodes.grid, state.grid)); });
}

template <class Task>
void over_rows(const SolidState& solid, ThreadPool& pool, const Task& task) {
    pool.for_each(static_cast<std::size_t>(solid.order.rows()), [&](std::size_t row) {
        const auto r = static_cast<std::int64_t>(row);
        task(solid.order.whole_rows(r, r));
    });
}

void gather(State& state, const Laws& laws, ThreadPool& pool) {
    gather_solids(*state.solid, state.stages, laws.solid, state.grid, pool);
    over_solid_tiles(state, pool, [&](const NodeRange& range) {
        solids_to_fluid(range, state.grid, state.fluid.get(), state.solid->nodes);
    });
}

// Sums over particles at the end of a step, row by row.
void observe_particles(const State& state, const Laws& laws, StepReport& report, ThreadPool& pool) {
    struct Row {
        double kinetic = 0, deepest = 0;
        std::int64_t no_data = 0, outside = 0;
        bool elastic = false;
    };
    const SolidState& solid = *state.solid;
    std::vector<Row> rows(static_cast<std::size_t>(solid.order.rows()));
    pool.for_each(rows.size(), [&](std::size_t r) {
        const auto row = static_cast<std::int64_t>(r);
        const ParticleRun run = solid.order.whole_rows(row, row);
        const bool wet = solid.particles[Field::confined] != nullptr;
        const double* const cohesion = solid.particles[Field::cohesion];
        for (std::size_t p = run.begin; p < run.end; ++p) {
            const double solids = solid.particles[Field::volume][p];
            const double confined = wet ? solid.particles[Field::confined][p] : 0;
            const double mass =
                solid.particles[Field::grain_density][p] * solids + laws.solid.basal.fluid_density * confined;
            const double u = solid.particles[Field::u][p], v = solid.particles[Field::v][p];
            rows[r].kinetic += 0.5 * mass * (u * u + v * v);
            rows[r].deepest = std::max(rows[r].deepest, (solids + confined) / solid.particles[Field::area][p]);
            if (cohesion != nullptr) rows[r].elastic |= cohesion[p] * solid.particles[Field::cohesion_ratio][p] > 0;
            const double x = solid.particles[Field::x][p], y = solid.particles[Field::y][p];
            if (!state.grid.bounds().contains(x, y)) {
                ++rows[r].outside;
            } else if (state.grid.any_solid()) {
                rows[r].no_data += state.grid.is_gap(state.grid.scale().node_of(x, y));
            }
        }
    });
    for (const Row& row : rows) {
        report.kinetic += row.kinetic;
        report.deepest = std::max(report.deepest, row.deepest);
        report.no_data += row.no_data;
        report.outside += row.outside;
        report.elastic |= row.elastic;
    }
}

void keep_for_next_step(State& state, const Laws& laws, const StepReport& report) {
    state.deepest = report.deepest;
    state.solid->elastic = report.elastic;
    state.solid->sound = std::sqrt(laws.solid.gravity * report.deepest);
}

}  // namespace

State::State(NodeGrid ground, const Laws& laws, ParticleSet solids, const SolidStages& chosen, bool with_fluid)
    : terrain(std::make_unique<NodeGrid>(std::move(ground))), stages(chosen) {
    if (with_fluid) fluid = std::make_unique<FluidState>(grid, laws.fluid);
    if (stages.update_material == nullptr) return;
    if (fluid) {
        fluid->resistance_x = ZeroArray<double>(grid.bed.size());
        fluid->resistance_y = ZeroArray<double>(grid.bed.size());
    }
    // Also in scenes whose solids are released later: the nodes are allocated at the start.
    SolidNodes nodes(grid, laws.gaps_are_walls, with_fluid);
    solid = std::make_unique<SolidState>(std::move(solids), laws.solid, grid.bounds(), std::move(nodes));
}

void add_solids(State& state, const ParticleSet& solids) {
    ParticleSet& all = state.solid->particles;
    const std::size_t before = all.size();
    all.resize(before + solids.size());
    for (std::size_t p = 0; p < solids.size(); ++p) all.set_row(before + p, solids.row(p));
}

SolidsOnGrid solids_on_grid(const State& state) {
    if (!state.solid) return {};
    return fluid_inputs(state.solid->nodes);
}

void prepare(State& state, const Laws& laws, ThreadPool& pool) {
    if (!state.solid) return;
    SolidState& solid = *state.solid;
    sort_solids(solid, laws.solid, state.grid, pool);
    for (std::size_t p = 0; p < solid.particles.size(); ++p) {
        const double u = solid.particles[Field::u][p], v = solid.particles[Field::v][p];
        solid.last.speed2 = std::max(solid.last.speed2, u * u + v * v);
        const double du = u - solid.mean.x, dv = v - solid.mean.y;
        solid.last.apart2 = std::max(solid.last.apart2, du * du + dv * dv);
    }
    solid.last.opening = 2 * std::sqrt(solid.last.apart2) / laws.solid.side;  // the most that neighbours can
    if (state.stages.advance_pore_pressure != nullptr)  // of new particles: what is hydrostatic at the start
        state.stages.advance_pore_pressure({0, solid.particles.size()}, 0, laws.solid, state.grid, solid.particles);
    StepReport now;
    observe_particles(state, laws, now, pool);
    keep_for_next_step(state, laws, now);
    gather(state, laws, pool);
}

double stable_step(const State& state, const Laws& laws, ThreadPool& pool) {
    double dt = std::numeric_limits<double>::infinity();
    if (state.fluid) dt = stable_step(*state.fluid, laws.fluid, solids_on_grid(state), pool);
    if (state.solid && state.solid->particles.size() > 0) {
        const double wave = std::sqrt(state.solid->last.speed2) + std::sqrt(laws.solid.gravity * state.deepest);
        dt = std::min(dt, laws.move_cfl * state.grid.cell_size() / wave);
    }
    return dt;
}

void choose_length(Step& now, double dt_limit) {
    now.report.dt = std::min(dt_limit, stable_step(now.state, now.laws, now.pool));
}

void move_fluid(Step& now) {
    State& state = now.state;
    if (!state.fluid) return;
    now.report.fluid = advance(*state.fluid, now.laws.fluid, solids_on_grid(state), now.report.dt, now.pool);
}

void rain_and_infiltration(Step& now) {
    State& state = now.state;
    const double dt = now.report.dt;
    if (state.fluid) rain_and_infiltrate(*state.fluid, now.laws.fluid, state.time + dt, dt, now.pool);
}

void push_on_nodes(Step& now) {
    if (!now.solids()) return;
    State& state = now.state;
    over_solid_tiles(state, now.pool, [&](const NodeRange& range) {
        push_solids(range, now.report.dt, state.grid, now.laws.solid, now.laws.coupling, now.laws.fluid,
                    state.solid->nodes, state.fluid.get());
    });
}

void nodes_to_solids(Step& now) {
    if (!now.solids()) return;
    const State& state = now.state;
    SolidState& solid = *state.solid;
    over_rows(solid, now.pool, [&](ParticleRun run) {
        state.stages.nodes_to_solids(run, now.laws.solid, now.report.dt, state.grid, solid.nodes, solid.particles);
    });
}

void pore_pressure(Step& now) {
    if (!now.solids() || now.state.stages.advance_pore_pressure == nullptr) return;
    const State& state = now.state;
    over_rows(*state.solid, now.pool, [&](ParticleRun run) {
        state.stages.advance_pore_pressure(run, 0.5 * now.report.dt, now.laws.solid, state.grid,
                                           state.solid->particles);
    });
}

void move_solids(Step& now) {
    if (!now.solids()) return;
    State& state = now.state;
    const Obstacles obstacles{&state.grid, now.laws.fluid.wall, now.laws.gaps_are_walls,
                              std::sqrt(now.laws.solid.gravity)};
    now.report.substeps = run_substeps(*state.solid, state.stages, now.laws.solid, state.grid, obstacles, now.report.dt,
                                       now.report.solids, now.pool);
    state.walls.merge(now.report.solids.walls);
}

void release_confined(Step& now) {
    State& state = now.state;
    if (!now.solids() || !state.stages.releases || !state.fluid) return;
    const Released released = release_fluid(*state.solid, state.grid, now.laws.fluid, *state.fluid);
    state.released += released.inside;
    state.released_outside += released.outside;
}

void solids_to_nodes(Step& now) {
    if (!now.solids()) return;
    State& state = now.state;
    SolidState& solid = *state.solid;
    observe_particles(state, now.laws, now.report, now.pool);
    if (now.report.outside > 0 || solid.drift > 0.5 * solid.order.slack())
        sort_solids(solid, now.laws.solid, state.grid, now.pool);
    gather(state, now.laws, now.pool);
    keep_for_next_step(state, now.laws, now.report);
}

}  // namespace frana::structured
