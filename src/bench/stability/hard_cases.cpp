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

using Change = std::function<void(Setup&)>;
using Surface = std::function<double(Point)>;
constexpr unsigned k_all = k_one_phase | k_structured;

// The usual slide on other ground, with a change.
HardCase slide_on(const char* name, const char* what, double end, const Surface& bed, const Change& change = {},
                  double cell = 2) {
    return {name, what, end, [=](const Variant& variant) {
                Setup setup = usual_slide_on(variant, cell, bed);
                if (change) change(setup);
                return setup;
            }};
}

HardCase slide(const char* name, const char* what, double end, const Change& change) {
    return slide_on(name, what, end, usual_slope, change);
}

// A case with other variants and figures.
HardCase of(HardCase one, unsigned variants, unsigned figures = k_usual,
            std::function<Figure(const Setup&, TimedFlow&)> own = {}) {
    one.variants = variants;
    one.figures = figures;
    one.own = std::move(own);
    return one;
}

Change seeded(const std::function<Seed(Point)>& state) {
    return [=](Setup& setup) { setup.seeds = fill_lattice(setup.bed.grid, 2, 0, state); };
}

// Water at rest up to a level on the bed of the scheme.
Change filled(double level, const std::function<bool(Point)>& where = {}) {
    return [=](Setup& setup) {
        setup.numerics.boundary = Boundary::wall;
        setup.material = water();
        const SchemeBed bed(setup.bed, setup.numerics.scheme, Boundary::wall);
        seeded([&](Point p) { return Seed{!where || where(p) ? level - bed(p) : 0}; })(setup);
    };
}

Change both(const Change& first, const Change& second) {
    return [=](Setup& setup) {
        first(setup);
        second(setup);
    };
}

void as_water(Setup& setup) {
    setup.material = water();
}

void walled(Setup& setup) {
    setup.numerics.boundary = Boundary::wall;
}

double flat(Point) {
    return 0;
}

double plane_25(Point p) {
    return (160 - p.x) * std::tan(25 * k_degree);
}

template <class Law, class Value>
HardCase parameter(const char* name, const char* what, double end, Value Law::Values::*member, double value) {
    return slide(name, what, end, [=](Setup& setup) { setup.material.of<Law>().*member = value; });
}

// Returns the greatest displacement of a particle from its start; the order of particles at rest does not change. By
// cells that of depth.
Figure displacement(const Setup& setup, TimedFlow& run) {
    TimedFlow fresh(setup);
    if (run.model().particle_set() == nullptr)
        return {"volume that moved, relative", elsewhere(fresh.fields().depth, run.fields().depth), 0};
    const ParticleSet &now = run.particles(), &start = fresh.particles();
    double farthest = now.size() == start.size() ? 0 : std::numeric_limits<double>::infinity();
    for (std::size_t p = 0; p < std::min(now.size(), start.size()); ++p)
        farthest = std::max(farthest,
                            std::hypot(now[Field::x][p] - start[Field::x][p], now[Field::y][p] - start[Field::y][p]));
    return {"displacement [m]", farthest, 0};
}

// A slab on a plane, which fills it from side to side, so that its middle is a rigid block.
constexpr double k_plane = 25 * k_degree;

Change slab_of(const Material& material) {
    return [=](Setup& setup) {
        walled(setup);
        setup.material = material;
        seeded([](Point p) { return Seed{p.x > 10 && p.x < 110 ? 1.0 : 0}; })(setup);
    };
}

HardCase slab(const char* name, const char* what, double end, const Material& material, unsigned variants,
              double limit = 1e-3) {
    HardCase one = slide_on(name, what, end, plane_25, slab_of(material));
    one.variants = variants;
    one.figures |= k_ties;
    // v = w tanh(a t / w), w^2 = a xi d / g, d = h cos: the accuracy bench's `voellmy-plane`.
    one.own = [=](const Setup&, TimedFlow& run) {
        const double cosine = std::cos(k_plane), sine = std::sin(k_plane);
        const double mu = material.of<CoulombFriction>().friction_coefficient.value_or(0);
        const double a = k_gravity * (sine - cosine * mu);
        const auto xi = material.of<TurbulentFriction>().turbulence;
        const double w = xi ? std::sqrt(a * *xi * cosine / k_gravity) : 0;
        const double exact = cosine * (xi ? w * std::tanh(a * end / w) : a * end);
        double sum = 0, n = 0;
        const ParticleSet& particles = run.particles();
        for (std::size_t p = 0; p < particles.size(); ++p) {
            if (std::abs(particles[Field::x][p] - 60 - 0.5 * exact * end) > 10) continue;
            sum += run.velocity(p).x;
            ++n;
        }
        return Figure{"speed against a rigid block's, relative error", std::abs(sum / n / exact - 1), limit};
    };
    return one;
}

