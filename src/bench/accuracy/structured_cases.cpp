// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>

#include "bench/accuracy/accuracy_case.h"
#include "bench/exact/solutions.h"
#include "bench/set_up/solid_block.h"
#include "models/structured/coupling/exchange.h"
#include "models/structured/fluid/fluid_step.h"
#include "models/structured/solid/solid_laws.h"

namespace frana::bench {
namespace {

/// A free fluid on its grid with a timer, one thread: no friction, gentle slopes, walls on all sides.
class FluidRun {
  public:
    /// @param at depth and momentum at the start, local metres
    FluidRun(const Raster& bed, double dry_depth, const std::function<ExactState(Point)>& at);

    void advance(double time);
    [[nodiscard]] Flow::NodalFields fields() const;
    /// Returns the errors against an exact solution, with the cost of the run; `particles` counts the grid's cells.
    [[nodiscard]] CaseStatistics compare(const std::function<ExactState(Point)>& exact,
                                         const std::function<bool(Point)>& inside = {}) const;

  private:
    GridSpec grid_;
    NodeGrid nodes_;
    structured::FluidLaws laws_;
    structured::FluidState state_;
    ThreadPool pool_{1};
    std::int64_t steps_ = 0, non_finite_ = 0;
    double seconds_ = 0;
};

structured::FluidLaws plain_laws(double dry_depth) {
    structured::FluidLaws laws;
    laws.gravity = k_gravity;
    laws.dry = dry_depth;
    laws.steep = false;
    laws.wall = true;
    return laws;
}

FluidRun::FluidRun(const Raster& bed, double dry_depth, const std::function<ExactState(Point)>& at)
    : grid_(bed.grid), nodes_(bed), laws_(plain_laws(dry_depth)), state_(nodes_, laws_) {
    std::vector<structured::FluidSource> sources;
    for (std::int64_t j = 0; j < nodes_.rows(); ++j) {
        for (std::int64_t i = 0; i < nodes_.columns(); ++i) {
            const ExactState s = at(
                {(static_cast<double>(i) + 0.5) * grid_.cell_size, (static_cast<double>(j) + 0.5) * grid_.cell_size});
            if (s.depth > 0) sources.push_back({nodes_.index(i, j), s.depth, s.qx, s.qy});
        }
    }
    structured::receive(sources, state_, laws_);
}

void FluidRun::advance(double time) {
    const auto begin = std::chrono::steady_clock::now();
    const structured::FluidReport report = structured::advance(state_, laws_, {}, time, pool_);
    seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    steps_ += report.steps;
    non_finite_ += report.non_finite;
}

Flow::NodalFields FluidRun::fields() const {
    Flow::NodalFields fields{Raster(grid_), Raster(grid_), Raster(grid_)};
    for (std::int64_t row = 0; row < grid_.rows; ++row) {
        for (std::int64_t column = 0; column < grid_.columns; ++column) {
            const std::size_t cell = nodes_.index(column, grid_.rows - 1 - row);
            fields.depth.at(row, column) = state_.now.depth[cell];
            fields.momentum_x.at(row, column) = state_.now.qx[cell];
            fields.momentum_y.at(row, column) = state_.now.qy[cell];
        }
    }
    return fields;
}

CaseStatistics FluidRun::compare(const std::function<ExactState(Point)>& exact,
                                 const std::function<bool(Point)>& inside) const {
    CaseStatistics statistics = compare_fields(fields(), exact, inside);
    statistics.particles = grid_.cell_count();
    statistics.steps = steps_;
    statistics.wall_seconds = seconds_;
    if (non_finite_ > 0) statistics.error = "values became non-finite";
    return statistics;
}

constexpr double k_pi = 180 * k_degree;

// The same channel as the first model's stoker and ritter: 1000 m, the dam in the middle, 10 m of water, 20
// s.
CaseStatistics run_fluid_channel(double cell_size, double right) {
    constexpr double k_length = 1000, k_dam = 500, k_left = 10, k_time = 20;
    const GridSpec grid = plain_grid(std::llround(k_length / cell_size), 3, cell_size);
    FluidRun run(Raster(grid, 0.0), 1e-6, [&](Point p) { return ExactState{p.x < k_dam ? k_left : right}; });
    run.advance(k_time);
    const DamBreak exact(k_left, right, k_gravity);
    CaseStatistics statistics = run.compare([&](Point p) {
        const WaterState state = exact.at(p.x - k_dam, k_time);
        return ExactState{state.depth, state.depth * state.velocity, 0};
    });
    // The mark: 2 % at 400 cells; the case's 2.5 m.
    statistics.own = {
        {"relative depth error", statistics.l1_depth, cell_size <= 2.5 ? std::optional(0.02) : std::nullopt}};
    return statistics;
}

// A lake around an island on a bed with a step, 10 s.
CaseStatistics run_fluid_lake(double cell_size) {
    constexpr double k_side = 10, k_level = 10;
    const auto cells = static_cast<std::int64_t>(std::llround(k_side / cell_size));
    const Raster bed = sample_raster(plain_grid(cells, cells, cell_size), [](Point p) {
        const double x = p.x - 5, y = p.y - 5;
        return 13 * std::exp(-0.4 * (x * x + y * y)) + (p.x > 7 ? 4 : 0);
    });
    const auto still = [&](Point p) {
        const auto row = bed.grid.rows - 1 - static_cast<std::int64_t>(p.y / cell_size);
        return ExactState{std::max(0.0, k_level - bed.at(row, static_cast<std::int64_t>(p.x / cell_size)))};
    };
    FluidRun run(bed, 1e-4, still);
    run.advance(10);
    CaseStatistics statistics = run.compare(still);
    const Flow::NodalFields fields = run.fields();
    double momentum = 0;
    for (const Raster* field : {&fields.momentum_x, &fields.momentum_y})
        for (const double q : field->values) momentum = std::max(momentum, std::abs(q));
    statistics.own = {{"greatest |h - h0| [m]", statistics.linf_depth, 1e-10},
                      {"greatest |hu|, |hv| [m2/s]", momentum, 1e-10}};
    return statistics;
}

// A simple wave that travels to the right and steepens (Riemann): u = 2 (c - c0), and each c travels with u + c. Smooth
// until it breaks, after 18 s.
class SimpleWave {
  public:
    [[nodiscard]] ExactState at(double x, double t) const {
        // Start of the characteristic through (x, t): x0 + (3 c(x0) - 2 c0) t = x, rising in x0.
        double low = x - 10 * t - 1, high = x;
        for (int i = 0; i < 100; ++i) {
            const double middle = 0.5 * (low + high);
            (middle + (3 * celerity(middle) - 2 * k_c0) * t < x ? low : high) = middle;
        }
        const double c = celerity(0.5 * (low + high)), depth = c * c / k_gravity;
        return {depth, depth * 2 * (c - k_c0), 0};
    }

