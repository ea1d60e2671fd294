// SPDX-License-Identifier: Apache-2.0
#include "models/structured/solid/solid_state.h"

#include <algorithm>
#include <cmath>

#include "models/structured/solid/material_update.h"
#include "models/structured/solid/rest.h"
#include "models/structured/solid/transfer.h"

namespace frana::structured {
namespace {

template <class Kind>
SolidStages stages_of() {
    SolidStages stages;
    stages.update_material = update_material<Kind>;
    stages.solids_to_nodes = solids_to_nodes<Kind>;
    stages.nodes_to_solids = nodes_to_solids<Kind>;
    return stages;
}

// Runs a task over all rows of cells, with a report of each, merged in their order.
template <class Task>
SolidReport over_rows(const CellOrder& order, ThreadPool& pool, const Task& task) {
    std::vector<SolidReport> reports(static_cast<std::size_t>(order.rows()));
    pool.for_each(reports.size(), [&](std::size_t row) { reports[row] = task(static_cast<std::int64_t>(row)); });
    SolidReport all;
    for (const SolidReport& report : reports) all.merge(report);
    return all;
}

void load_work(SolidState& state, ThreadPool& pool) {
    constexpr std::size_t k_block = 16384;
    state.work.resize(state.particles.size());
    pool.for_blocks(state.particles.size(), k_block, [&](std::size_t begin, std::size_t end) {
        const std::pair<Field, PairWork::Array> copied[] = {{Field::x, PairWork::x},
                                                            {Field::y, PairWork::y},
                                                            {Field::u, PairWork::u},
                                                            {Field::v, PairWork::v},
                                                            {Field::area, PairWork::area}};
        for (const auto& [field, array] : copied)
            std::copy(state.particles[field] + begin, state.particles[field] + end, state.work[array] + begin);
    });
}

}  // namespace

bool fits(const SolidState& state) {
    constexpr double k_anywhere = 1e12;  // [m]: what is farther off has no node that can be counted
    const std::size_t count = state.particles.size();
    const bool unused = state.order.rows() == 0 && count == 0;
    for (const std::vector<double>& array : state.work.arrays) {
        if (array.size() != count + PairWork::k_padding && !(unused && array.empty())) return false;
    }
    for (const Field field : {Field::x, Field::y}) {
        const double* const place = state.particles[field];
        if (!std::all_of(place, place + count, [](double x) { return std::abs(x) < k_anywhere; })) return false;
    }
    return state.order.orders(count);
}

SolidStages choose_solid_stages(bool cohesive, bool wet, bool fast) {
    SolidStages stages = cohesive ? (wet ? stages_of<SolidKind<true, true>>() : stages_of<SolidKind<true, false>>())
                                  : (wet ? stages_of<SolidKind<false, true>>() : stages_of<SolidKind<false, false>>());
    stages.fields = solid_fields(cohesive, wet);
    stages.pairs = fast ? &pair_kernels() : &plain_pair_kernels();
    stages.releases = cohesive && wet;
    return stages;
}

void sort_solids(SolidState& state, const SolidLaws& laws, const NodeGrid& grid, ThreadPool& pool) {
    ParticleSet& particles = state.particles;
    std::vector<std::uint8_t> keep;
    double px = 0, py = 0, mass = 0;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const double x = particles[Field::x][p], y = particles[Field::y][p];
        const double u = particles[Field::u][p], v = particles[Field::v][p], solids = particles[Field::volume][p];
        const double confined = particles[Field::confined] ? particles[Field::confined][p] : 0;
        const double m = particles[Field::grain_density][p] * solids + laws.basal.fluid_density * confined;
        if (grid.bounds().holds(x, y)) {
            mass += m;
            px += m * u;
            py += m * v;
            continue;
        }
        if (keep.empty()) keep.assign(particles.size(), 1);
        keep[p] = 0;
        state.left.solids += solids;
        state.left.confined += confined;
        state.left.mass += m;
        state.left.px += m * u;
        state.left.py += m * v;
    }
    state.order.sort(particles, keep, pool);
    state.mean = mass > 0 ? Point{px / mass, py / mass} : Point{};
    state.drift = state.moved = 0;
    load_work(state, pool);
}

double stable_substep(const SolidState& state, const SolidLaws& laws) {
    constexpr double k_viscous = 0.4, k_force = 0.25;
    const double length = laws.kernel.length();
    const double sound = state.elastic ? laws.viscosity.sound : state.sound;
    const double elastic =
        state.elastic ? laws.elastic_cfl * length / laws.wave_speed : std::numeric_limits<double>::infinity();
    const double viscous =
        k_viscous * length /
        (sound + 0.6 * (laws.viscosity.linear * sound + laws.viscosity.quadratic * state.last.approach));
    const double force = k_force * std::sqrt(length / std::max(std::sqrt(state.last.acceleration2), laws.gravity));
    return std::min({elastic, viscous, force});
}