// The structured model's solids alone.
HardCase dry_grains() {
    HardCase one =
        slab("grain-slab", "a slab of dry grains", 2, dry_friction(15), k_structured, 0.01);  // velocities lag some ms
    one.make = [make = one.make](const Variant& variant) {
        Setup setup = make(variant);
        StructuredMaterial& grains = setup.structured.emplace();
        grains.solids = true;
        grains.solid_fraction = 1;
        grains.friction = grains.bed_friction = std::tan(15 * k_degree);
        return setup;
    };
    return one;
}

Material voellmy(double angle_deg, double turbulence) {
    Material material = dry_friction(angle_deg);
    material.of<TurbulentFriction>().turbulence = turbulence;
    return material;
}

// Resists up to the weight of the slab on its plane, times a factor.
Change stiff_slab(double factor) {
    return [=](Setup& setup) {
        slab_of(water())(setup);
        setup.material.bed_friction = {BinghamFriction::word};
        setup.material.of<BinghamStress>().viscosity = 100;
        // Over 1 m of depth, whose thickness normal to the bed is cos(slope).
        setup.material.of<BinghamStress>().yield_stress =
            factor * setup.material.density * k_gravity * std::sin(k_plane) * std::cos(k_plane);
        // Its ends would slump.
        seeded([](Point) { return Seed{1.0}; })(setup);
    };
}

// Runs the usual slide once for each of several changes and compares it with the first.
template <class Values>
std::function<Figure(const Variant&, int, Soundness&)> alike(const char* name, double limit, double end, Values values,
                                                             const auto& change) {
    return [=](const Variant& variant, int threads, Soundness& sound) {
        std::optional<Raster> first;
        double apart = 0;
        for (const auto value : values) {
            Setup setup = usual_slide(variant);
            int n = threads;
            change(setup, n, value);
            TimedFlow run(setup, n);
            sound.merge(watch(run, setup, end));
            const Raster depth = run.fields().depth;
            if (!first) first = depth;
            apart = std::max(apart, elsewhere(*first, depth));
        }
        return Figure{name, apart, limit};
    };
}

// V = V_0 exp(E S) with the mean distance S along the bed, summed as by the steps; 0.02 as in the test of the law.
Figure growth(const Variant& variant, int threads, Soundness& sound) {
    Setup setup = usual_slide_on(variant, 2, plane_25);
    slab_of(dry_friction(15))(setup);
    setup.entrainment.erosion = GrowthErosion::word;
    setup.entrainment.of<GrowthErosion>().growth_rate = 0.01;
    setup.entrainment.erodible_depth = 5;
    TimedFlow run(setup, threads);
    const Model& model = run.model();
    const double before = model.volume();
    double way = 0;
    run.advance_to(4, [&](const StepStatistics& step) {
        const double speed = model.momentum() / model.volume();
        way += speed * step.dt;
    });
    const BedBudget bed = model.bed_budget();
    sound.volume_error = std::abs(model.volume() - bed.eroded - before) / before;
    sound.steps = model.steps();
    sound.wall_seconds = run.seconds();
    return {"growth against exp(E S), relative", std::abs(std::log(model.volume() / before) / (0.01 * way) - 1), 0.02};
}

}  // namespace

