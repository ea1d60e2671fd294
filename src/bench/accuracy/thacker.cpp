// SPDX-License-Identifier: Apache-2.0
#include "bench/accuracy/thacker.h"

#include <algorithm>
#include <array>

namespace frana::bench {
namespace {

constexpr double k_disc_deep = 10, k_disc_radius = 100, k_disc_swing = 20, k_disc_stretch = 0.5, k_disc_side = 400;
constexpr Point k_disc_middle{0.5 * k_disc_side, 0.5 * k_disc_side};
constexpr double k_half_turn = 180 * k_degree;

// The exact water at time zero and after whole periods: a paraboloid about a middle, with depth `deep` there and dry
// from `radius` on, moving with one velocity.
struct Disc {
    Point middle;
    double deep, radius;
    double v = 0;
    double period = 0;

    [[nodiscard]] double depth(Point p) const {
        const double x = p.x - middle.x, y = p.y - middle.y;
        return std::max(0.0, deep * (1 - (x * x + y * y) / (radius * radius)));
    }
};

Disc planar() {
    const double w = std::sqrt(2 * k_gravity * k_disc_deep) / k_disc_radius;
    return {{k_disc_middle.x + k_disc_swing, k_disc_middle.y},
            k_disc_deep,
            k_disc_radius,
            k_disc_swing * w,
            2 * k_half_turn / w};
}

Disc radial() {
    const double w = std::sqrt(8 * k_gravity * k_disc_deep) / k_disc_radius, b = 1 - k_disc_stretch;
    const double s = std::sqrt(1 - k_disc_stretch * k_disc_stretch);
    return {k_disc_middle, k_disc_deep * s / b, k_disc_radius * std::sqrt(b / s), 0, 2 * k_half_turn / w};
}

// Energy per density [m5/s2], with the bed of the scheme's shape functions.
double energy(const ParticleSet& particles, const SchemeBed& bed) {
    double sum = 0;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const double volume = particles[Field::volume][p], u = particles[Field::u][p], v = particles[Field::v][p];
        const double z = bed({particles[Field::x][p], particles[Field::y][p]});
        sum += volume * (0.5 * (u * u + v * v) + k_gravity * (z + 0.5 * volume / particles[Field::area][p]));
    }
    return sum;
}

double shoreline_error(const ParticleSet& particles, const Disc& disc) {
    std::array<double, 32> reach{};
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const double x = particles[Field::x][p] - disc.middle.x, y = particles[Field::y][p] - disc.middle.y;
        const double turn = (std::atan2(y, x) + k_half_turn) / (2 * k_half_turn);
        double& sector = reach[static_cast<std::size_t>(turn * 32) % 32];
        sector = std::max(sector, std::hypot(x, y) + 0.5 * std::sqrt(particles[Field::area][p]));
    }
    double worst = 0;
    for (const double r : reach)
        if (std::abs(r - disc.radius) > std::abs(worst)) worst = r - disc.radius;
    return worst;
}

CaseStatistics run_thacker(double cell_size, Scheme scheme, const Disc& disc) {
    const std::int64_t cells = std::llround(k_disc_side / cell_size);
    const GridSpec grid = plain_grid(cells, cells, cell_size);
    Setup setup;
    setup.bed = sample_raster(grid, [](Point p) {
        const double x = p.x - k_disc_middle.x, y = p.y - k_disc_middle.y;
        return k_disc_deep * ((x * x + y * y) / (k_disc_radius * k_disc_radius) - 1);
    });
    setup.seeds = fill_lattice(grid, 2, 0, [&](Point p) { return Seed{disc.depth(p), 0, disc.v}; });
    setup.material = water();
    setup.numerics = numerics_of(scheme, SlopeCorrection::none, Boundary::wall);
    const SchemeBed bed(setup.bed, scheme, Boundary::wall);
    const double start = energy(setup.seeds, bed);
    // The same volume at rest is a disc about the bed's middle with a level surface: h^2 over h + Z = level.
    double volume = 0;
    for (std::size_t p = 0; p < setup.seeds.size(); ++p) volume += setup.seeds[Field::volume][p];
    const double rest_deep = std::sqrt(2 * volume * k_disc_deep / (k_half_turn * k_disc_radius * k_disc_radius));
    const double rest_radius2 = k_disc_radius * k_disc_radius * rest_deep / k_disc_deep;
    // Integral of g (h Z + h^2 / 2) with h = d (1 - r^2/R^2), Z = d - D - h.
    const double rest =
        k_gravity * ((rest_deep - k_disc_deep) * volume - 0.5 * k_half_turn * rest_radius2 * rest_deep * rest_deep / 3);
    TimedFlow run(setup);
    run.advance_to(3 * disc.period);
    CaseStatistics statistics = compare_with_exact(run, [&](Point p) {
        const double depth = disc.depth(p);
        return ExactState{depth, 0, depth * disc.v};
    });
    const ParticleSet& particles = run.flow().particles();
    statistics.own = {{"shoreline error [cells]", shoreline_error(particles, disc) / cell_size, 1},
                      {"energy lost", (start - energy(particles, bed)) / (start - rest), 0.05}};
    return statistics;
}

}  // namespace

std::vector<AccuracyCase> thackers() {
    const std::vector<double> cells{20, 10, 5, 2.5};
    return {{"thacker", "planar swing in a paraboloid, three periods", cells, false,
             [](double dx, Scheme scheme) { return run_thacker(dx, scheme, planar()); }},
            {"thacker-radial", "radial swing in a paraboloid, three periods", cells, false,
             [](double dx, Scheme scheme) { return run_thacker(dx, scheme, radial()); }}};
}

}  // namespace frana::bench