  private:
    static constexpr double k_c0 = 3.132091952673165;  // sqrt(9.81 * 1 m)
    static double celerity(double x) {
        const double r = (x - 60) / 15;
        return k_c0 * (1 + 0.1 * std::exp(-r * r));
    }
};

CaseStatistics run_fluid_wave(double cell_size) {
    constexpr double k_length = 200, k_time = 10;
    const SimpleWave exact;
    FluidRun run(Raster(plain_grid(std::llround(k_length / cell_size), 3, cell_size), 0.0), 1e-6,
                 [&](Point p) { return exact.at(p.x, 0); });
    run.advance(k_time);
    const auto inside = [](Point p) { return p.x > 40 && p.x < 160; };
    CaseStatistics statistics = run.compare([&](Point p) { return exact.at(p.x, k_time); }, inside);
    statistics.own = {{"greatest depth error [m]", statistics.linf_depth, {}}};
    return statistics;
}

// The planar oscillation of the first model's thacker, three periods.
CaseStatistics run_fluid_thacker(double cell_size) {
    constexpr double k_deep = 10, k_radius = 100, k_swing = 20, k_side = 400;
    const double w = std::sqrt(2 * k_gravity * k_deep) / k_radius;
    const std::int64_t cells = std::llround(k_side / cell_size);
    const auto radius2 = [](Point p, double middle) {
        const double x = p.x - middle, y = p.y - 0.5 * k_side;
        return (x * x + y * y) / (k_radius * k_radius);
    };
    const Raster bed = sample_raster(plain_grid(cells, cells, cell_size),
                                     [&](Point p) { return k_deep * (radius2(p, 0.5 * k_side) - 1); });
    // After whole periods the water is in its initial state.
    const auto exact = [&](Point p) {
        const double depth = std::max(0.0, k_deep * (1 - radius2(p, 0.5 * k_side + k_swing)));
        return ExactState{depth, 0, depth * k_swing * w};
    };
    FluidRun run(bed, 1e-4, exact);
    run.advance(3 * 2 * k_pi / w);
    CaseStatistics statistics = run.compare(exact);
    const CaseStatistics core = run.compare(exact, [&](Point p) { return radius2(p, 0.5 * k_side + k_swing) < 0.5; });
    statistics.own = {{"relative depth error away from the shore", core.l1_depth, {}}};
    return statistics;
}

AccuracyCase fluid_case(const char* name, const char* what, std::vector<double> cells, CaseStatistics (*run)(double)) {
    return {name, what, std::move(cells), false, [run](double dx, Scheme) { return run(dx); }, true};
}

}  // namespace

/// The structured model's free fluid: fluid-lake, fluid-stoker, fluid-ritter, fluid-wave (a smooth simple wave) and
/// fluid-thacker, each against its exact solution.
std::vector<AccuracyCase> fluid_cases() {
    std::vector<AccuracyCase> cases{
        fluid_case("fluid-lake", "free fluid: lake round an island, 10 s", {0.5, 0.4, 0.25, 0.2}, run_fluid_lake),
        fluid_case("fluid-stoker", "free fluid: dam break, 10 m over 2 m, 20 s", {10, 5, 2.5, 1.25, 0.625},
                   [](double dx) { return run_fluid_channel(dx, 2); }),
        fluid_case("fluid-ritter", "free fluid: dam break, 10 m over dry ground, 20 s", {10, 5, 2.5, 1.25, 0.625},
                   [](double dx) { return run_fluid_channel(dx, 0); }),
        fluid_case("fluid-wave", "free fluid: simple wave before it breaks, 10 s", {4, 2, 1, 0.5, 0.25},
                   run_fluid_wave),
        fluid_case("fluid-thacker", "free fluid: planar swing in a paraboloid, three periods", {20, 10, 5, 2.5},
                   run_fluid_thacker)};
    cases.front().rounding = true;
    return cases;
}

namespace {

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
    ParticleSet& p = state.solid->particles;
    structured::StressNodes& nodes = state.solid->stress;
    nodes.begin();
    for (std::size_t i = 0; i < p.size(); ++i) {
        p[Field::c_xy][i] = -k_omega;
        p[Field::c_yx][i] = k_omega;
        nodes.add_momentum(p, i, p[Field::volume][i], true);
    }
    double strain = 0, spin = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const Eigen::Matrix2d l = nodes.velocity_gradient(nodes.at(p[Field::x][i], p[Field::y][i]), true);
        strain = std::max(strain, structured::strain_rate(l).cwiseAbs().maxCoeff());
        spin = std::max(spin, std::abs(structured::spin(l) - k_omega));
    }
    constexpr int k_steps = 1000;
    Eigen::Matrix2d turned = structured::symmetric(1, 0, 0);
    for (int i = 0; i < k_steps; ++i) turned = structured::rotated(turned, structured::rotation(2 * M_PI / k_steps));
    CaseStatistics f = watch.statistics(cell, p.size(), strain / k_omega);
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
        laws.virtual_mass.acts = false;
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

/// The structured model's solids against exact solutions. `l1_depth` contains each case's own error, relative:
///   p-wave           velocity of a pulse in a wide sheet against d'Alembert's, sqrt((K + 4 G / 3) / rho)
///   rigid-rotation   greatest strain rate over the angular velocity, of a rigidly rotating sheet; stress after
///                    a turn
///   incline-block    speed of a dry block after 2 s on 35 degrees; displacement of one on 27.9, with phi = 28
///   drag-relaxation  relative velocity of solids and fluid in a still cell, linear and quadratic drag
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