std::vector<HardCase> hard_material_cases() {
    using Stress = BinghamStress::Values;
    using Friction = CoulombFriction::Values;
    using Turbulence = TurbulentFriction::Values;
    const auto viscosity = [](const char* name, const char* what, double value) {
        return parameter<BinghamStress>(name, what, 8, &Stress::viscosity, value);
    };
    const auto yield = [](const char* name, const char* what, double value) {
        return parameter<BinghamStress>(name, what, 8, &Stress::yield_stress, value);
    };
    return {
        slide("frictionless", "no friction at all", 10, as_water),
        viscosity("viscosity-1", "1 Pa s", 1),
        viscosity("viscosity-1e4", "1e4 Pa s", 1e4),
        of(viscosity("viscosity-1e6", "1e6 Pa s", 1e6), k_one_phase,
           k_energy | k_mirror),  // steps of a quarter on half the cells
        yield("yield-1", "yield stress 1 Pa", 1),
        yield("yield-1e3", "yield stress 1e3 Pa", 1e3),
        yield("yield-1e5", "yield stress 1e5 Pa", 1e5),
        of(slide_on("yield-rest", "yield stress 1 % above the weight of a slab: nothing may move", 60, plane_25,
                    stiff_slab(1.01)),
           k_one_phase, k_rest, displacement),
        slide("viscous-and-yield", "1e4 Pa s and 1e4 Pa together", 8,
              [](Setup& setup) {
                  setup.material.of<BinghamStress>().viscosity = 1e4;
                  setup.material.of<BinghamStress>().yield_stress = 1e4;
              }),
        parameter<TurbulentFriction>("turbulence-1", "xi = 1 m/s2", 15, &Turbulence::turbulence, 1),
        parameter<TurbulentFriction>("turbulence-1e9", "xi = 1e9 m/s2", 15, &Turbulence::turbulence, 1e9),
        of(parameter<CoulombFriction>("atmosphere", "surface pressure of one atmosphere", 15,
                                      &Friction::surface_pressure, 101325),
           k_one_phase, k_usual | k_rest),
        of(parameter<CoulombFriction>("steep-friction", "friction angle of 85 degrees", 15,
                                      &Friction::friction_coefficient, std::tan(85 * k_degree)),
           k_one_phase, k_usual | k_rest),
        of(slide_on("rest-600s", "friction above the slope: nothing may move", 600, plane_25,
                    [](Setup& setup) { setup.material = dry_friction(40); }),
           k_one_phase, k_rest, displacement),
        slab("just-below", "friction a tenth of a degree below the slope", 5, dry_friction(24.9), k_one_phase),
        slab("free-slab", "a slab without friction", 2, water(), k_all),
        slab("voellmy-slab", "a slab with Coulomb's and turbulent friction", 5, voellmy(15, 300), k_one_phase),
        dry_grains(),
        slide("checkered", "friction of 5 and 25 degrees in squares of 8 m", 15,
              [](Setup& setup) {
                  setup.zones.friction_coefficient = sample_raster(setup.bed.grid, [](Point p) {
                      const bool odd = (std::llround(std::floor(p.x / 8)) + std::llround(std::floor(p.y / 8))) % 2 != 0;
                      return std::tan((odd ? 25 : 5) * k_degree);
                  });
              }),
        {"growth", "erosion by growth on a plane", 0, {}, k_one_phase, 0, {}, growth},
        {"ten-densities",
         "ten densities from 1 to 20 000 kg/m3",
         0,
         {},
         k_one_phase,
         0,
         {},
         // Coulomb friction alone is independent of the density: the same bits.
         alike("volume elsewhere, relative", 0, 8,
               std::vector<double>{1, 100, 500, 1000, 1200, 1500, 2000, 2700, 5000, 20000},
               [](Setup& setup, int&, double density) { setup.material.density = density; })},
    };
}

