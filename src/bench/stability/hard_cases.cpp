// SPDX-License-Identifier: Apache-2.0
// Hard materials: each law's parameters from one end of their range to the other.
// Hard numerics: few and many particles, long steps, far coordinates, extreme cell sizes, other transfers.
// Hard releases: a single cell, a tall column, films, masses that meet.
// Hard ground: steps, cliffs, walls, holes and gaps.
#include <algorithm>
#include <cmath>

#include "bench/stability/stability.h"
#include "params/keys/result_rasters.h"
#include "physics/laws.h"
#include "simulation/simulation.h"

namespace frana::bench {
namespace {

Setup with(const std::function<void(Material&)>& change) {
    Setup setup = usual_slide();
    change(setup.material);
    return setup;
}

HardCase viscosity(const char* name, const char* what, double value) {
    return {name, what, 8, [value] { return with([=](Material& m) { m.of<BinghamStress>().viscosity = value; }); }};
}

HardCase yield(const char* name, const char* what, double value) {
    return {name, what, 8, [value] { return with([=](Material& m) { m.of<BinghamStress>().yield_stress = value; }); }};
}

HardCase turbulence(const char* name, const char* what, double value) {
    return {name, what, 15,
            [value] { return with([=](Material& m) { m.of<TurbulentFriction>().turbulence = value; }); }};
}

// The usual cap on a plane of 25 degrees.
Setup on_plane(double friction_deg) {
    Setup setup = usual_slide_on(2, [](Point p) { return (160 - p.x) * std::tan(25 * k_degree); });
    setup.material = dry_friction(friction_deg);
    return setup;
}

// Returns the greatest displacement of a particle from its start; the order of particles at rest does not change. By
// finite volumes that of depth.
StabilityStatistic displacement(const Setup& setup, TimedFlow& run) {
    TimedFlow fresh(setup);
    if (setup.numerics.scheme == Scheme::finite_volume) {
        DepthAgreement agreement;
        agreement.compare(fresh);
        agreement.compare(run);
        return agreement.statistic();
    }
    const ParticleSet &now = run.particles(), &start = fresh.particles();
    double farthest = now.size() == start.size() ? 0 : std::numeric_limits<double>::infinity();
    for (std::size_t p = 0; p < std::min(now.size(), start.size()); ++p)
        farthest = std::max(farthest,
                            std::hypot(now[Field::x][p] - start[Field::x][p], now[Field::y][p] - start[Field::y][p]));
    return {"displacement after 600 s [m]", farthest, 0};
}

// A slab that fills the plane from side to side, so that its middle is a rigid block.
constexpr double k_slab_slope = 25, k_slab_friction = 24.9, k_slab_time = 5;

Setup slab() {
    Setup setup = on_plane(k_slab_friction);
    setup.numerics.boundary = Boundary::wall;
    setup.seeds = fill_lattice(setup.bed.grid, 2, 0, [](Point p) { return Seed{p.x > 10 && p.x < 110 ? 1.0 : 0}; });
    return setup;
}

StabilityStatistic slab_speed(const Setup&, TimedFlow& run) {
    double sum = 0, n = 0;
    const ParticleSet& particles = run.particles();
    for (std::size_t p = 0; p < particles.size(); ++p) {
        if (std::abs(particles[Field::x][p] - 60) > 10) continue;
        sum += run.velocity(p).x;
        ++n;
    }
    const double cosine = std::cos(k_slab_slope * k_degree);
    const double exact = k_gravity * cosine * cosine * k_slab_time *
                         (std::tan(k_slab_slope * k_degree) - std::tan(k_slab_friction * k_degree));
    return {"speed against a rigid block's, relative error", std::abs(sum / n / exact - 1), 1e-3};
}

// Coulomb friction alone is independent of the density: the flow must be the same for ten of them, bit for bit.
StabilityStatistic ten_densities(Scheme scheme, int threads, Soundness& sound) {
    DepthAgreement agreement;
    for (const double density : {1.0, 100.0, 500.0, 1000.0, 1200.0, 1500.0, 2000.0, 2700.0, 5000.0, 20000.0}) {
        Setup setup = usual_slide();
        setup.numerics.scheme = scheme;
        setup.material.density = density;
        TimedFlow run(setup, threads);
        merge(sound, watch(run, setup, 8));
        agreement.compare(run);
    }
    return agreement.statistic();
}

}  // namespace

std::vector<HardCase> hard_material_cases() {
    return {
        {"frictionless", "no friction at all", 10, [] { return with([](Material& m) { m = water(); }); }},
        viscosity("viscosity-1", "1 Pa s", 1),
        viscosity("viscosity-1e4", "1e4 Pa s", 1e4),
        viscosity("viscosity-1e6", "1e6 Pa s", 1e6),
        yield("yield-1", "yield stress 1 Pa", 1),
        yield("yield-1e3", "yield stress 1e3 Pa", 1e3),
        yield("yield-1e5", "yield stress 1e5 Pa", 1e5),
        {"viscous-and-yield", "1e4 Pa s and 1e4 Pa together", 8,
         [] {
             return with([](Material& m) {
                 m.of<BinghamStress>().viscosity = 1e4;
                 m.of<BinghamStress>().yield_stress = 1e4;
             });
         }},
        turbulence("turbulence-1", "xi = 1 m/s2", 1),
        turbulence("turbulence-1e9", "xi = 1e9 m/s2", 1e9),
        {"atmosphere", "surface pressure of one atmosphere", 15,
         [] { return with([](Material& m) { m.of<CoulombFriction>().surface_pressure = 101325; }); }},
        {"steep-friction", "friction angle of 85 degrees", 15,
         [] {
             return with([](Material& m) { m.of<CoulombFriction>().friction_coefficient = std::tan(85 * k_degree); });
         }},
        {"rest-600s", "friction above the slope: nothing may move", 600, [] { return on_plane(40); }, displacement},
        {"just-below", "friction a tenth of a degree below the slope", k_slab_time, slab, slab_speed},
        {"ten-densities", "ten densities from 1 to 20 000 kg/m3", 8, {}, {}, ten_densities},
    };
}

namespace {

HardCase particles_per_cell(const char* name, const char* what, int per_side, double jitter) {
    return {name,
            what,
            15,
            [=] {
                Setup setup = usual_slide();
                setup.numerics.particles_per_cell = per_side * per_side;
                setup.seeds =
                    fill_lattice(setup.bed.grid, per_side, jitter, [](Point p) { return Seed{usual_cap(p)}; });
                return setup;
            },
            {},
            {},
            true};
}

HardCase with_transfer(const char* name, const char* what, Transfer transfer) {
    return {name,
            what,
            15,
            [=] {
                Setup setup = usual_slide();
                setup.numerics.transfer = transfer;
                return setup;
            },
            {},
            {},
            true};
}

HardCase with_cfl(const char* name, const char* what, double cfl) {
    return {name, what, 15, [=] {
                Setup setup = usual_slide();
                setup.numerics.cfl = cfl;
                return setup;
            }};
}

// The usual slide, all lengths times `scale`.
HardCase scaled(const char* name, const char* what, double scale) {
    return {name, what, 15 * std::sqrt(scale), [=] {
                Setup setup = usual_slide();
                const auto inner = [=](Point p) { return Point{p.x / scale, p.y / scale}; };
                const GridSpec grid = plain_grid(80, 40, 2 * scale);
                setup.bed = sample_raster(grid, [&](Point p) { return scale * usual_slope(inner(p)); });
                setup.seeds = fill_lattice(grid, 2, 0, [&](Point p) { return Seed{scale * usual_cap(inner(p))}; });
                setup.numerics.minimum_depth *= scale;
                return setup;
            }};
}

Scene scene_at(Scheme scheme, double west, double north) {
    Scene scene;
    scene.numerics.scheme = scheme;
    scene.grid = {west, north, 2, 80, 40, ""};
    scene.terrain = Raster(scene.grid);
    for (std::int64_t row = 0; row < scene.grid.rows; ++row)
        for (std::int64_t column = 0; column < scene.grid.columns; ++column)
            scene.terrain.at(row, column) = usual_slope({2 * static_cast<double>(column) + 1, 0});
    ReleaseArea area;
    area.outline = {
        {{{west + 20, north - 50}, {west + 40, north - 50}, {west + 40, north - 30}, {west + 20, north - 30}}, {}}};
    area.thickness = 3;
    scene.release = {area};
    scene.material = dry_friction(15);
    scene.time.end = 8;
    return scene;
}

// The engine works in metres from the grid's corner, and all coordinates here are whole numbers, so a scene
// far from the origin must give the same bits.
StabilityStatistic far_coordinates(Scheme scheme, int threads, Soundness& sound) {
    RunOptions options;
    options.threads = threads;
    const RunResult near = run(scene_at(scheme, 0, 80), options), far = run(scene_at(scheme, 600000, 5000000), options);
    double greatest = 0;
    for (std::size_t c = 0; c < near.raster(RasterName::max_depth).values.size(); ++c) {
        const double a = near.raster(RasterName::max_depth).values[c], b = far.raster(RasterName::max_depth).values[c];
        if (std::isnan(a) != std::isnan(b)) greatest = std::numeric_limits<double>::infinity();
        if (!std::isnan(a)) greatest = std::max(greatest, std::abs(a - b));
    }
    sound.non_finite = far.hard_events.non_finite;
    sound.volume_error = std::abs(far.volume_final + far.volume_left - far.volume_initial) / far.volume_initial;
    for (const double speed : far.raster(RasterName::max_velocity).values) {
        const double limit = std::sqrt(2 * k_gravity * 43) + 2 * std::sqrt(k_gravity * 3);
        if (!std::isnan(speed)) sound.speed_ratio = std::max(sound.speed_ratio, speed / limit);
    }
    sound.clamped = far.hard_events.depth_clamped;
    sound.particles = far.particles_peak;
    sound.steps = far.steps;
    sound.wall_seconds = near.engine_seconds + far.engine_seconds;
    return {"greatest difference of max depth [m]", greatest, 0};
}

// A second thread must not change a bit.
StabilityStatistic threads_alike(Scheme scheme, int threads, Soundness& sound) {
    DepthAgreement agreement;
    for (const int n : {1, 2, 5, std::max(1, threads)}) {
        Setup setup = usual_slide();
        setup.numerics.scheme = scheme;
        TimedFlow run(setup, n);
        merge(sound, watch(run, setup, 8));
        agreement.compare(run);
    }
    return agreement.statistic();
}

}  // namespace

std::vector<HardCase> hard_numerics_cases() {
    return {
        particles_per_cell("one-per-cell", "1 particle per cell", 1, 0),
        particles_per_cell("four-per-cell", "4 particles per cell", 2, 0),
        particles_per_cell("sixteen-per-cell", "16 particles per cell", 4, 0),
        particles_per_cell("random-particles", "4 per cell, placed at random", 2, 1),
        with_cfl("cfl-09", "Courant number 0.9", 0.9),
        with_cfl("cfl-005", "Courant number 0.05", 0.05),
        with_transfer("pic", "PIC transfer", Transfer::pic),
        with_transfer("flip", "FLIP transfer", Transfer::flip),
        scaled("centimetres", "all lengths a hundredth: cells of 2 cm", 0.01),
        scaled("hundred-metres", "all lengths times 50: cells of 100 m", 50),
        {"far-coordinates", "a scene at 600 000, 5 000 000 m against one at the origin", 8, {}, {}, far_coordinates},
        {"threads", "1, 2, 5 and all threads", 8, {}, {}, threads_alike},
    };
}

namespace {

Setup seeded(Setup setup, const std::function<Seed(Point)>& state) {
    setup.seeds = fill_lattice(setup.bed.grid, 2, 0, state);
    return setup;
}

bool in_one_cell(Point p) {
    return std::abs(p.x - 31) < 1 && std::abs(p.y - 41) < 1;
}

Setup flat() {
    Setup setup = usual_slide_on(2, [](Point) { return 0.0; });
    setup.numerics.boundary = Boundary::wall;
    return setup;
}

Setup flat_water() {
    Setup setup = flat();
    setup.material = water();
    return setup;
}

// A basin 10 m deep at its far end, filled to 6 m, with a slide above it.
Setup lake_with_slide() {
    Setup setup = usual_slide_on(2, [](Point p) { return std::abs(p.x - 100) * 0.5; });
    setup.numerics.boundary = Boundary::wall;
    setup.material = dry_friction(3);
    const SchemeBed bed(setup.bed, Scheme::standard, Boundary::wall);
    return seeded(setup, [&](Point p) {
        const double lake = 12 - bed(p), slide = 4 - 0.3 * std::hypot(p.x - 40, p.y - 40);
        return Seed{lake > 0 ? lake : slide};
    });
}

}  // namespace

std::vector<HardCase> hard_release_cases() {
    return {
        {"single-cell", "a release of one cell, 2 m deep", 20,
         [] { return seeded(usual_slide(), [](Point p) { return Seed{in_one_cell(p) ? 2.0 : 0}; }); }},
        {"single-particle", "a release of one particle", 20,
         [] {
             return seeded(usual_slide(), [](Point p) {
                 return Seed{std::abs(p.x - 30.5) < 0.4 && std::abs(p.y - 40.5) < 0.4 ? 1.0 : 0};
             });
         }},
        {"column-100", "a column of 100 m, one cell wide, on level ground", 20,
         [] { return seeded(flat(), [](Point p) { return Seed{in_one_cell(p) ? 100.0 : 0}; }); }},
        {"column-100-slope", "the same on a slope, without friction", 10,
         [] {
             Setup setup = seeded(usual_slide(), [](Point p) { return Seed{in_one_cell(p) ? 100.0 : 0}; });
             setup.material = water();
             return setup;
         }},
        {"film-1mm-slope", "a film of a millimetre on the slope", 20,
         [] { return seeded(usual_slide(), [](Point p) { return Seed{usual_cap(p) > 0 ? 1e-3 : 0}; }); }},
        {"film-1mm-flat", "a dam break from a millimetre of water", 20,
         [] { return seeded(flat_water(), [](Point p) { return Seed{p.x < 80 ? 1e-3 : 0}; }); }},
        {"wave-over-film", "a dam break, 10 m over a film of a millimetre", 8,
         [] { return seeded(flat_water(), [](Point p) { return Seed{p.x < 80 ? 10 : 1e-3}; }); }},
        {"film-1um", "a thin film of a thousandth of a millimetre on the slope", 20,
         [] { return seeded(usual_slide(), [](Point p) { return Seed{usual_cap(p) > 0 ? 1e-6 : 0}; }); }},
        {"collision", "two masses that meet at 20 m/s each", 10,
         [] {
             return seeded(flat(), [](Point p) {
                 const bool in = std::abs(p.y - 40) < 15 && std::abs(std::abs(p.x - 80) - 25) < 15;
                 return Seed{in ? 4.0 : 0, p.x < 80 ? 20.0 : -20.0, 0};
             });
         }},
        {"mass-onto-mass", "a mass that slides onto another at rest", 15,
         [] {
             return seeded(usual_slide(), [](Point p) {
                 const double resting = 3 - 0.25 * std::hypot(p.x - 100, p.y - 40);
                 return Seed{std::max(usual_cap(p), resting)};
             });
         }},
        {"slide-into-lake", "a slide that enters a lake", 30, lake_with_slide},
        {"closed-box", "a dam break that swings in a closed box for two minutes", 120,
         [] { return seeded(flat_water(), [](Point p) { return Seed{p.x < 40 ? 5.0 : 1.0}; }); }},
        {"slab-40m", "a slab of 40 m with vertical sides on the slope", 15,
         [] { return seeded(usual_slide(), [](Point p) { return Seed{usual_cap(p) > 0 ? 40.0 : 0}; }); }},
        {"fast-release", "a release that already moves at 80 m/s, across the slope", 10,
         [] { return seeded(usual_slide(), [](Point p) {
                  return Seed{usual_cap(p), 0, 80};
              }); }},
    };
}

namespace {

// Returns a fixed number in [0, 1) for a cell; the same on every machine.
double noise(Point p, double cell) {
    auto h =
        static_cast<std::uint64_t>(p.x / cell) * 73856093ULL ^ static_cast<std::uint64_t>(p.y / cell) * 19349663ULL;
    h = (h ^ (h >> 15)) * 0x9e3779b97f4a7c15ULL;
    return static_cast<double>(h >> 40) * 0x1p-24;
}

Setup plane(double slope_deg, double friction_deg) {
    Setup setup = usual_slide_on(2, [=](Point p) { return (160 - p.x) * std::tan(slope_deg * k_degree); });
    setup.material = dry_friction(friction_deg);
    return setup;
}

Setup on(const std::function<double(Point)>& bed) {
    return usual_slide_on(2, bed);
}

Setup with_gaps(const std::function<bool(Point)>& gap) {
    Setup setup = on([&](Point p) { return gap(p) ? k_no_data : usual_slope(p); });
    setup.numerics.nodata = NodataPolicy::wall;
    setup.numerics.boundary = Boundary::wall;
    return setup;
}

// Returns how far the farthest particle is inside a gap, in cells: the distance to the nearest cell with ground. The
// wall is on the gap's outermost nodes, half a cell inside its edge, and velocities between a wall's node and a free
// one are not zero, so up to one cell is expected.
StabilityStatistic into_gaps(const Setup& setup, TimedFlow& run) {
    const ParticleSet& particles = run.particles();
    const GridSpec& grid = setup.bed.grid;
    double farthest = 0;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const double x = particles[Field::x][p] / grid.cell_size, y = particles[Field::y][p] / grid.cell_size;
        const auto i = static_cast<std::int64_t>(x), j = static_cast<std::int64_t>(y);
        double nearest = 3;
        for (std::int64_t n = std::max<std::int64_t>(0, j - 3); n <= std::min(grid.rows - 1, j + 3); ++n) {
            for (std::int64_t m = std::max<std::int64_t>(0, i - 3); m <= std::min(grid.columns - 1, i + 3); ++m) {
                if (std::isnan(setup.bed.at(grid.rows - 1 - n, m))) continue;
                const auto west = static_cast<double>(m), south = static_cast<double>(n);
                nearest = std::min(nearest, std::hypot(std::max({0.0, west - x, x - west - 1}),
                                                       std::max({0.0, south - y, y - south - 1})));
            }
        }
        farthest = std::max(farthest, nearest);
    }
    return {"farthest inside a gap [cells]", farthest, 1};
}

StabilityStatistic remaining_volume(const Setup& setup, TimedFlow& run) {
    double start = 0;
    for (std::size_t p = 0; p < setup.seeds.size(); ++p) start += setup.seeds[Field::volume][p];
    return {"fraction that has not left", run.model().volume() / start, 0.01};
}

}  // namespace

