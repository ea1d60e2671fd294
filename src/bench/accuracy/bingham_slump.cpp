// SPDX-License-Identifier: Apache-2.0
#include "bench/accuracy/bingham_slump.h"

#include <algorithm>

namespace frana::bench {
namespace {

constexpr double k_slump_depth = 5, k_slump_block = 20, k_slump_runout = 40, k_slump_density = 1500, k_slump_time = 600;

CaseStatistics run_slump(double cell_size, Scheme scheme) {
    const GridSpec grid = plain_grid(std::llround(60 / cell_size), 4, cell_size);
    // 2 T / (rho g) from the volume of a slice.
    const double root = 1.5 * k_slump_depth * k_slump_block / std::pow(k_slump_runout, 1.5), rise = root * root;
    const double yield = 0.5 * rise * k_slump_density * k_gravity;
    Setup setup;
    setup.bed = Raster(grid, 0.0);
    setup.seeds = fill_lattice(grid, 2, 0, [](Point p) { return Seed{p.x < k_slump_block ? k_slump_depth : 0}; });
    setup.material.density = k_slump_density;
    setup.material.friction_coefficient = 1e-6;
    setup.material.surface_pressure = yield / *setup.material.friction_coefficient;
    setup.material.turbulence = 0.2;
    setup.numerics = numerics_of(scheme, SlopeCorrection::normal, Boundary::wall);
    TimedFlow run(setup);
    run.advance_to(k_slump_time);
    CaseStatistics statistics = compare_with_exact(run, [&](Point p) {
        return ExactState{std::sqrt(rise * std::max(0.0, k_slump_runout - p.x)), 0, 0};
    });
    double front = 0;
    const ParticleSet& particles = run.flow().particles();
    for (std::size_t p = 0; p < particles.size(); ++p)
        front = std::max(front, particles[Field::x][p] + 0.5 * std::sqrt(particles[Field::area][p]));
    statistics.own = {{"run-out error", front / k_slump_runout - 1, 0.03}, {"l1_depth", statistics.l1_depth, 0.03}};
    return statistics;
}

}  // namespace

AccuracyCase bingham_slump() {
    return {"bingham-slump",
            "final profile of a slump held by a yield stress at the bed",
            {2, 1, 0.5, 0.25},
            false,
            run_slump};
}

}  // namespace frana::bench
