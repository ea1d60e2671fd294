// SPDX-License-Identifier: Apache-2.0
#include "bench/accuracy/lake.h"

#include <algorithm>

namespace frana::bench {
namespace {

constexpr double k_lake_side = 10, k_lake_level = 10;

double hill(Point p, double height) {
    const double dx = p.x - 5, dy = p.y - 5;
    return height * std::exp(-0.4 * (dx * dx + dy * dy));
}

double block(Point p) {
    return p.x >= 4 && p.x <= 8 && p.y >= 4 && p.y <= 8 ? 4 : 0;
}

Material paper_material() {
    Material material = dry_friction(20);
    material.density = 1200;
    material.turbulence = 200;
    material.viscosity = 2e3;
    material.yield_stress = 30;
    return material;
}

Raster bed_of(double cell_size, const std::function<double(Point)>& z) {
    const std::int64_t cells = std::llround(k_lake_side / cell_size);
    return sample_raster(plain_grid(cells, cells, cell_size), z);
}

double own(const CaseStatistics& statistics, std::size_t i) {
    return statistics.own.at(i).value;
}

CaseStatistics run_table_1(double cell_size, Scheme scheme, const std::function<double(Point)>& z) {
    const Raster bed = bed_of(cell_size, z);
    constexpr double k_mark = 1e-12;
    CaseStatistics statistics = run_lake(bed, k_lake_level, paper_material(), scheme, 0, 1);
    double momentum = own(statistics, 1);
    for (const auto& [material, jitter] :
         {std::pair{paper_material(), 0.8}, std::pair{water(), 0.0}, std::pair{water(), 0.8}}) {
        const CaseStatistics other = run_lake(bed, k_lake_level, material, scheme, jitter, 1);
        momentum = std::max(momentum, own(other, 1));
        statistics.steps += other.steps;
        statistics.wall_seconds += other.wall_seconds;
        statistics.l1_depth = std::max(statistics.l1_depth, other.l1_depth);
        statistics.l2_depth = std::max(statistics.l2_depth, other.l2_depth);
        statistics.linf_depth = std::max(statistics.linf_depth, other.linf_depth);
        statistics.l1_momentum = std::max(statistics.l1_momentum, other.l1_momentum);
        if (!other.error.empty()) statistics.error = other.error;
    }
    statistics.own = {{"greatest |h - h0| [m]", statistics.linf_depth, k_mark},
                      {"greatest |hu|, |hv| [m2/s]", momentum, k_mark}};
    return statistics;
}

CaseStatistics run_island(double cell_size, Scheme scheme) {
    const Raster bed = bed_of(cell_size, [](Point p) { return hill(p, 13); });
    CaseStatistics statistics = run_lake(bed, k_lake_level, water(), scheme, 0, 10);
    const CaseStatistics random = run_lake(bed, k_lake_level, water(), scheme, 0.8, 10);
    for (CaseStatistic& statistic : statistics.own) statistic.mark = 1e-10;
    statistics.own.push_back({"greatest speed, random particles [m/s]", own(random, 2), {}});
    return statistics;
}

}  // namespace

CaseStatistics run_lake(const Raster& bed, double level, const Material& material, Scheme scheme, double jitter,
                        double time) {
    Setup setup;
    setup.bed = bed;
    setup.material = material;
    setup.numerics = numerics_of(scheme, SlopeCorrection::normal, Boundary::wall);
    const SchemeBed elevation(bed, scheme, Boundary::wall);
    setup.seeds = fill_lattice(bed.grid, 2, jitter, [&](Point p) { return Seed{level - elevation(p)}; });
    TimedFlow run(setup);
    const Raster start = run.flow().nodal_fields().depth;
    run.advance_to(time);
    const GridSpec& grid = bed.grid;
    CaseStatistics statistics = compare_with_exact(run, [&](Point p) {
        const auto column = static_cast<std::int64_t>(p.x / grid.cell_size);
        const auto row = grid.rows - 1 - static_cast<std::int64_t>(p.y / grid.cell_size);
        return ExactState{start.at(row, column), 0, 0};
    });
    const Flow::NodalFields end = run.flow().nodal_fields();
    double momentum = 0, speed = 0;
    for (const Raster* field : {&end.momentum_x, &end.momentum_y})
        for (const double q : field->values) momentum = std::max(momentum, std::abs(q));
    const ParticleSet& particles = run.flow().particles();
    for (std::size_t p = 0; p < particles.size(); ++p)
        speed = std::max(speed, std::hypot(particles[Field::u][p], particles[Field::v][p]));
    if (run.non_finite() > 0) momentum = speed = k_no_data;
    statistics.own = {{"greatest |h - h0| [m]", statistics.linf_depth, {}},
                      {"greatest |hu|, |hv| [m2/s]", momentum, {}},
                      {"greatest speed [m/s]", speed, {}}};
    return statistics;
}

std::vector<AccuracyCase> lakes() {
    const std::vector<double> cells{0.5, 0.4, 0.25, 0.2};
    return {{"lake-z1", "lake at rest over a smooth hill, 1 s", cells, true,
             [](double dx, Scheme scheme) { return run_table_1(dx, scheme, [](Point p) { return hill(p, 5); }); }},
            {"lake-z2", "lake at rest over a 4 m step, 1 s", cells, true,
             [](double dx, Scheme scheme) { return run_table_1(dx, scheme, block); }},
            {"lake-island", "lake at rest round an island, 10 s", {0.5, 0.4, 0.25, 0.2, 0.1}, true, run_island}};
}

namespace {

// Every `skip`-th elevation, no mean.
Raster thinned(const Raster& dtm, std::int64_t skip) {
    const GridSpec& fine = dtm.grid;
    Raster coarse(plain_grid(fine.columns / skip, fine.rows / skip, fine.cell_size * static_cast<double>(skip)));
    for (std::int64_t row = 0; row < coarse.grid.rows; ++row)
        for (std::int64_t column = 0; column < coarse.grid.columns; ++column)
            coarse.at(row, column) = dtm.at(row * skip + skip / 2, column * skip + skip / 2);
    return coarse;
}

// Returns the level below which a third of the ground is.
double flood_level(const Raster& dtm) {
    std::vector<double> elevations = dtm.values;
    const auto third = elevations.begin() + static_cast<std::ptrdiff_t>(elevations.size() / 3);
    std::nth_element(elevations.begin(), third, elevations.end());
    return *third;
}

}  // namespace

AccuracyCase lake_dtm(const Raster& dtm) {
    const double cell = dtm.grid.cell_size, level = flood_level(dtm);
    return {"lake-dtm",
            "the sample's terrain flooded, 60 s",
            {8 * cell, 4 * cell, 2 * cell, cell},
            true,
            [dtm, level](double cell_size, Scheme scheme) {
                const Raster bed = thinned(dtm, std::llround(cell_size / dtm.grid.cell_size));
                CaseStatistics statistics = run_lake(bed, level, water(), scheme, 0, 60);
                statistics.own.back().mark = 1e-4;
                return statistics;
            }};
}

}  // namespace frana::bench
