// SPDX-License-Identifier: Apache-2.0
#include "bench/accuracy/sliding_block.h"

#include <algorithm>

namespace frana::bench {
namespace {

constexpr double k_slab_middle = 120, k_window = 20;
constexpr std::int64_t k_rows = 8;

double middle_speed(const Flow& flow, double middle) {
    const ParticleSet& particles = flow.particles();
    double sum = 0, n = 0;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        if (std::abs(particles[Field::x][p] - middle) > k_window) continue;
        sum += flow.map_velocity(p).x;
        ++n;
    }
    return sum / n;
}

// Acceleration of a rigid block in map view [m/s2].
double acceleration(double slope_deg, double friction_deg) {
    const double cosine = std::cos(slope_deg * k_degree);
    return k_gravity * cosine * cosine * (std::tan(slope_deg * k_degree) - std::tan(friction_deg * k_degree));
}

SlabOutcome slide(double cell_size, Scheme scheme, double slope_deg) {
    constexpr double k_friction_deg = 20, k_time = 4;
    const double a = acceleration(slope_deg, k_friction_deg);
    const Slab slab{slope_deg, dry_friction(k_friction_deg), 0, k_time, 0.5 * a * k_time * k_time, a * k_time};
    return run_slab(cell_size, scheme, slab, [a](double t) { return 0.5 * a * t * t; });
}

// Relative error of the distance to rest.
double stopping_error(double cell_size, Scheme scheme) {
    constexpr double k_slope_deg = 10, k_friction_deg = 25, k_speed = 10;
    const double a = -acceleration(k_slope_deg, k_friction_deg), until = k_speed / a;
    const double distance = 0.5 * k_speed * until;
    const Slab slab{k_slope_deg, dry_friction(k_friction_deg), k_speed, 1.5 * until, distance, 0};
    const SlabOutcome outcome = run_slab(cell_size, scheme, slab, [=](double t) {
        const double moving = std::min(t, until);
        return k_speed * moving - 0.5 * a * moving * moving;
    });
    return outcome.distance / distance - 1;
}

CaseStatistics run_sliding(double cell_size, Scheme scheme) {
    CaseStatistics statistics;
    std::vector<CaseStatistic> own;
    for (const double slope_deg : {25.0, 35.0, 45.0}) {
        const SlabOutcome outcome = slide(cell_size, scheme, slope_deg);
        const double exact = 4 * acceleration(slope_deg, 20);
        own.push_back({"speed error on " + std::to_string(std::lround(slope_deg)) + " degrees",
                       outcome.mean_speed / exact - 1, 1e-3});
        if (slope_deg == 35) statistics = outcome.statistics;
    }
    own.push_back({"stopping distance error", stopping_error(cell_size, scheme), 1e-3});
    statistics.own = own;
    return statistics;
}

}  // namespace

SlabOutcome run_slab(double cell_size, Scheme scheme, const Slab& slab, const std::function<double(double)>& travel) {
    const double gradient = std::tan(slab.slope_deg * k_degree);
    const GridSpec grid =
        plain_grid(static_cast<std::int64_t>(std::ceil((300 + slab.travel) / cell_size)), k_rows, cell_size);
    Setup setup;
    setup.bed = sample_raster(grid, [&](Point p) { return (grid.east() - p.x) * gradient; });
    setup.seeds = fill_lattice(grid, 2, 0, [&](Point p) {
        return Seed{p.x > 20 && p.x < 220 ? 1.0 : 0.0, slab.start_speed, 0};
    });
    setup.material = slab.material;
    setup.numerics = numerics_of(scheme, SlopeCorrection::normal, Boundary::wall);
    TimedFlow run(setup);
    SlabOutcome outcome;
    run.advance_to(slab.time, [&](const voellmy_bingham::StepReport& report) {
        // The velocity after a step is that of the particles' motion in it.
        outcome.distance += middle_speed(run.flow(), k_slab_middle + travel(run.flow().time())) * report.dt;
    });
    const double middle = k_slab_middle + slab.travel;
    outcome.mean_speed = middle_speed(run.flow(), middle);
    outcome.statistics = compare_with_exact(
        run,
        [&](Point) {
            return ExactState{1, slab.speed, 0};
        },
        [&](Point p) { return std::abs(p.x - middle) <= k_window; });
    return outcome;
}

AccuracyCase sliding_block() {
    return {"sliding-block", "slab on planes of 25 to 45 degrees; stopping on 10", {4, 2, 1, 0.5}, true, run_sliding};
}

}  // namespace frana::bench