std::vector<HardCase> hard_terrain_cases() {
    return {
        {"step-down", "a step of 4 m down in the bed", 15,
         [] { return on([](Point p) { return usual_slope(p) + (p.x < 60 ? 4 : 0); }); }},
        {"step-up", "a step of 4 m up across the run-out", 15,
         [] { return on([](Point p) { return usual_slope(p) + (p.x > 100 ? 4 : 0); }); }},
        {"slope-60", "a plane of 60 degrees", 10, [] { return plane(60, 20); }},
        {"slope-75", "a plane of 75 degrees", 10, [] { return plane(75, 20); }},
        {"cliff-50", "a vertical cliff of 50 m", 15,
         [] { return on([](Point p) { return usual_slope(p) + (p.x < 70 ? 50 : 0); }); }},
        {"canyon-walls", "a slot 6 m wide between walls of 30 m", 15,
         [] { return on([](Point p) { return usual_slope(p) + (p.x > 60 && std::abs(p.y - 40) > 3 ? 30 : 0); }); }},
        {"gully-45", "a V-shaped gully with sides of 45 degrees and bends", 15,
         [] { return on([](Point p) { return usual_slope(p) + std::abs(p.y - 40 - 8 * std::sin(0.1 * p.x)); }); }},
        {"needle", "a needle of 30 m in the path, one cell wide", 15,
         [] {
             return on(
                 [](Point p) { return usual_slope(p) + (std::abs(p.x - 61) < 1 && std::abs(p.y - 41) < 1 ? 30 : 0); });
         }},
        {"pit", "a hole of 30 m in the path, one cell wide", 15,
         [] {
             return on(
                 [](Point p) { return usual_slope(p) - (std::abs(p.x - 61) < 1 && std::abs(p.y - 41) < 1 ? 30 : 0); });
         }},
        {"rough-cells", "every cell up to 3 m higher or lower than its neighbour", 15,
         [] { return on([](Point p) { return usual_slope(p) + 3 * noise(p, 2); }); }},
        {"integer-dtm", "elevations in whole metres, cells of 12.5 m", 60,
         [] {
             Setup setup = usual_slide();
             const GridSpec grid = plain_grid(60, 40, 12.5);
             setup.bed = sample_raster(grid, [](Point p) { return std::round(std::max(0.0, 0.21 * (500 - p.x))); });
             setup.seeds = fill_lattice(grid, 2, 0, [](Point p) {
                 return Seed{12 * (1 - (std::pow(p.x - 150, 2) + std::pow(p.y - 250, 2)) / (80 * 80))};
             });
             setup.material = dry_friction(6);
             return setup;
         }},
        {"no-data-islands", "three gaps without ground in the path, taken as walls", 20,
         [] {
             return with_gaps([](Point p) {
                 return std::hypot(p.x - 60, p.y - 30) < 5 || std::hypot(p.x - 75, p.y - 50) < 7 ||
                        std::hypot(p.x - 95, p.y - 38) < 4;
             });
         },
         into_gaps},
        {"ragged-edges", "ground with a ragged outline inside the grid, taken as walls", 20,
         [] {
             return with_gaps([](Point p) {
                 return std::abs(p.y - 40) > 28 + 8 * std::sin(0.7 * p.x) || p.x > 130 + 6 * std::sin(1.3 * p.y) ||
                        p.x < 8 + 4 * std::sin(0.9 * p.y);
             });
         },
         into_gaps},
        {"leaves-all-sides", "a smooth cone: all material leaves through all sides", 60,
         [] {
             Setup setup = on([](Point p) { return 60 - 0.6 * std::hypot(p.x - 80, p.y - 40); });
             setup.seeds = fill_lattice(setup.bed.grid, 2, 0,
                                        [](Point p) { return Seed{4 - 0.4 * std::hypot(p.x - 80, p.y - 40)}; });
             setup.material = water();
             return setup;
         },
         remaining_volume},
    };
}

}  // namespace frana::bench