namespace {

HardCase particles_per_cell(const char* name, const char* what, int per_side, double jitter) {
    return of(slide(name, what, 15,
                    [=](Setup& setup) {
                        setup.numerics.particles_per_cell = per_side * per_side;
                        setup.seeds =
                            fill_lattice(setup.bed.grid, per_side, jitter, [](Point p) { return Seed{usual_cap(p)}; });
                    }),
              k_particles);
}

HardCase with_transfer(const char* name, const char* what, Transfer transfer) {
    return of(slide(name, what, 15, [=](Setup& setup) { setup.numerics.transfer = transfer; }), k_particles);
}

HardCase with_cfl(const char* name, const char* what, double cfl) {
    return slide(name, what, 15, [=](Setup& setup) { setup.numerics.cfl = cfl; });
}

// The usual slide, all lengths times `scale`.
Setup scaled_slide(const Variant& variant, double scale) {
    const auto inner = [=](Point p) { return Point{p.x / scale, p.y / scale}; };
    Setup setup = usual_slide(variant);
    const GridSpec grid = plain_grid(setup.bed.grid.columns, setup.bed.grid.rows, scale * setup.bed.grid.cell_size);
    setup.bed = sample_raster(grid, [&](Point p) { return scale * usual_slope(inner(p)); });
    setup.seeds = fill_lattice(grid, 2, 0, [&](Point p) { return Seed{scale * usual_cap(inner(p))}; });
    setup.numerics.minimum_depth *= scale;
    return setup;
}

// Froude's similarity: Coulomb's and turbulent friction have no length, so the flow is the same, to rounding; that
// decides which of two particles alike merge.
HardCase scaled(const char* name, const char* what, double scale, double limit = 1e-12) {
    const double end = 15 * std::sqrt(scale);
    HardCase one{name, what, end, [=](const Variant& variant) { return scaled_slide(variant, scale); }};
    one.own = [=](const Setup& setup, TimedFlow& run) {
        TimedFlow usual(usual_slide({setup.numerics.scheme}));
        usual.advance_to(15);
        Raster depth = usual.fields().depth;
        for (double& h : depth.values) h *= scale;
        return Figure{"volume elsewhere than in cells of 2 m", elsewhere(depth, run.fields().depth), limit};
    };
    return one;
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
Figure far_coordinates(const Variant& variant, int threads, Soundness& sound) {
    RunOptions options;
    options.threads = threads;
    const RunResult near = run(scene_at(variant.scheme, 0, 80), options),
                    far = run(scene_at(variant.scheme, 600000, 5000000), options);
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
    sound.energy_rise = far.energy_error.value_or(0);
    sound.particles = far.particles_peak;
    sound.steps = far.steps;
    sound.wall_seconds = near.engine_seconds + far.engine_seconds;
    return {"greatest difference of max depth [m]", greatest, 0};
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
        scaled("half-metre", "all lengths a quarter: cells of 0.5 m", 0.25),
        scaled("forty-metres", "all lengths times 20: cells of 40 m", 20, 1e-2),
        scaled("hundred-metres", "all lengths times 50: cells of 100 m", 50, 1e-2),
        {"far-coordinates",
         "a scene at 600 000, 5 000 000 m against one at the origin",
         0,
         {},
         k_one_phase,
         0,
         {},
         far_coordinates},
        // A second thread must not change a bit.
        {"threads",
         "1, 2, 5 and all threads",
         0,
         {},
         k_one_phase,
         0,
         {},
         alike("volume elsewhere, relative", 0, 8, std::vector<int>{1, 2, 5, 0},
               [](Setup&, int& threads, int n) { threads = n > 0 ? n : std::max(1, threads); })},
    };
}

namespace {

bool in_one_cell(Point p) {
    return std::abs(p.x - 31) < 1 && std::abs(p.y - 41) < 1;
}

Seed one_cell(Point p, double depth) {
    return {in_one_cell(p) ? depth : 0};
}

// On level ground, between walls.
HardCase on_flat(const char* name, const char* what, double end, const std::function<Seed(Point)>& state,
                 const Change& change = as_water) {
    return slide_on(name, what, end, flat, both(both(walled, seeded(state)), change));
}

// A basin 10 m deep at its far end, filled to 6 m, with a slide above it.
HardCase lake_with_slide() {
    return slide_on(
        "slide-into-lake", "a slide that enters a lake", 30, [](Point p) { return std::abs(p.x - 100) * 0.5; },
        [](Setup& setup) {
            walled(setup);
            setup.material = dry_friction(3);
            const SchemeBed bed(setup.bed, Scheme::standard, Boundary::wall);
            seeded([&](Point p) {
                const double lake = 12 - bed(p), slide = 4 - 0.3 * std::hypot(p.x - 40, p.y - 40);
                return Seed{lake > 0 ? lake : slide};
            })(setup);
        });
}

// Ritter's dam break until its waves are at the ends. Its front is known to some cells, in which 1 - 1/9 of the depth
// at the dam is missing: of 320 m2, 2 % and as much for the diffusion at the other end.
Figure ritter_error(const Setup&, TimedFlow& run) {
    const DamBreak exact(4, 0);
    const Raster depth = run.fields().depth;
    double error = 0, all = 0;
    for (std::int64_t column = 0; column < depth.grid.columns; ++column) {
        const double x = (static_cast<double>(column) + 0.5) * depth.grid.cell_size - 80;
        const double h = exact.at(x, run.model().time()).depth;
        error += std::abs(depth.at(depth.grid.rows / 2, column) - h);
        all += h;
    }
    return {"depth against Ritter's, relative L1 error", error / all, 0.04};
}

}  // namespace

std::vector<HardCase> hard_release_cases() {
    return {
        // What is one cell wide is another thing on other cells, and nodes do not have its energy.
        of(slide("single-cell", "a release of one cell, 2 m deep", 20, seeded([](Point p) { return one_cell(p, 2); })),
           k_one_phase, k_mirror),
        of(slide("single-particle", "a release of one particle", 20, seeded([](Point p) {
                     return Seed{std::abs(p.x - 30.5) < 0.4 && std::abs(p.y - 40.5) < 0.4 ? 1.0 : 0};
                 })),
           k_one_phase, k_mirror),
        of(on_flat(
               "column-100", "a column of 100 m, one cell wide, on level ground", 20,
               [](Point p) { return one_cell(p, 100); }, [](Setup&) {}),
           k_one_phase, k_mirror),
        of(slide("column-100-slope", "the same on a slope, without friction", 10,
                 both(seeded([](Point p) { return one_cell(p, 100); }), as_water)),
           k_one_phase, k_mirror),
        slide("film-1mm-slope", "a film of a millimetre on the slope", 20,
              seeded([](Point p) { return Seed{usual_cap(p) > 0 ? 1e-3 : 0}; })),
        on_flat("film-1mm-flat", "a dam break from a millimetre of water", 20,
                [](Point p) { return Seed{p.x < 80 ? 1e-3 : 0}; }),
        of(on_flat("wave-over-film", "a dam break, 10 m over a film of a millimetre", 8,
                   [](Point p) { return Seed{p.x < 80 ? 10 : 1e-3}; }),
           k_one_phase, k_usual | k_ties),
        of(on_flat("dry-dam-break", "a dam break, 4 m over dry ground", 5,
                   [](Point p) { return Seed{p.x < 80 ? 4.0 : 0}; }),
           k_all, k_usual | k_ties, ritter_error),
        slide("film-1um", "a thin film of a thousandth of a millimetre on the slope", 20,
              seeded([](Point p) { return Seed{usual_cap(p) > 0 ? 1e-6 : 0}; })),
        of(on_flat(
               "collision", "two masses that meet at 20 m/s each", 10,
               [](Point p) {
                   const bool in = std::abs(p.y - 40) < 15 && std::abs(std::abs(p.x - 80) - 25) < 15;
                   return Seed{in ? 4.0 : 0, p.x < 80 ? 20.0 : -20.0, 0};
               },
               [](Setup&) {}),
           k_all, k_usual | k_rest),
        slide("mass-onto-mass", "a mass that slides onto another at rest", 15, seeded([](Point p) {
                  const double resting = 3 - 0.25 * std::hypot(p.x - 100, p.y - 40);
                  return Seed{std::max(usual_cap(p), resting)};
              })),
        of(slide_on(
               "two-flows", "two flows that meet at 45 degrees in a valley", 15,
               [](Point p) { return usual_slope(p) + 0.5 * std::abs(p.y - 40); },
               seeded([](Point p) { return Seed{2 - 0.2 * std::hypot(p.x - 30, std::abs(p.y - 40) - 25)}; })),
           k_all),
        of(lake_with_slide(), k_one_phase, k_usual | k_rest),
        of(on_flat("closed-box", "a dam break that swings in a closed box for two minutes", 120,
                   [](Point p) { return Seed{p.x < 40 ? 5.0 : 1.0}; }),
           k_all, k_usual | k_ties),
        slide("slab-40m", "a slab of 40 m with vertical sides on the slope", 15,
              seeded([](Point p) { return Seed{usual_cap(p) > 0 ? 40.0 : 0}; })),
        slide("fast-release", "a release that already moves at 80 m/s, across the slope", 10, seeded([](Point p) {
                  return Seed{usual_cap(p), 0, 80};
              })),
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

// Most of it has left at the end.
HardCase plane(const char* name, const char* what, double slope_deg) {
    return of(slide_on(
                  name, what, 10, [=](Point p) { return (160 - p.x) * std::tan(slope_deg * k_degree); },
                  [](Setup& setup) { setup.material = dry_friction(20); }),
              k_one_phase, k_energy | k_mirror);
}

// The usual slope with more on it.
HardCase on(const char* name, const char* what, double end, const Surface& more, const Change& change = {}) {
    return slide_on(
        name, what, end, [=](Point p) { return usual_slope(p) + more(p); }, change);
}

// Returns how far the farthest particle is inside a gap, in cells: the distance to the nearest cell with ground. The
// wall is on the gap's outermost nodes, half a cell inside its edge, and velocities between a wall's node and a free
// one are not zero, so up to one cell is expected.
Figure into_gaps(const Setup& setup, TimedFlow& run) {
    const ParticleSet* const solids = run.model().particle_set();
    const ParticleSet& particles = solids != nullptr ? *solids : run.particles();
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

HardCase with_gaps(const char* name, const char* what, const std::function<bool(Point)>& gap, unsigned variants) {
    return of(on(
                  name, what, 20, [=](Point p) { return gap(p) ? k_no_data : 0; },
                  [](Setup& setup) {
                      walled(setup);
                      setup.numerics.nodata = NodataPolicy::wall;
                  }),
              variants, k_usual, into_gaps);
}

Figure remaining_volume(const Setup& setup, TimedFlow& run) {
    double start = 0;
    for (std::size_t p = 0; p < setup.seeds.size(); ++p) start += setup.seeds[Field::volume][p];
    return {"fraction that has not left", run.model().volume() / start, 0.01};
}

// Speed at the lip of a cliff over the greater of its neighbours', at any time: water turns down only beyond it.
Figure lip_speed(const Setup&, TimedFlow& run) {
    const Model& model = run.model();
    const auto fastest = [&](std::int64_t column) { return model.maxima().speed[model.nodes().index(column, 8)]; };
    return {"speed at the lip over its neighbours'", fastest(11) / std::max(fastest(10), fastest(12)), 1.2};
}

// A lake that must not move.
Figure greatest_speed(const Setup&, TimedFlow& run) {
    const ParticleSet& particles = run.particles();
    double greatest = 0;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const Point v = run.velocity(p);
        greatest = std::max(greatest, std::hypot(v.x, v.y));
    }
    return {"greatest speed of a still lake [m/s]", greatest, 1e-12};
}

// What it holds must not depend on the cells: 5 m and half of that.
HardCase trap(HardCase one, const std::function<bool(Point)>& where) {
    one.variants = k_all;
    one.figures = k_energy | k_cells;
    one.trap = where;
    return one;
}

}  // namespace

std::vector<HardCase> hard_terrain_cases() {
    const auto in_pit = [](Point p) { return std::abs(p.x - 105) < 15 && std::abs(p.y - 40) < 15; };
    const auto in_basin = [](Point p) { return std::abs(p.x - 100) < 20; };
    return {
        on("step-down", "a step of 4 m down in the bed", 15, [](Point p) { return p.x < 60 ? 4 : 0; }),
        on("step-up", "a step of 4 m up across the run-out", 15, [](Point p) { return p.x > 100 ? 4 : 0; }),
        plane("slope-60", "a plane of 60 degrees", 60),
        plane("slope-75", "a plane of 75 degrees", 75),
        on("cliff-50", "a vertical cliff of 50 m", 15, [](Point p) { return p.x < 70 ? 50 : 0; }),
        of(slide_on(
               "lip", "water over a cliff of 50 m, cells of 5 m", 10, [](Point p) { return p.x < 60 ? 50.0 : 0.0; },
               both(as_water, seeded([](Point p) { return Seed{p.x < 40 ? 5.0 : 0}; })), 5),
           k_volumes | k_structured, k_energy | k_mirror, lip_speed),
        of(on("canyon-walls", "a slot 6 m wide between walls of 30 m", 15,
              [](Point p) { return p.x > 60 && std::abs(p.y - 40) > 3 ? 30 : 0; }),
           k_all),
        of(on("slot", "a gap 4 m wide in a wall of 20 m across the run-out", 15,
              [](Point p) { return std::abs(p.x - 92) < 2 && std::abs(p.y - 40) > 2 ? 20 : 0; }),
           k_all),
        // Cells of 1 m: the flow is few metres wide.
        slide_on(
            "gully-45", "a V-shaped gully with sides of 45 degrees and bends", 15,
            [](Point p) { return usual_slope(p) + std::abs(p.y - 40 - 8 * std::sin(0.1 * p.x)); }, {}, 1),
        on("needle", "a needle of 30 m in the path, one cell wide", 15,
           [](Point p) { return std::abs(p.x - 61) < 1 && std::abs(p.y - 41) < 1 ? 30 : 0; }),
        on("pit", "a hole of 30 m in the path, one cell wide", 15,
           [](Point p) { return std::abs(p.x - 61) < 1 && std::abs(p.y - 41) < 1 ? -30 : 0; }),
        trap(slide_on(
                 "wide-pit", "a pit of 30 m x 30 m, 40 m deep, below the slope", 15,
                 [=](Point p) { return usual_slope(p) - (in_pit(p) ? 40 : 0); }, {}, 5),
             in_pit),
        trap(slide_on(
                 "basin", "a flow at 30 m/s over a basin 40 m long and 10 m deep", 15,
                 [=](Point p) { return in_basin(p) ? 0.0 : 10.0; }, both(as_water, seeded([](Point p) {
                                                                             return Seed{p.x < 60 ? 1.0 : 0, 30, 0};
                                                                         })),
                 5),
             in_basin),
        of(on("rough-cells", "every cell up to 3 m higher or lower than its neighbour", 15,
              [](Point p) { return 3 * noise(p, 2); }),
           k_one_phase, k_energy | k_mirror),
        of(slide_on(
               "rough-lake", "a lake in a rough valley, with islands", 30,
               [](Point p) { return 0.5 * std::abs(p.y - 40) + 0.05 * p.x + 6 * noise(p, 6); }, filled(14)),
           k_volumes | k_structured, k_energy | k_rest, greatest_speed),
        of(slide_on(
               "wavy-lake", "a lake in a wavy valley, with islands", 30,
               [](Point p) {
                   constexpr double k = 9 * k_degree;  // hills 40 m apart
                   return 0.5 * std::abs(p.y - 40) + 0.05 * p.x + 3 * std::sin(k * p.x) * std::cos(k * p.y);
               },
               filled(14)),
           k_all, k_energy | k_rest, greatest_speed),
        of(slide_on(
               "integer-dtm", "elevations in whole metres, cells of 12.5 m", 60, [](Point) { return 0.0; },
               [](Setup& setup) {
                   const double cell = 12.5 * setup.bed.grid.cell_size / 2;
                   const GridSpec grid = plain_grid(std::llround(750 / cell), std::llround(500 / cell), cell);
                   setup.bed =
                       sample_raster(grid, [](Point p) { return std::round(std::max(0.0, 0.21 * (500 - p.x))); });
                   setup.seeds = fill_lattice(grid, 2, 0, [](Point p) {
                       return Seed{12 * (1 - (std::pow(p.x - 150, 2) + std::pow(p.y - 250, 2)) / (80 * 80))};
                   });
                   setup.material = dry_friction(6);
               }),
           k_one_phase, k_energy | k_mirror),  // steps of a metre are the steeper the smaller the cells
        with_gaps(
            "no-data-islands", "three gaps without ground in the path, taken as walls",
            [](Point p) {
                return std::hypot(p.x - 60, p.y - 30) < 5 || std::hypot(p.x - 75, p.y - 50) < 7 ||
                       std::hypot(p.x - 95, p.y - 38) < 4;
            },
            k_all),
        with_gaps(
            "ragged-edges", "ground with a ragged outline inside the grid, taken as walls",
            [](Point p) {
                return std::abs(p.y - 40) > 28 + 8 * std::sin(0.7 * p.x) || p.x > 130 + 6 * std::sin(1.3 * p.y) ||
                       p.x < 8 + 4 * std::sin(0.9 * p.y);
            },
            k_one_phase),
        of(slide_on(
               "leaves-all-sides", "a smooth cone: all material leaves through all sides", 60,
               [](Point p) { return 60 - 0.6 * std::hypot(p.x - 80, p.y - 40); },
               both(as_water, seeded([](Point p) { return Seed{4 - 0.4 * std::hypot(p.x - 80, p.y - 40)}; }))),
           k_one_phase, k_energy | k_mirror, remaining_volume),
    };
}

}  // namespace frana::bench
