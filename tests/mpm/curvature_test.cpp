// SPDX-License-Identifier: Apache-2.0
// The load of the motion over a curved bed: a film too thin for its own pressure to matter moves as a point
// mass on the surface, whose speed is known exactly.
#include <gtest/gtest.h>

#include "mpm/curvature.h"
#include "physics/laws.h"
#include "support/cases.h"

namespace frana::test {
namespace {

struct Track {
    double length, cell;
    std::function<double(double)> bed, slope;
};

// Means over a film that starts around `start`, 8 m long, across a whole walled strip.
struct Rider {
    double x = 0, speed = 0;  ///< place; speed along the bed there
    double map_speed = 0;
    std::int64_t unsupported = 0;
};

Rider ride(const Track& track, double start, double speed, double friction, bool curvature, double time) {
    const GridSpec grid = bench::plain_grid(std::llround(track.length / track.cell), 6, track.cell);
    const ParticleSet seeds = bench::fill_lattice(grid, 2, 0, [&](Point p) {
        return bench::Seed{std::abs(p.x - start) < 4 ? 0.1 : 0, speed, 0};
    });
    Numerics how = numerics(Scheme::standard, SlopeCorrection::normal, Boundary::wall);
    how.curvature = curvature;
    how.flight = false;
    how.minimum_depth = 1e-7;
    how.cfl = 0.05;  // a film's waves are slow, so its steps would be long
    Material material = water();
    material.of<CoulombFriction>().friction_coefficient = friction;
    Flow flow(bench::sample_raster(grid, [&](Point p) { return track.bed(p.x); }), seeds, material, how, 1);
    Rider rider;
    while (flow.time() < time) rider.unsupported += flow.advance(time - flow.time()).nodes.unsupported;
    flow.synchronise();
    const ParticleSet& p = flow.particles();
    double volume = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const double v = p[Field::volume][i];
        volume += v;
        rider.x += v * p[Field::x][i];
        rider.map_speed += v * flow.map_velocity(i).x;
    }
    rider.x /= volume;
    rider.map_speed /= volume;
    rider.speed = rider.map_speed * std::hypot(1, track.slope(rider.x));
    return rider;
}

// A quarter of a hollow cylinder of radius 60 m, from 45 degrees down to the bottom at x = 60 m, then the
// flat.
constexpr double k_radius = 60;
Track arc(double cell) {
    const auto from_bottom = [](double x) { return std::max(0.0, k_radius - x); };
    return {80, cell, [=](double x) { return k_radius - std::sqrt(k_radius * k_radius - std::pow(from_bottom(x), 2)); },
            [=](double x) {
                const double a = from_bottom(x);
                return -a / std::sqrt(k_radius * k_radius - a * a);
            }};
}

// Speed on the arc at slope angle b of a block that started at rest at a: d(v^2)/db = -2 g R sin b + 2 mu (g
// R cos b + v^2), v^2 = C exp(2 mu b) + A cos b + B sin b.
double arc_speed(double mu, double a, double b) {
    const double m = k_gravity * k_radius / (1 + 4 * mu * mu);
    const double in_phase = 2 * m * (1 - 2 * mu * mu), off_phase = 6 * mu * m;
    const auto particular = [&](double angle) { return in_phase * std::cos(angle) + off_phase * std::sin(angle); };
    return std::sqrt(particular(b) - particular(a) * std::exp(2 * mu * (b - a)));
}

class CircularArc : public testing::TestWithParam<double> {};

TEST_P(CircularArc, SpeedIsExact) {
    const double mu = GetParam(), start = 20;
    double error[2];
    for (int level = 0; level < 2; ++level) {
        const Track track = arc(level == 0 ? 1 : 0.5);
        const Rider rider = ride(track, start, 0, mu, true, 3.5);
        ASSERT_GT(rider.x, start + 15);
        const double a = std::asin((k_radius - start) / k_radius), b = std::asin((k_radius - rider.x) / k_radius);
        error[level] = std::abs(rider.speed / arc_speed(mu, a, b) - 1);
    }
    // First order in step and cell; cells of 0.25 m and this length: 1e-4 without friction.
    EXPECT_LT(error[0], 4e-3);
    EXPECT_LT(error[1], 2e-3);
}

INSTANTIATE_TEST_SUITE_P(Friction, CircularArc, testing::Values(0.0, 0.2));

// A ridge Z = -x^2 / (2 R) around x = 40 m: v.K.v = -u^2 / R in map view, whatever the slope.
Track ridge(double radius) {
    return {80, 0.5, [=](double x) { return -(x - 40) * (x - 40) / (2 * radius); },
            [=](double x) { return -(x - 40) / radius; }};
}

TEST(Bump, TooFastForGravityItHasNoFrictionAndKeepsItsEnergy) {
    // 25 m/s over a radius of 40 m: u^2 / R = 15.6 m/s2 exceeds g.
    const Track track = ridge(40);
    const Rider rider = ride(track, 25, 25, 0.5, true, 1);
    const double before = 25 * std::hypot(1, track.slope(25)), fall = track.bed(25) - track.bed(rider.x);
    EXPECT_NEAR(rider.speed, std::sqrt(before * before + 2 * k_gravity * fall), 0.01 * before);
    EXPECT_GT(rider.unsupported, 0);
}

// Down a slope of 35 degrees, over a cliff of 68 and out on the flat, edges rounded over some 20 m: the cliff's
// steepness increases the speed along the bed, which must not remain as speed on the flat.
TEST(Curvature, SpeedAfterACliffIsThatOfItsDrop) {
    const auto rounded = [](double x) { return 5 * std::log1p(std::exp(x / 5)); };
    const auto bed = [&](double x) { return 0.7 * rounded(140 - x) + 1.8 * (rounded(140 - x) - rounded(100 - x)); };
    // Cells of 4, 2, 1 and 0.5 m: errors of 0.8, 0.4, 0.16 and 0.06 %. With the map speed kept where the bed
    // falls away faster than the motion: 28 % too fast at every cell size.
    for (const double cell : {4.0, 2.0}) {
        const Rider rider = ride({300, cell, bed, [](double) { return 0.0; }}, 20, 0, 0, true, 9);
        ASSERT_GT(rider.x, 180);
        const double exact = std::sqrt(2 * k_gravity * (bed(20) - bed(rider.x)));
        EXPECT_NEAR(rider.map_speed, exact, 0.0025 * cell * exact);
    }
}

// Velocities along the bed are linear in those in map view if the slope is uniform: there must be no difference,
// whatever the transfer to the particles.
TEST(Curvature, ChangesNothingOnAPlaneInThePaperScheme) {
    const GridSpec grid = bench::plain_grid(60, 30, 5);
    const Raster bed = bench::sample_raster(grid, [](Point p) { return 300 - p.x + 0.3 * p.y; });
    const ParticleSet seeds = bench::fill_lattice(grid, 2, 0, [](Point p) {
        const double across = std::hypot(p.x - 60, p.y - 75);
        return bench::Seed{across < 30 ? 5 - across / 8 : 0, 0.1 * (p.x - 60), -0.05 * (p.y - 75)};
    });
    for (const Transfer transfer : {Transfer::pic, Transfer::flip, Transfer::apic}) {
        const auto moved = [&](bool curvature) {
            Numerics how = numerics(Scheme::paper, SlopeCorrection::normal, Boundary::open);
            how.transfer = transfer;
            how.curvature = curvature;
            Flow flow(bed, seeds, water(), how, 1);
            for (int i = 0; i < 40; ++i) flow.advance(1);
            return flow.centroid();
        };
        const Point with = moved(true), without = moved(false);
        EXPECT_GT(without.x, 70);  // it slid
        // Rounding, amplified by 40 steps of an unstable scheme.
        EXPECT_NEAR(with.x, without.x, 1e-9 * without.x) << static_cast<int>(transfer);
        EXPECT_NEAR(with.y, without.y, 1e-9 * without.y) << static_cast<int>(transfer);
    }
}

TEST(Bump, SlowerItPressesLess) {
    // The crest itself, where the slope vanishes: du/dt = -mu (g - u^2 / R) over a time in which it moves 1.2
    // m.
    const double radius = 40, u = 12, mu = 0.5, time = 0.1;
    const Rider with = ride(ridge(radius), 40 - 0.5 * u * time, u, mu, true, time);
    const Rider without = ride(ridge(radius), 40 - 0.5 * u * time, u, mu, false, time);
    EXPECT_EQ(with.unsupported, 0);
    EXPECT_NEAR(u - with.map_speed, mu * (k_gravity - u * u / radius) * time, 0.02 * mu * k_gravity * time);
    EXPECT_NEAR(u - without.map_speed, mu * k_gravity * time, 0.02 * mu * k_gravity * time);
}

// A bowl Z = r^2 / (2 k_curve).
constexpr double k_side = 600, k_curve = 200, k_film = 0.01;
constexpr Point k_middle{k_side / 2, k_side / 2};

// Potential and kinetic energy by the bowl's own elevation and slope, per weight [m].
// @param lag of the velocities behind the positions [s]
double bowl_energy(const Flow& flow, double lag = 0) {
    const ParticleSet& particles = flow.particles();
    double sum = 0;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const Point v = flow.map_velocity(p);
        const double x = particles[Field::x][p] - lag * v.x - k_middle.x;
        const double y = particles[Field::y][p] - lag * v.y - k_middle.y;
        const double climb = (x * v.x + y * v.y) / k_curve;
        sum += particles[Field::volume][p] *
               ((x * x + y * y) / (2 * k_curve) + (v.x * v.x + v.y * v.y + climb * climb) / (2 * k_gravity));
    }
    return sum / flow.volume();
}

