// SPDX-License-Identifier: Apache-2.0
#include "bench/accuracy/conservation.h"

#include <algorithm>

namespace frana::bench {
namespace {

constexpr double k_budget_length = 150, k_budget_width = 20, k_budget_time = 7, k_symmetry_time = 3, k_wall_time = 4;

struct Budget {
    double volume = 0, px = 0, size = 0;
};

Budget of_particles(const ParticleSet& particles) {
    Budget b;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const double volume = particles[Field::volume][p], u = particles[Field::u][p], v = particles[Field::v][p];
        b.volume += volume;
        b.px += volume * u;
        b.size += volume * std::hypot(u, v);
    }
    return b;
}

Budget of_nodes(const NodeGrid& nodes) {
    Budget b;
    for (std::int64_t j = 0; j < nodes.rows(); ++j) {
        for (std::int64_t i = 0; i < nodes.columns(); ++i) {
            const NodeForces& node = nodes.forces()[nodes.index(i, j)];
            b.volume += node.mass;
            b.px += node.px;
        }
    }
    return b;
}

CaseStatistics run_conservation(double cell_size, Scheme scheme) {
    const GridSpec grid =
        plain_grid(std::llround(k_budget_length / cell_size), std::llround(k_budget_width / cell_size), cell_size);
    Setup setup;
    setup.bed = sample_raster(grid, [](Point p) {
        return 60 - p.x / 3 + 15 * std::exp(-((p.x - 50) * (p.x - 50) + (p.y - 10) * (p.y - 10)) / 7);
    });
    setup.seeds = fill_lattice(grid, 2, 0, [](Point p) { return Seed{p.x < 20 ? p.x / 3 : 0}; });
    setup.material = dry_friction(12);
    setup.material.density = 1200;
    setup.material.viscosity = 10;
    setup.material.turbulence = 200;
    setup.numerics = numerics_of(scheme, SlopeCorrection::none, Boundary::wall);
    TimedFlow run(setup);
    const double volume = run.flow().volume();
    double worst_volume = 0, worst_momentum = 0;
    const auto check = [&](const voellmy_bingham::StepReport&) {
        const Budget particles = of_particles(run.flow().particles());
        run.flow().nodal_fields();  // gathers on the nodes
        const Budget nodes = of_nodes(run.flow().nodes());
        worst_volume =
            std::max({worst_volume, std::abs(nodes.volume / volume - 1), std::abs(particles.volume / volume - 1)});
        if (run.flow().time() < k_wall_time && particles.size > 0) {
            worst_momentum = std::max(worst_momentum, std::abs(nodes.px - particles.px) / particles.size);
        }
    };
    run.advance_to(k_symmetry_time, check);
    const Raster depth = run.flow().nodal_fields().depth;
    double greatest = 0, sum2 = 0, depth2 = 0;
    for (std::int64_t row = 0; row < grid.rows; ++row) {
        for (std::int64_t column = 0; column < grid.columns; ++column) {
            const double e = depth.at(row, column) - depth.at(grid.rows - 1 - row, column);
            greatest = std::max(greatest, std::abs(e));
            sum2 += e * e;
            depth2 += depth.at(row, column) * depth.at(row, column);
        }
    }
    run.advance_to(k_budget_time, check);
    CaseStatistics statistics;
    statistics.cell_size = cell_size;
    statistics.particles = run.peak_particles();
    statistics.steps = run.flow().steps();
    statistics.wall_seconds = run.seconds();
    statistics.l1_depth = worst_volume;
    statistics.l2_depth = std::sqrt(sum2 / depth2);
    statistics.linf_depth = greatest;
    statistics.l1_momentum = worst_momentum;
    statistics.own = {{"volume, nodes against the start", worst_volume, 1e-12},
                      {"momentum, nodes against particles", worst_momentum, 1e-12},
                      {"asymmetry [m]", greatest, 1e-9}};
    if (run.non_finite() > 0) statistics.error = "values became non-finite";
    return statistics;
}

}  // namespace

AccuracyCase conservation() {
    return {
        "conservation", "mudflow round an obstacle: budgets and symmetry", {2, 1, 0.5, 0.25}, true, run_conservation};
}

}  // namespace frana::bench
