// SPDX-License-Identifier: Apache-2.0
#include "bench/accuracy/solid_cases.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "bench/set_up/solid_block.h"
#include "models/structured/coupling/exchange.h"
#include "models/structured/solid/solid_laws.h"

namespace frana::bench {
namespace {

using structured::PairWork;
using structured::State;

// Cost and error of a case.
class Watch {
  public:
    CaseStatistics statistics(double cell_size, std::size_t particles, double error) const {
        CaseStatistics f;
        f.wall_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
        f.cell_size = cell_size;
        f.particles = static_cast<std::int64_t>(particles);
        f.steps = particles > 0 ? particle_steps / static_cast<std::int64_t>(particles) : 0;
        f.l1_depth = f.l2_depth = f.linf_depth = error;
        return f;
    }
    std::int64_t particle_steps = 0;

  private:
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

CaseStatistics run_pressure_wave(double cell) {
    constexpr double k_wave_length = 20, k_middle = 45, k_time = 0.08, k_speed = 0.01;
    Watch watch;
    ThreadPool pool(1);
    SolidBlock block(cell);
    block.laws.solid.gravity = 0;
    const auto pulse = [](double x) {
        const double s = x / k_wave_length;
        return std::abs(s) < 0.5 ? k_speed * std::pow(std::cos(M_PI * s), 2) : 0;
    };
    const double spacing = block.laws.solid.spacing;
    block.fill(10, 10, std::llround(80 / spacing), std::llround(60 / spacing), [&](Point p) {
        return Seed{2, pulse(p.x - k_middle), 0};
    });
    const auto side = static_cast<std::int64_t>(102 / cell);
    State state = block.start(Raster(plain_grid(side, side, cell), 0.0), pool);
    watch.particle_steps = advance_to(state, block.laws, k_time, pool);
    const ParticleSet& p = state.solid->particles;
    const double c = block.laws.solid.wave_speed;
    double error = 0, size = 0, sum = 0, moment = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (std::abs(p[Field::y][i] - 40) > 5) continue;  // disturbances of the free sides have not reached it
        const double x = p[Field::x][i] - k_middle, u = p[Field::u][i];
        const double exact = 0.5 * (pulse(x - c * k_time) + pulse(x + c * k_time));
        error += std::abs(u - exact);
        size += std::abs(exact);
        if (x < 0 || u < 0) continue;
        sum += u * u;
        moment += u * u * x;
    }
    CaseStatistics f = watch.statistics(cell, p.size(), error / size);
    // The mark: 3 % with twenty particles per wave length.
    f.own = {{"relative error of the wave's speed", moment / sum / k_time / c - 1,
              cell <= 3 ? std::optional(0.03) : std::nullopt}};
    return f;
}

CaseStatistics run_rotation(double cell) {
    constexpr double k_omega = 0.7;
    Watch watch;
    ThreadPool pool(1);
    SolidBlock block(cell);
    const auto n = static_cast<std::int64_t>(std::llround(40 / block.laws.solid.spacing));
    block.fill(20, 20, n, n, [](Point p) { return Seed{2, -k_omega * (p.y - 40), k_omega * (p.x - 40)}; });
    const auto side = static_cast<std::int64_t>(81 / cell);
    State state = block.start(Raster(plain_grid(side, side, cell), 0.0), pool);
    PairWork& w = state.solid->work;
    for (std::int64_t row = 0; row < state.solid->order.rows(); ++row)
        state.stages.pairs->velocity_gradients(state.solid->order, row, block.laws.solid.kernel, w);
    double strain = 0, spin = 0;
    for (std::size_t i = 0; i < state.solid->particles.size(); ++i) {
        const Eigen::Matrix2d l{{w[PairWork::l_xx][i], w[PairWork::l_xy][i]},
                                {w[PairWork::l_yx][i], w[PairWork::l_yy][i]}};
        strain = std::max(strain, structured::strain_rate(l).cwiseAbs().maxCoeff());
        spin = std::max(spin, std::abs(structured::spin(l) - k_omega));
    }
    constexpr int k_steps = 1000;
    Eigen::Matrix2d turned = structured::symmetric(1, 0, 0);
    for (int i = 0; i < k_steps; ++i) turned = structured::rotated(turned, structured::rotation(2 * M_PI / k_steps));
    CaseStatistics f = watch.statistics(cell, state.solid->particles.size(), strain / k_omega);
    f.own = {{"greatest strain rate over angular velocity", strain / k_omega, 1e-12},
             {"relative error of the angular velocity", spin / k_omega, 1e-12},
             {"stress after one turn in 1000 steps", std::hypot(turned(0, 0) - 1, turned(0, 1)), 1e-10}};
    return f;
}

CaseStatistics run_incline(double cell) {
    constexpr double k_time = 2, k_slope = 35;
    Watch watch;
    ThreadPool pool(1);
    const auto slide = [&](double slope_deg) {
        SolidBlock block(cell);
        const double spacing = block.laws.solid.spacing;
        block.fill(30, 30, std::llround(18 / spacing), std::llround(12 / spacing), [](Point) { return Seed{4}; });
        State state = block.start(
            incline(slope_deg, static_cast<std::int64_t>(120 / cell), static_cast<std::int64_t>(72 / cell), cell),
            pool);
        watch.particle_steps += advance_to(state, block.laws, k_time, pool);
        return state;
    };
    const double theta = k_slope * M_PI / 180, friction = std::tan(28 * M_PI / 180);
    const double exact = k_time * 9.81 * (std::sin(theta) - std::cos(theta) * friction) * std::cos(theta);
    const State sliding = slide(k_slope), resting = slide(27.9);
    double error = 0, moved = 0;
    const ParticleSet& p = sliding.solid->particles;
    for (std::size_t i = 0; i < p.size(); ++i) {
        error = std::max(error, std::abs(p[Field::u][i] / exact - 1));
        moved = std::max(moved, std::abs(resting.solid->particles[Field::u][i]));
    }
    CaseStatistics f = watch.statistics(cell, p.size(), error);
    f.own = {{"relative speed error on 35 degrees", error, 1e-9}, {"speed on 27.9 degrees [m/s]", moved, 0}};
    return f;
}

CaseStatistics run_drag(double dt) {
    constexpr double k_time = 10;
    Watch watch;
    double worst = 0;
    for (const int exponent : {1, 2}) {
        structured::CouplingLaws laws;
        laws.virtual_mass.law = structured::VirtualMassLaw::none;
        laws.drag.exponent = exponent;
        laws.drag.smoothing_velocity = 10;
        structured::CellPhases cell;
        cell.solids = cell.free = 0.5;
        cell.coupled_mass = 1200;
        cell.free_velocity = {2, 0};
        structured::Mixture m;
        m.solids = m.coupled = 0.5;
        m.coupled_density = m.grain_density = 2400;
        const double lambda = laws.drag(m) * (1 / 1200.0 + 1 / 500.0);
        for (double t = 0; t < k_time - 0.5 * dt; t += dt) {
            const Eigen::Vector2d impulse = exchange(laws, cell, dt);
            cell.coupled_velocity.x() += impulse.x() / 1200;
            cell.free_velocity.x() -= impulse.x() / 500;
        }
        const double exact = exponent == 1 ? 2 * std::exp(-lambda * k_time) : 2 / (1 + 2 * lambda * k_time);
        worst = std::max(worst, std::abs((cell.free_velocity.x() - cell.coupled_velocity.x()) / exact - 1));
    }
    CaseStatistics f = watch.statistics(dt, 1, worst);
    f.own = {{"relative error of the relative velocity", worst, 1e-12}};
    return f;
}

}  // namespace

std::vector<AccuracyCase> solid_cases() {
    const auto of = [](CaseStatistics (*run)(double)) { return [run](double size, Scheme) { return run(size); }; };
    std::vector<AccuracyCase> cases{
        {"p-wave", "pressure wave in structured solids", {12, 6, 3, 1.5}, false, of(run_pressure_wave)},
        {"rigid-rotation", "structured solids that turn as a whole", {12, 6, 3, 1.5}, true, of(run_rotation)},
        {"incline-block",
         "structured block on an incline, sliding and at rest",
         {12, 6, 3, 1.5},
         true,
         of(run_incline)},
        {"drag-relaxation",
         "drag in a still cell; the cell size is the time step [s]",
         {10, 1, 0.1, 0.01},
         true,
         of(run_drag)}};
    for (AccuracyCase& one : cases) one.one_scheme = true;
    return cases;
}

}  // namespace frana::bench
