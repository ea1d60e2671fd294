// SPDX-License-Identifier: Apache-2.0
// Hard materials: each law's parameters from one end of their range to the other.
// Hard numerics: few and many particles, long steps, extreme cell sizes, other transfers.
#include <algorithm>
#include <cmath>

#include "bench/stability/usual_slide.h"
#include "physics/erosion_growth.h"
#include "physics/friction_bingham.h"
#include "physics/friction_coulomb.h"
#include "physics/friction_turbulence.h"
#include "physics/stress_bingham.h"

namespace frana::bench {
namespace {

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

Change growing() {
    return [](Setup& setup) {
        slab_of(dry_friction(15))(setup);
        setup.entrainment.erosion = GrowthErosion::word;
        setup.entrainment.of<GrowthErosion>().growth_rate = 0.01;
        setup.entrainment.erodible_depth = 5;
    };
}

// V = V_0 exp(E S) with the mean distance S along the bed, summed as by the steps; 0.02 as in the test of the law.
Figure growth(const Setup& setup, TimedFlow& run) {
    TimedFlow again(setup);
    const Model& model = again.model();
    const double before = model.volume();
    double way = 0;
    again.advance_to(run.model().time(),
                     [&](const StepStatistics& step) { way += model.momentum() / model.volume() * step.dt; });
    return {"growth against exp(E S), relative", std::abs(std::log(model.volume() / before) / (0.01 * way) - 1), 0.02};
}

}  // namespace

std::vector<HardCase> hard_material_cases() {
    using Stress = BinghamStress::Values;
    using Friction = CoulombFriction::Values;
    using Turbulence = TurbulentFriction::Values;
    return {
        slide("frictionless", "no friction at all", 10, as_water),
        of(parameter<BinghamStress>("viscosity-1e6", "1e6 Pa s", 8, &Stress::viscosity, 1e6), k_one_phase,
           k_energy | k_mirror),  // steps of a quarter on half the cells
        parameter<BinghamStress>("yield-1e5", "yield stress 1e5 Pa", 8, &Stress::yield_stress, 1e5),
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
        of(slide_on("growth", "erosion by growth on a plane", 4, plane_25, growing()), k_one_phase, 0, growth),
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

}  // namespace

std::vector<HardCase> hard_numerics_cases() {
    return {
        particles_per_cell("one-per-cell", "1 particle per cell", 1, 0),
        particles_per_cell("sixteen-per-cell", "16 particles per cell", 4, 0),
        particles_per_cell("random-particles", "4 per cell, placed at random", 2, 1),
        with_cfl("cfl-09", "Courant number 0.9", 0.9),
        with_cfl("cfl-005", "Courant number 0.05", 0.05),
        with_transfer("pic", "PIC transfer", Transfer::pic),
        with_transfer("flip", "FLIP transfer", Transfer::flip),
        scaled("half-metre", "all lengths a quarter: cells of 0.5 m", 0.25),
        scaled("forty-metres", "all lengths times 20: cells of 40 m", 20, 1e-2),
    };
}

}  // namespace frana::bench
