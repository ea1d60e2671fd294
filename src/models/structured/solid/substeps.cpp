// SPDX-License-Identifier: Apache-2.0
// The substeps of the solids in a step.
#include <algorithm>
#include <cmath>
#include <vector>

#include "models/structured/solid/column_state.h"
#include "models/structured/solid/solid_state.h"

namespace frana::structured {
namespace {

class Substeps {
  public:
    Substeps(SolidState& state, const SolidStages& stages, const SolidLaws& laws, const NodeGrid& grid,
             const Obstacles& obstacles, ThreadPool& pool)
        : state_(state), stages_(stages), laws_(laws), grid_(grid), obstacles_(obstacles), pool_(pool) {}

    void sort_where_drifted(double dt) {
        if (state_.drift + dt * std::sqrt(state_.last.apart2) > 0.5 * state_.order.slack())
            sort_solids(state_, laws_, grid_, pool_);
    }

    void momenta() {
        state_.stress.begin();
        const double* const ratio = state_.particles[Field::cohesion_ratio];
        double* const bonds = state_.work[SolidWork::bonds];
        over_strips([&](ParticleRun run) {
            for (std::size_t p = run.begin; p < run.end; ++p) {
                if (bonds[p] > 0 && !(ratio[p] > 0)) bonds[p] = 0;
                state_.stress.add_momentum(state_.particles, p, particle_mass(laws_, state_.particles, p),
                                           bonds[p] > 0);
            }
        });
    }

    void strain_and_stress(double dt) {
        over_strips([&](ParticleRun run) {
            stages_.update_material(run, dt, laws_, state_.stress, state_.particles, state_.work);
        });
    }

    void spread_damage() {
        const double* const strain = state_.work[SolidWork::strain];
        if (std::any_of(strain, strain + state_.particles.size(), [](double s) { return s > 0; }))
            state_.spread(state_.order, laws_.fragmentation, state_.particles, state_.work, pool_);
    }

    void move(double dt) {
        std::vector<SolidReport> rows(static_cast<std::size_t>(state_.order.rows()));
        pool_.for_each(rows.size(), [&](std::size_t r) {
            const auto row = static_cast<std::int64_t>(r);
            rows[r] = move_particles(state_.order.whole_rows(row, row), dt, laws_.wave_cfl, obstacles_, widest_,
                                     state_.mean, state_.stress, state_.work, state_.particles);
        });
        state_.last = {};
        for (const SolidReport& report : rows) state_.last.merge(report);
        state_.drift += dt * std::sqrt(state_.last.apart2);
        state_.moved += dt * std::sqrt(state_.last.speed2);
    }

  private:
    template <class Task>
    void over_strips(const Task& task) {
        state_.order.for_each_strip(4 * state_.stress.side(), pool_, task);
    }

    SolidState& state_;
    const SolidStages& stages_;
    const SolidLaws& laws_;
    const NodeGrid& grid_;
    const Obstacles& obstacles_;
    ThreadPool& pool_;
    // Width of a lone particle on the nodes: with cubic splines 1 / sum N^2 is at most 4.8 cells.
    double widest_ = 5 * grid_.cell_size() * grid_.cell_size();
};

}  // namespace

double stable_substep(const SolidState& state, const SolidLaws& laws) {
    constexpr double k_force = 0.28;
    const double wave = state.elastic ? std::max(laws.wave_speed, state.sound) : state.sound;
    const double acceleration = std::max(std::sqrt(state.last.acceleration2), laws.gravity);
    return std::min({laws.wave_cfl * laws.side / wave, k_force * std::sqrt(laws.side / acceleration),
                     0.25 * k_greatest_growth / state.last.opening});
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
        const bool rested = count > 0 && state.last.rests;
        now.sort_where_drifted(part);
        now.momenta();  // v = sum m w (u + C (x_i - x)) / sum m w, of loose and of bonded particles
        now.strain_and_stress(
            part);            // L = sum v grad w; stress, returned to the yield surface; f = -sum V sigma grad w
        now.spread_damage();  // damage and cohesion: average over R of what yielding strained
        now.move(part);       // x += dt sum w v; u = sum w v + dt (sum w f / m + push), less bed friction; A, C
        maxima.merge(state.last);
        left = left - part > 1e-9 * dt ? left - part : 0;
        if (rested && state.last.rests) left = 0;  // the next would change nothing
    }
    return count;
}

}  // namespace frana::structured