// A film without friction that moves round a bowl for 30 s. A scheme of first order in time gains energy in proportion
// to the step: 3.3 % at a Courant number of 0.5. The bound of 1 % is a third of that.
TEST(Bowl, KeepsItsEnergyWhateverTheStep) {
    const GridSpec grid = bench::plain_grid(60, 60, 10);
    const ParticleSet seeds = bench::fill_lattice(grid, 2, 0, [](Point p) {
        return bench::Seed{std::hypot(p.x - k_middle.x - 180, p.y - k_middle.y) < 12 ? k_film : 0, 0, 20};
    });
    const Raster bed = bench::sample_raster(
        grid, [](Point p) { return (std::pow(p.x - k_middle.x, 2) + std::pow(p.y - k_middle.y, 2)) / (2 * k_curve); });
    for (const double cfl : {0.2, 0.5, 0.8}) {
        Numerics how = numerics(Scheme::standard, SlopeCorrection::normal, Boundary::open);
        how.minimum_depth = 1e-6;
        how.cfl = cfl;
        Flow flow(bed, seeds, water(), how, 1);
        const double start = bowl_energy(flow);
        double worst = 0;
        while (flow.time() < 30) {
            const double dt = flow.advance(30 - flow.time()).dt;
            worst = std::max(worst, std::abs(bowl_energy(flow, 0.5 * dt) / start - 1));
        }
        EXPECT_LT(worst, 0.01) << cfl;
    }
}

// On a plane the curvature is zero up to rounding, and a quadric's is exact.
TEST(CurvatureLoad, IsExactOnQuadrics) {
    const GridSpec grid = bench::plain_grid(9, 9, 2);
    const NodeGrid nodes(bench::sample_raster(
        grid, [](Point p) { return 3 * p.x - 2 * p.y + 0.05 * p.x * p.x + 0.02 * p.x * p.y - 0.03 * p.y * p.y; }));
    EXPECT_NEAR(bed_curvature(nodes, nodes.index(4, 4), 4 + k_ghost, 4 + k_ghost).load(7, -3),
                49 * 0.1 + 2 * 7 * -3 * 0.02 - 9 * 0.06, 1e-12);
}

}  // namespace
}  // namespace frana::test
