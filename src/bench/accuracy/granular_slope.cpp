// SPDX-License-Identifier: Apache-2.0
#include "bench/accuracy/granular_slope.h"

namespace frana::bench {
namespace {

constexpr double k_granular_slope_deg = 22, k_granular_friction_deg = 21, k_granular_time = 5, k_granular_width = 40;
constexpr double k_upper_end = -300, k_lower_end = 300;  // along the slope; no signal returns from there

struct Incline {
    double cosine = std::cos(k_granular_slope_deg * k_degree), sine = std::sin(k_granular_slope_deg * k_degree);
    double celerity = std::sqrt(k_gravity * cosine);
    double drive = k_gravity * (sine - cosine * std::tan(k_granular_friction_deg * k_degree));
};

// Thickness normal to the slope and speed along it, at a place along the slope.
ExactState exact_at(const Incline& incline, double x) {
    const double t = k_granular_time, c = incline.celerity, m = incline.drive, s = x / t - 0.5 * m * t;
    if (s >= 2 * c) return {};
    if (s <= -c) return {1, m * t, 0};
    const double depth = (2 * c - s) * (2 * c - s) / (9 * k_gravity * incline.cosine);
    return {depth, depth * (2.0 / 3.0 * (x / t + c + m * t)), 0};
}

// Mean speed along the slope of the particles that the collapse has not reached.
double block_speed(const Flow& flow, double scale) {
    double sum = 0, n = 0;
    const ParticleSet& particles = flow.particles();
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const double x = particles[Field::x][p] / scale + k_upper_end;
        if (x < -200 || x > -50) continue;
        sum += flow.map_velocity(p).x / scale;
        ++n;
    }
    return sum / n;
}

struct Outcome {
    CaseStatistics statistics;
    double block = 0;
};

Outcome run_once(double cell_size, Scheme scheme, bool map, double jitter) {
    const Incline incline;
    const double scale = map ? incline.cosine : 1;
    const std::int64_t columns = std::llround((k_lower_end - k_upper_end) * scale / cell_size);
    const GridSpec grid = plain_grid(columns, std::llround(k_granular_width / cell_size), cell_size);
    Setup setup;
    setup.bed =
        sample_raster(grid, [&](Point p) { return map ? (grid.east() - p.x) * incline.sine / incline.cosine : 0; });
    setup.seeds = fill_lattice(grid, 2, jitter, [&](Point p) {
        return Seed{p.x / scale + k_upper_end < 0 ? 1 / scale : 0};  // vertical depth in map view
    });
    setup.material = dry_friction(k_granular_friction_deg);
    setup.numerics = numerics_of(scheme, SlopeCorrection::normal, Boundary::wall);
    if (!map) setup.tilt = TiltedGravity{k_gravity * incline.sine, 0, k_gravity * incline.cosine};
    TimedFlow run(setup);
    run.advance_to(k_granular_time);
    const auto along = [&](Point p) { return p.x / scale + k_upper_end; };
    Outcome outcome;
    outcome.statistics = compare_with_exact(
        run,
        [&](Point p) {
            const ExactState state = exact_at(incline, along(p));
            return ExactState{state.depth / scale, state.qx, 0};  // (h / scale) (u scale)
        },
        [&](Point p) { return along(p) >= -200 && along(p) <= 220; });
    outcome.block = block_speed(run.flow(), scale) / (incline.drive * k_granular_time) - 1;
    return outcome;
}

CaseStatistics run_granular(double cell_size, Scheme scheme, bool map) {
    Outcome lattice = run_once(cell_size, scheme, map, 0);
    const Outcome random = run_once(cell_size, scheme, map, 0.8);
    CaseStatistics& statistics = lattice.statistics;
    CaseStatistic depth{"relative L2 of depth", statistics.l2_depth, {}};
    CaseStatistic momentum{"relative L2 of momentum", statistics.l2_momentum, {}};
    if (cell_size == 2.5) {
        depth.mark = 0.010;
        momentum.mark = 0.025;
    }
    statistics.own = {depth,
                      momentum,
                      {"relative L2 of depth, random particles", random.statistics.l2_depth, {}},
                      {"relative L2 of momentum, random particles", random.statistics.l2_momentum, {}},
                      {"random over lattice, depth", random.statistics.l2_depth / statistics.l2_depth, 1.1},
                      {"random over lattice, momentum", random.statistics.l2_momentum / statistics.l2_momentum, 1.1},
                      {"block speed, relative error", lattice.block, 0.002},
                      {"block speed, random particles", random.block, 0.002}};
    return statistics;
}

}  // namespace

std::vector<AccuracyCase> granular_slopes() {
    const std::vector<double> cells{10, 5, 2.5, 1.25};
    return {{"granular-slope", "granular dam break, 22 deg slope, 21 deg friction, tilted gravity", cells, false,
             [](double dx, Scheme scheme) { return run_granular(dx, scheme, false); }},
            {"granular-slope-map", "the same in map view", cells, false,
             [](double dx, Scheme scheme) { return run_granular(dx, scheme, true); }}};
}

}  // namespace frana::bench
