// SPDX-License-Identifier: Apache-2.0
// Hard materials: each law's parameters from one end of their range to the other.
#include <algorithm>
#include <cmath>

#include "bench/stability/stability.h"

namespace frana::bench {
namespace {

Setup with(const std::function<void(Material&)>& change) {
    Setup setup = usual_slide();
    change(setup.material);
    return setup;
}

HardCase viscosity(const char* name, const char* what, double value) {
    return {name, what, 8, [value] { return with([=](Material& m) { m.viscosity = value; }); }};
}

HardCase yield(const char* name, const char* what, double value) {
    return {name, what, 8, [value] { return with([=](Material& m) { m.yield_stress = value; }); }};
}

HardCase turbulence(const char* name, const char* what, double value) {
    return {name, what, 15, [value] { return with([=](Material& m) { m.turbulence = value; }); }};
}

// The usual cap on a plane of 25 degrees.
Setup on_plane(double friction_deg) {
    Setup setup = usual_slide_on(2, [](Point p) { return (160 - p.x) * std::tan(25 * k_degree); });
    setup.material = dry_friction(friction_deg);
    return setup;
}

// Returns the greatest displacement of a particle from its start; the order of particles at rest does not change.
StabilityStatistic displacement(const Setup& setup, Flow& flow) {
    TimedFlow fresh(setup);
    const ParticleSet &now = flow.particles(), &start = fresh.flow().particles();
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

StabilityStatistic slab_speed(const Setup&, Flow& flow) {
    double sum = 0, n = 0;
    const ParticleSet& particles = flow.particles();
    for (std::size_t p = 0; p < particles.size(); ++p) {
        if (std::abs(particles[Field::x][p] - 60) > 10) continue;
        sum += flow.map_velocity(p).x;
        ++n;
    }
    const double cosine = std::cos(k_slab_slope * k_degree);
    const double exact = k_gravity * cosine * cosine * k_slab_time *
                         (std::tan(k_slab_slope * k_degree) - std::tan(k_slab_friction * k_degree));
    return {"speed against a rigid block's, relative error", std::abs(sum / n / exact - 1), 1e-3};
}

// Coulomb friction alone is independent of the density: the flow must be the same for ten of them, bit for bit.
StabilityStatistic ten_densities(int threads, Soundness& sound) {
    DepthAgreement agreement;
    for (const double density : {1.0, 100.0, 500.0, 1000.0, 1200.0, 1500.0, 2000.0, 2700.0, 5000.0, 20000.0}) {
        Setup setup = usual_slide();
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
                 m.viscosity = 1e4;
                 m.yield_stress = 1e4;
             });
         }},
        turbulence("turbulence-1", "xi = 1 m/s2", 1),
        turbulence("turbulence-1e9", "xi = 1e9 m/s2", 1e9),
        {"atmosphere", "surface pressure of one atmosphere", 15,
         [] { return with([](Material& m) { m.surface_pressure = 101325; }); }},
        {"steep-friction", "friction angle of 85 degrees", 15,
         [] { return with([](Material& m) { m.friction_coefficient = std::tan(85 * k_degree); }); }},
        {"rest-600s", "friction above the slope: nothing may move", 600, [] { return on_plane(40); }, displacement},
        {"just-below", "friction a tenth of a degree below the slope", k_slab_time, slab, slab_speed},
        {"ten-densities", "ten densities from 1 to 20 000 kg/m3", 8, {}, {}, ten_densities},
    };
}

}  // namespace frana::bench