int run_substeps(SolidState& state, const SolidStages& stages, const SolidLaws& laws, const NodeGrid& grid,
                 const Obstacles& obstacles, double dt, SolidReport& seen, ThreadPool& pool) {
    constexpr double k_least_share = 1e-6;  // of a step in a substep; elastic waves take some hundred
    // As wide as the nodes see a lone particle: with cubic splines 1 / sum N^2 is at most 4.8 cells.
    const double widest = 5 * grid.cell_size() * grid.cell_size();
    int count = 0;
    Rest rest;
    rest.begin(state.order, state.work);
    // Runs of awake cells of a row.
    const auto over_awake = [&](std::int64_t row, const auto& task) {
        for (std::int64_t column = 0; column < state.order.columns(); ++column) {
            if (Rest::asleep(state.work, rest.index(row, column))) continue;
            ParticleRun run = state.order.cell(row, column);
            while (column + 1 < state.order.columns() && !Rest::asleep(state.work, rest.index(row, column + 1)))
                run.end = state.order.cell(row, ++column).end;
            if (run.begin < run.end) task(run);
        }
    };
    for (double left = dt; left > 0; ++count) {
        const double stable = stable_substep(state, laws);
        if (!(stable > k_least_share * dt)) {  // a speed or force that is none
            ++seen.non_finite;
            break;
        }
        // Equal substeps for what is left, so that no sliver remains.
        const double part = left / std::ceil(left / stable * (1 - 1e-12));
        if (state.drift + part * std::sqrt(state.last.apart2) > 0.5 * state.order.slack()) {
            sort_solids(state, laws, grid, pool);
            rest.begin(state.order, state.work);
        }
        over_rows(state.order, pool, [&](std::int64_t row) {
            stages.pairs->velocity_gradients(state.order, row, laws.kernel, state.work);
            over_awake(row,
                       [&](ParticleRun run) { stages.update_material(run, part, laws, state.particles, state.work); });
            return SolidReport{};
        });
        const SolidReport pairs = over_rows(state.order, pool, [&](std::int64_t row) {
            SolidReport report;
            report.approach = stages.pairs->accelerations(state.order, row, laws, state.work);
            return report;
        });
        state.last = over_rows(state.order, pool, [&](std::int64_t row) {
            SolidReport report;
            for (std::int64_t column = 0; column < state.order.columns(); ++column) {
                const std::size_t cell = rest.index(row, column);
                const ParticleRun run = state.order.cell(row, column);
                if (run.begin < run.end && !Rest::asleep(state.work, cell))
                    rest.see(cell,
                             move_particles(run, part, obstacles, widest, state.mean, state.particles, state.work));
                else if (run.begin == run.end)
                    rest.see(cell, {});
                else
                    report.slept += static_cast<std::int64_t>(run.end - run.begin);
                report.merge(rest.seen(cell));
            }
            return report;
        });
        if (laws.sleeps) rest.end_substep(state.work);
        state.last.approach = pairs.approach;
        state.drift += part * std::sqrt(state.last.apart2);
        state.moved += part * std::sqrt(state.last.speed2);
        seen.merge(state.last);
        left = left - part > 1e-9 * dt ? left - part : 0;
        if (state.last.non_finite > 0) return state.work.asleep.clear(), count + 1;
    }
    state.work.asleep.clear();
    return count;
}

void gather_solids(SolidState& state, const SolidStages& stages, const SolidLaws& laws, const NodeGrid& grid,
                   ThreadPool& pool) {
    SolidNodes& nodes = state.nodes;
    nodes.clear(nodes.box, grid.stride(), pool);
    const NodeScale scale = grid.scale();
    const double dx = scale.dx;
    const Bounds bounds = state.order.bounds();
    // Two nodes on either side of a particle.
    const auto index = [&](double place, double steps, std::int64_t origin, std::int64_t count) {
        return std::clamp<std::int64_t>(static_cast<std::int64_t>(std::floor(place / dx - 0.5 + steps)) + origin, 0,
                                        count);
    };
    nodes.box = {index(bounds.west - state.moved, -1, scale.origin_x, grid.stride()),
                 index(bounds.east + state.moved, 3, scale.origin_x, grid.stride()),
                 index(bounds.south - state.moved, -1, scale.origin_y, grid.padded_rows()),
                 index(bounds.north + state.moved, 3, scale.origin_y, grid.padded_rows())};
    nodes.clear(nodes.box, grid.stride(), pool);
    // Strips of rows, every second at a time: what lies between is wider than the nodes that two strips could
    // share.
    const auto strip = static_cast<std::int64_t>(std::ceil((4 * dx + state.order.slack()) / state.order.side()));
    const std::int64_t strips = (state.order.rows() + strip - 1) / strip;
    for (std::int64_t parity = 0; parity < 2; ++parity) {
        pool.for_each(static_cast<std::size_t>((strips - parity + 1) / 2), [&](std::size_t k) {
            const std::int64_t first = (2 * static_cast<std::int64_t>(k) + parity) * strip;
            const std::int64_t last = std::min(first + strip, state.order.rows()) - 1;
            stages.solids_to_nodes(state.order.whole_rows(first, last), laws, state.particles, grid, nodes);
        });
    }
}

}  // namespace frana::structured
