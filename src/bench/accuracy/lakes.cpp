// SPDX-License-Identifier: Apache-2.0
#include "bench/accuracy/accuracy_case.h"

#include <algorithm>
#include <array>

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
    Material material = voellmy(20, 200);
    material.density = 1200;
    set_bingham(material, 2e3, 30);
    return material;
}

Raster bed_of(double cell_size, const std::function<double(Point)>& z) {
    const std::int64_t cells = std::llround(k_lake_side / cell_size);
    return sample_raster(plain_grid(cells, cells, cell_size), z);
}

/// A lake over any bed, filled to `level`, run for `time`; `jitter` as in fill_lattice. Own values: the
/// greatest depth change [m], momentum [m2/s] and particle speed [m/s], with marks if given.
CaseStatistics run_lake(const Raster& bed, double level, const Material& material, Scheme scheme, double jitter,
                        double time) {
    Setup setup;
    setup.bed = bed;
    setup.material = material;
    setup.numerics = numerics_of(scheme, SlopeCorrection::normal, Boundary::wall);
    const SchemeBed elevation(bed, scheme, Boundary::wall);
    setup.seeds = fill_lattice(bed.grid, 2, jitter, [&](Point p) { return Seed{level - elevation(p)}; });
    TimedFlow run(setup);
    const Raster start = run.fields().depth;
    run.advance_to(time);
    const GridSpec& grid = bed.grid;
    CaseStatistics statistics = compare_with_exact(run, [&](Point p) {
        const auto column = static_cast<std::int64_t>(p.x / grid.cell_size);
        const auto row = grid.rows - 1 - static_cast<std::int64_t>(p.y / grid.cell_size);
        return ExactState{start.at(row, column), 0, 0};
    });
    const Flow::NodalFields end = run.fields();
    double momentum = 0, speed = 0;
    for (const Raster* field : {&end.momentum_x, &end.momentum_y})
        for (const double q : field->values) momentum = std::max(momentum, std::abs(q));
    const ParticleSet& particles = run.particles();
    for (std::size_t p = 0; p < particles.size(); ++p)
        speed = std::max(speed, std::hypot(particles[Field::u][p], particles[Field::v][p]));
    if (run.non_finite() > 0) momentum = speed = k_no_data;
    statistics.own = {{"greatest |h - h0| [m]", statistics.linf_depth, {}},
                      {"greatest |hu|, |hv| [m2/s]", momentum, {}},
                      {"greatest speed [m/s]", speed, {}}};
    return statistics;
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
        statistics.cpu_seconds += other.cpu_seconds;
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

/// Lakes at rest on [0, 10] m squared, surface at 10 m, closed walls; no still-water depth is specified. Source: Fois,
/// de Falco, Formaggia 2024, section 4.1 and Table 1.
///   lake-z1      Z = 5 exp(-2/5 |x - (5, 5)|^2), 1 s
///   lake-z2      Z = 4 m on [4, 8] m squared, else 0, 1 s
///   lake-island  Z = 13 exp(-2/5 |x - (5, 5)|^2): an island rises from the water, 10 s, no friction
/// "Exact" is the nodes' own state at the start, which a lake at rest must keep, bit for bit except for rounding. A row
/// of lake-z1 or lake-z2 is four runs: the paper's material (friction 20 degrees, xi 200 m/s2, 1200 kg/m3, 2000 Pa s,
/// 30 Pa) and neither friction nor stress, each with particles on a lattice and placed at random. Its errors are the
/// greatest of the four, its steps and seconds their sums. Marks: 1e-12; for the island 1e-10.
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

/// The sample's terrain flooded to a level, without any forcing for 60 s: a lake with islands and a shoreline, on
/// ground rougher than the grid, since a coarse grid samples single elevations of the fine one instead of means. Walls
/// on all sides, no friction. Mark: no particle faster than 1e-4 m/s.
/// @param dtm elevations without gaps; its cell size is the finest level, the others skip cells
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
    const ParticleSet& particles = run.particles();
    statistics.own = {{"shoreline error [cells]", shoreline_error(particles, disc) / cell_size, 1},
                      {"energy lost", (start - energy(particles, bed)) / (start - rest), 0.05}};
    return statistics;
}

}  // namespace

/// Water oscillating in a paraboloid Z = D (r^2 / a^2 - 1), D = 10 m, a = 100 m, no friction, after three periods.
/// Thacker, J. Fluid Mech. 107, 499-508 (1981).
///   thacker         the surface remains a plane and the disc circles: w = sqrt(2 g D) / a, s = 20 m,
///                   h = D (1 - |x - c|^2 / a^2), c = s (cos wt, sin wt), v = s w (-sin wt, cos wt)
///   thacker-radial  the surface remains a paraboloid: w = sqrt(8 g D) / a, A = 0.5, b = 1 - A cos wt,
///                   h = D (sqrt(1 - A^2) / b - (1 - A^2) r^2 / (a^2 b^2)), v = w r A sin wt / (2 b)
/// These are solutions of the equations without a slope correction, which is therefore off.
/// Own values: the shoreline's error in cells (the farthest particle of 32 sectors against the exact circle;
/// mark 1), the loss of the energy above that at rest, as a fraction (mark 5 %).
std::vector<AccuracyCase> thackers() {
    const std::vector<double> cells{20, 10, 5, 2.5};
    return {{"thacker", "planar swing in a paraboloid, three periods", cells, false,
             [](double dx, Scheme scheme) { return run_thacker(dx, scheme, planar()); }},
            {"thacker-radial", "radial swing in a paraboloid, three periods", cells, false,
             [](double dx, Scheme scheme) { return run_thacker(dx, scheme, radial()); }}};
}

}  // namespace frana::bench
