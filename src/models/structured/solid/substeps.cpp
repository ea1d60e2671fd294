// SPDX-License-Identifier: Apache-2.0
// The substeps of the solids in a step.
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "models/structured/solid/rest.h"
#include "models/structured/solid/solid_state.h"

namespace frana::structured {
namespace {

// Runs a task over all rows of cells; the reports of the rows are merged in their order.
template <class Task>
SolidReport over_rows(const CellOrder& order, ThreadPool& pool, const Task& task) {
    std::vector<SolidReport> reports(static_cast<std::size_t>(order.rows()));
    pool.for_each(reports.size(), [&](std::size_t row) { reports[row] = task(static_cast<std::int64_t>(row)); });
    SolidReport all;
    for (const SolidReport& report : reports) all.merge(report);
    return all;
}

// The substeps of one step; cells at rest are skipped (Rest).
class Substeps {
  public:
    Substeps(SolidState& state, const SolidStages& stages, const SolidLaws& laws, const NodeGrid& grid,
             const Obstacles& obstacles, ThreadPool& pool)
        : state_(state), stages_(stages), laws_(laws), grid_(grid), obstacles_(obstacles), pool_(pool) {
        if (!state_.work.near.of(state_.particles.size())) find_neighbours(state_, pool_);  // of a state that was read
        begin_rest();
    }
    ~Substeps() { state_.work.resting.clear(); }
    Substeps(const Substeps&) = delete;
    Substeps& operator=(const Substeps&) = delete;

    void sort_where_drifted(double dt) {
        if (!(state_.drift + dt * std::sqrt(state_.last.apart2) > 0.5 * state_.order.slack())) return;
        sort_solids(state_, laws_, grid_, pool_);
        begin_rest();
    }

    void strain_and_stress(double dt) {
        over_rows(state_.order, pool_, [&](std::int64_t row) {
            stages_.pairs->velocity_gradients(state_.order, row, laws_.kernel, state_.work);
            over_awake(
                row, [&](ParticleRun run) { stages_.update_material(run, dt, laws_, state_.particles, state_.work); });
            return SolidReport{};
        });
    }

    void spread_damage() {
        weaker_.clear();
        const double* const strain = state_.work[PairWork::strain];
        if (std::none_of(strain, strain + state_.particles.size(), [](double s) { return s > 0; })) return;
        weaker_ = state_.spread(state_.order, laws_.fragmentation, state_.particles, state_.work, pool_);
    }

    void accelerations() {
        const SolidReport pairs = over_rows(state_.order, pool_, [&](std::int64_t row) {
            SolidReport report;
            report.approach = stages_.pairs->accelerations(state_.order, row, laws_, state_.work);
            return report;
        });
        approach_ = pairs.approach;
    }

    void move(double dt) {
        state_.last = over_rows(state_.order, pool_, [&](std::int64_t row) {
            SolidReport report;
            for (std::int64_t column = 0; column < state_.order.columns(); ++column) {
                const std::size_t cell = rest_.index(row, column);
                const ParticleRun run = state_.order.cell(row, column);
                if (run.begin == run.end)
                    rest_.record(cell, {});
                else if (Rest::resting(state_.work, cell))
                    report.skipped += static_cast<std::int64_t>(run.end - run.begin);
                else
                    rest_.record(
                        cell, move_particles(run, dt, obstacles_, widest_, state_.mean, state_.particles, state_.work));
                report.merge(rest_.report_of(cell));
            }
            return report;
        });
        rest_.wake(weaker_);
        if (laws_.skips_rest) rest_.end_substep(state_.work);
        state_.last.approach = approach_;
        state_.drift += dt * std::sqrt(state_.last.apart2);
        state_.moved += dt * std::sqrt(state_.last.speed2);
    }

  private:
    void begin_rest() {
        rest_.begin(state_.order, state_.work, laws_.skips_rest, pool_,
                    [&](ParticleRun run) { return stages_.still_report(run, laws_, state_.mean, state_.particles); });
    }
    // Runs of active cells of a row.
    template <class Task>
    void over_awake(std::int64_t row, const Task& task) const {
        const auto resting = [&](std::int64_t column) { return Rest::resting(state_.work, rest_.index(row, column)); };
        for (std::int64_t column = 0; column < state_.order.columns(); ++column) {
            if (resting(column)) continue;
            ParticleRun run = state_.order.cell(row, column);
            while (column + 1 < state_.order.columns() && !resting(column + 1))
                run.end = state_.order.cell(row, ++column).end;
            if (run.begin < run.end) task(run);
        }
    }

    SolidState& state_;
    const SolidStages& stages_;
    const SolidLaws& laws_;
    const NodeGrid& grid_;
    const Obstacles& obstacles_;
    ThreadPool& pool_;
    Rest rest_;
    std::vector<std::uint8_t> weaker_;  // by cell of the order: whether cohesion was lost in this substep
    double approach_ = 0;               // of the last accelerations
    // Width of a lone particle on the nodes: with cubic splines 1 / sum N^2 is at most 4.8 cells.
    double widest_ = 5 * grid_.cell_size() * grid_.cell_size();
};

}  // namespace

double stable_substep(const SolidState& state, const SolidLaws& laws) {
    constexpr double k_viscous = 0.8, k_force = 0.25;
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
                 const Obstacles& obstacles, double dt, SolidReport& maxima, ThreadPool& pool) {
    constexpr double k_least_fraction = 1e-6;  // least stable fraction of a step; elastic waves need some hundred
    Substeps now(state, stages, laws, grid, obstacles, pool);
    int count = 0;
    for (double left = dt; left > 0 && maxima.non_finite == 0; ++count) {
        const double stable = stable_substep(state, laws);
        if (!(stable > k_least_fraction * dt)) {  // a non-finite speed or force
            ++maxima.non_finite;
            break;
        }
        // Equal substeps for the remaining time, so that none is tiny.
        const double part = left / std::ceil(left / stable * (1 - 1e-12));
        now.sort_where_drifted(part);
        now.strain_and_stress(part);  // grad u; dA/dt = A tr(grad u); stress, its return to the yield surface, damage
        now.spread_damage();          // damage and cohesion: average over R of what yielding strained
        now.accelerations();          // m a = sum over neighbours of stress and artificial viscosity
        now.move(part);               // u += dt (a + push), less bed friction; x += dt u
        maxima.merge(state.last);
        left = left - part > 1e-9 * dt ? left - part : 0;
    }
    return count;
}

}  // namespace frana::structured
