// SPDX-License-Identifier: Apache-2.0
// The first model by finite volumes: rest, exact motions, budgets, and what makes a run trustworthy.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "physics/laws.h"
#include "simulation/finite_volume_flow.h"
#include "simulation/stepped_run.h"
#include "support/cases.h"
#include "support/hollows.h"

namespace frana::test {
namespace {

Numerics volumes(Boundary boundary, SlopeCorrection slope = SlopeCorrection::normal) {
    return numerics(Scheme::finite_volume, slope, boundary);
}

FiniteVolumeFlow flow_on(const Raster& bed, const ParticleSet& seeds, const Material& material,
                         const Numerics& numerics, int threads = 1) {
    return FiniteVolumeFlow(bed, std::nullopt, seeds, material, numerics, threads);
}

// One column in each cell, as deep as the ground lies below a level.
ParticleSet filled_to(const Raster& bed, double level) {
    return bench::fill_lattice(bed.grid, 1, 0, [&](Point p) {
        const Cell cell = cell_of(bed.grid, p);
        return bench::Seed{level - bed.at(cell.row, cell.column)};
    });
}

double greatest_speed(const FiniteVolumeFlow& flow) {
    double speed = 0;
    flow.for_each_active_node([&](std::size_t k) { speed = std::max(speed, flow.motion_of(k).speed); });
    return speed;
}

// A basin with waves of the ground and noise, from whose water islands rise.
Raster rough_basin(unsigned seed, double noise) {
    std::mt19937 random(seed);
    std::normal_distribution<double> height(0, noise);
    std::vector<double> waves;
    std::uniform_real_distribution<double> number(0.02, 0.3);
    for (int i = 0; i < 24; ++i) waves.push_back(number(random));
    return bench::sample_raster(bench::plain_grid(80, 80, 5), [&](Point p) {
        double z = 60 * ((p.x - 200) * (p.x - 200) + (p.y - 200) * (p.y - 200)) / (200 * 200) + height(random);
        for (std::size_t i = 0; i < waves.size(); i += 4)
            z += 3 * std::sin(waves[i] * p.x + 20 * waves[i + 1]) * std::cos(waves[i + 2] * p.y + 20 * waves[i + 3]);
        return z;
    });
}

// Ten minutes without friction. Rounding alone gives 1e-13 m/s at 30 m of depth; what grows by itself reaches 1e-1
// within that time, as slopes of depth and surface limited each for itself do.
TEST(FiniteVolumes, ALakeOnRoughGroundStaysAtRest) {
    const Raster bed = rough_basin(1, 1);
    FiniteVolumeFlow flow = flow_on(bed, filled_to(bed, 25), water(), volumes(Boundary::wall));
    const double volume = flow.volume();
    flow.advance_to(600);
    EXPECT_LT(greatest_speed(flow), 1e-12);
    EXPECT_NEAR(flow.volume(), volume, 1e-13 * volume);
}

// Noise of 4 m from cell to cell on 5 m: slopes of 70 degrees on the ground of the lake.
TEST(FiniteVolumes, ALakeOnVeryRoughGroundIsDisturbedByRoundingOnly) {
    const Raster bed = rough_basin(4, 4);
    FiniteVolumeFlow flow = flow_on(bed, filled_to(bed, 25), water(), volumes(Boundary::wall));
    flow.advance_to(600);
    EXPECT_LT(greatest_speed(flow), 1e-10);
}

// An island with slopes of up to 78 degrees in water 50 cells deep. What smooths velocities along two different beds
// drives waves: 8 m/s after 4 s.
TEST(FiniteVolumes, ALakeRoundASteepIslandStaysAtRest) {
    for (const double cell : {0.5, 0.2}) {
        const Raster bed = bench::sample_raster(
            bench::plain_grid(std::llround(10 / cell), std::llround(10 / cell), cell),
            [](Point p) { return 13 * std::exp(-0.4 * ((p.x - 5) * (p.x - 5) + (p.y - 5) * (p.y - 5))); });
        FiniteVolumeFlow flow = flow_on(bed, filled_to(bed, 10), water(), volumes(Boundary::wall));
        flow.advance_to(20);
        EXPECT_LT(greatest_speed(flow), 1e-12) << cell;
    }
}

// A slab down a plane: ds/dt = g (sin - mu cos) - g s^2 / (xi d), s = s_t tanh(a t / s_t). The middle is beyond the
// reach of its ends.
TEST(FiniteVolumes, ASlabMovesAsABlock) {
    for (const double angle : {20.0, 35.0, 45.0}) {
        constexpr double k_friction = 0.2, k_turbulence = 500, k_time = 8;
        const double sine = std::sin(angle * M_PI / 180), cosine = std::cos(angle * M_PI / 180);
        const GridSpec grid = bench::plain_grid(160, 6, 5);
        const Raster bed = bench::sample_raster(grid, [&](Point p) { return (800 - p.x) * sine / cosine; });
        const ParticleSet seeds =
            bench::fill_lattice(grid, 1, 0, [](Point p) { return bench::Seed{p.x < 500 ? 1.0 : 0.0}; });
        Material material = water();
        material.of<CoulombFriction>().friction_coefficient = k_friction;
        material.of<TurbulentFriction>().turbulence = k_turbulence;
        FiniteVolumeFlow flow = flow_on(bed, seeds, material, volumes(Boundary::wall));
        flow.advance_to(k_time);
        const double drive = k_gravity * (sine - k_friction * cosine),
                     terminal = std::sqrt(drive * k_turbulence * cosine / k_gravity);
        const double exact = terminal * std::tanh(drive * k_time / terminal);
        const std::size_t middle = flow.nodes().index(75, 3);
        EXPECT_NEAR(flow.motion_of(middle).speed, exact, 1e-3 * exact) << angle;
    }
}

// A film without friction round an arc keeps its speed but for the error of the slopes at a cell of 2 m.
TEST(FiniteVolumes, AFilmKeepsItsSpeedRoundAnArc) {
    constexpr double k_radius = 100, k_speed = 30;
    const double half = std::sqrt(0.5);
    const GridSpec grid = bench::plain_grid(220, 6, 2);
    // From 45 degrees over an arc to level ground.
    const Raster bed = bench::sample_raster(grid, [&](Point p) {
        const double x = p.x - 120, end = k_radius * half;
        if (x < 0) return k_radius * (1 - half) - x;
        return x < end ? k_radius - std::sqrt(k_radius * k_radius - (end - x) * (end - x)) : 0;
    });
    const ParticleSet seeds = bench::fill_lattice(grid, 1, 0, [&](Point p) {
        return p.x < 60 ? bench::Seed{0.02, k_speed * half, 0} : bench::Seed{};
    });
    FiniteVolumeFlow flow = flow_on(bed, seeds, water(), volumes(Boundary::wall));
    const double energy = 0.5 * k_speed * k_speed;
    flow.advance_to(7);
    double volume = 0, kinetic = 0, fallen = 0;
    flow.for_each_active_node([&](std::size_t k) {
        const auto node = static_cast<std::int64_t>(k);
        const Point at = flow.nodes().middle(node % flow.nodes().stride(), node / flow.nodes().stride());
        if (at.x < 210) return;
        const double h = flow.state().depth[k], s = flow.motion_of(k).speed;
        volume += h;
        kinetic += h * 0.5 * s * s;
        fallen += 1;
    });
    ASSERT_GT(fallen, 50);
    // All of it began between 60 m and 120 m above the plain.
    const double least = energy + k_gravity * (k_radius * (1 - half) + 60),
                 most = energy + k_gravity * (k_radius * (1 - half) + 120);
    EXPECT_GT(kinetic / volume, 0.98 * least);
    EXPECT_LT(kinetic / volume, 1.001 * most);
}

// A film of 1 m without friction falls 200 m down one face of a valley and climbs the other: height of its middle over
// its fall. At the corner the ground of a cell rises by more than the film is deep, but not more than its energy.
TEST(FiniteVolumes, AFilmClimbsTheOtherSideOfAValleyAsHighAsItFell) {
    constexpr double k_fall = 200, k_top = 100;
    constexpr double k_faces[][2] = {{30, 45}, {20, 50}, {30, 60}, {60, 20}};
    for (const auto& [down_deg, up_deg] : k_faces)
        for (const double cell : {5.0, 2.5}) {
            const double down = std::tan(down_deg * M_PI / 180), up = std::tan(up_deg * M_PI / 180);
            const double foot = k_top + k_fall / down, length = foot + 1.6 * k_fall / up;
            const GridSpec grid = bench::plain_grid(std::llround(length / cell), 4, cell);
            const Raster bed = bench::sample_raster(
                grid, [&](Point p) { return p.x < foot ? (foot - p.x) * down : (p.x - foot) * up; });
            const ParticleSet seeds = bench::fill_lattice(
                grid, 1, 0, [&](Point p) { return bench::Seed{p.x > k_top && p.x < k_top + 20 ? 1.0 : 0.0}; });
            FiniteVolumeFlow flow = flow_on(bed, seeds, water(), volumes(Boundary::wall));
            const auto middle = [&] {
                double volume = 0, height = 0;
                flow.for_each_active_node([&](std::size_t k) {
                    volume += flow.state().depth[k];
                    height += flow.state().depth[k] * flow.nodes().bed[k];
                });
                return height / volume;
            };
            const double start = middle();
            double lowest = start, highest = 0;
            const double time = std::sqrt(2 * k_fall / k_gravity) *
                                (1 / std::sin(down_deg * M_PI / 180) + 1 / std::sin(up_deg * M_PI / 180));
            while (flow.time() < 1.1 * time) {
                flow.step(1);
                lowest = std::min(lowest, middle());
                if (lowest < 0.5 * start) highest = std::max(highest, middle());
            }
            EXPECT_GT(highest, 0.93 * start) << down_deg << '/' << up_deg << ", " << cell;
            EXPECT_LT(highest, 1.03 * start) << down_deg << '/' << up_deg << ", " << cell;
        }
}

// Water of 4 m over a cliff. With the mean slope of both sides the cell at its lip would dam it, the more the finer the
// cells: to 13 m on 1.25 m under a cliff of 5 m, so that the flow stops.
TEST(FiniteVolumes, TheLipOfACliffNeitherDamsNorAccelerates) {
    for (const double cell : {10.0, 5.0, 2.5, 1.25})
        for (const double cliff : {5.0, 50.0, 150.0}) {
            constexpr double k_edge = 400, k_depth = 4;
            const GridSpec grid = bench::plain_grid(std::llround(500 / cell), 4, cell);
            const Raster bed = bench::sample_raster(grid, [&](Point p) {
                return p.x < k_edge ? cliff + std::tan(M_PI / 18) * (k_edge - p.x)
                                    : std::tan(M_PI / 36) * (k_edge - p.x);
            });
            const ParticleSet seeds = bench::fill_lattice(
                grid, 1, 0, [&](Point p) { return bench::Seed{p.x > 20 && p.x < 380 ? k_depth : 0.0}; });
            FiniteVolumeFlow flow = flow_on(bed, seeds, water(), volumes(Boundary::open));
            flow.advance_to(10);
            const auto lip = std::llround(k_edge / cell) - 1;
            const auto at = [&](std::int64_t column) { return flow.nodes().index(column, 2); };
            const double before = flow.motion_of(at(lip - 1)).speed, there = flow.motion_of(at(lip)).speed,
                         below = flow.motion_of(at(lip + 2)).speed;
            EXPECT_GT(there, before / 1.2) << cliff << ", " << cell;
            EXPECT_LT(there, before * 1.2) << cliff << ", " << cell;
            EXPECT_LT(flow.state().depth[at(lip)], 1.2 * k_depth) << cliff << ", " << cell;
            // At the foot of a cliff it loses the speed of its fall; over a step that cells cannot tell from a slope it
            // keeps that. Besides, what the head of the water's depth adds.
            const double kept = cliff > 1.2 * cell && cliff > k_depth ? 0 : 2 * k_gravity * cliff;
            EXPECT_GT(below * below, 0.9 * (before * before + kept)) << cliff << ", " << cell;
            EXPECT_LT(below * below, before * before + kept + 4 * k_gravity * k_depth) << cliff << ", " << cell;
        }
}

// Over an open edge whose last strip has a single row (15 rows and 15 more than a tile's 16), what leaves is counted.
TEST(FiniteVolumes, WhatLeavesThroughAStripOfOneRowIsCounted) {
    for (const int rows : {15, 16, 31}) {
        const Raster bed =
            bench::sample_raster(bench::plain_grid(30, rows, 5), [](Point p) { return 0.1 * p.x + 0.05 * p.y; });
        const ParticleSet seeds = bench::fill_lattice(bed.grid, 1, 0, [](Point) { return bench::Seed{5}; });
        FiniteVolumeFlow flow = flow_on(bed, seeds, water(), volumes(Boundary::open));
        const double volume = flow.volume();
        flow.advance_to(10);
        EXPECT_GT(flow.volume_left(), 0.1 * volume) << rows;
        EXPECT_NEAR(flow.volume() + flow.volume_left(), volume, 1e-12 * volume) << rows;
    }
}

// The wall of a basin, a pit or a dam takes what is normal to it: what they keep, or let pass, changes by less than 5 %
// from cells of 5 m to 1.25 m (2.5 m). What climbed walls as it climbs slopes left nothing in the basin, on any cells.
TEST(FiniteVolumes, ABasinAPitAndADamKeepTheSameOnAllCells) {
    const auto kept = [](const Hollow& hollow, double friction_deg) {
        FiniteVolumeFlow flow =
            flow_on(hollow.bed, hollow.seeds(1), dry_friction(friction_deg), volumes(Boundary::wall));
        const double volume = flow.volume();
        flow.advance_to(hollow.time);
        double trapped = 0;
        flow.for_each_active_node([&](std::size_t k) {
            const auto node = static_cast<std::int64_t>(k);
            const NodeGrid& nodes = flow.nodes();
            if (hollow.inside(nodes.middle(node % nodes.stride(), node / nodes.stride())))
                trapped += nodes.cell_size() * nodes.cell_size() * flow.state().depth[k];
        });
        return trapped / volume;
    };
    const double in_basin = kept(basin(5), 0), in_pit = kept(pit(5), 5.7), over_dam = kept(dam(5), 0);
    EXPECT_GT(in_basin, 0.5);
    EXPECT_GT(in_pit, 0.4);
    EXPECT_NEAR(kept(basin(1.25), 0), in_basin, 0.05 * in_basin);
    EXPECT_NEAR(kept(pit(1.25), 5.7), in_pit, 0.05 * in_pit);
    EXPECT_LT(over_dam, 0.5);
    EXPECT_NEAR(kept(dam(2.5), 0), over_dam, 0.05 * over_dam);
}

// What friction holds does not change by a bit, and costs nothing.
TEST(FiniteVolumes, APileAtRestStaysToTheBit) {
    const GridSpec grid = bench::plain_grid(60, 60, 2);
    const Raster bed = bench::sample_raster(grid, [](Point p) { return 0.1 * p.x + 0.3 * std::sin(p.y); });
    const ParticleSet seeds =
        bench::fill_lattice(grid, 1, 0, [](Point p) { return bench::Seed{6 - 0.4 * std::hypot(p.x - 60, p.y - 60)}; });
    FiniteVolumeFlow flow = flow_on(bed, seeds, dry_friction(25), volumes(Boundary::open));
    flow.advance_to(40);
    ASSERT_EQ(greatest_speed(flow), 0);
    const std::vector<double> before(flow.state().depth.data(), flow.state().depth.data() + flow.state().depth.size());
    flow.advance_to(100);
    EXPECT_TRUE(std::equal(before.begin(), before.end(), flow.state().depth.data()));
    EXPECT_EQ(flow.state().n_strips, 0U);
}

// A flow that divides, meets walls and leaves through an edge, on noisy ground.
TEST(FiniteVolumes, VolumeIsKeptThroughEdgesAndPassesNoWall) {
    const GridSpec grid = bench::plain_grid(150, 90, 2);
    std::mt19937 random(5);
    std::normal_distribution<double> noise(0, 0.3);
    const Raster bed = bench::sample_raster(
        grid, [&](Point p) { return 0.4 * (300 - p.x) + 2 * std::sin(0.1 * p.y) + noise(random); });
    Raster walls(grid, 0);
    for (std::int64_t r = 30; r < 60; ++r) walls.at(r, 60) = 1;
    const ParticleSet seeds =
        bench::fill_lattice(grid, 2, 0, [](Point p) { return bench::Seed{8 - 0.2 * std::hypot(p.x - 60, p.y - 80)}; });
    Material material = dry_friction(8);
    material.of<TurbulentFriction>().turbulence = 800;
    FiniteVolumeFlow flow(bed, walls, seeds, material, volumes(Boundary::open), 1);
    const double volume = flow.volume();
    flow.advance_to(20);
    EXPECT_GT(flow.volume_left(), 0.01 * volume);
    EXPECT_NEAR(flow.volume() + flow.volume_left(), volume, 1e-13 * volume);  // rounding of sums
    const Raster end = flow.snapshot().depth;
    for (std::int64_t r = 30; r < 60; ++r) EXPECT_TRUE(std::isnan(end.at(r, 60)));
}

// Eroded and deposited volumes are those of the bed.
TEST(FiniteVolumes, ExchangeWithTheBedIsInTheBudget) {
    const GridSpec grid = bench::plain_grid(100, 40, 2);
    const Raster bed = bench::sample_raster(grid, [](Point p) { return 0.5 * std::max(0.0, 120 - p.x); });
    const ParticleSet seeds =
        bench::fill_lattice(grid, 2, 0, [](Point p) { return bench::Seed{4 - 0.2 * std::hypot(p.x - 30, p.y - 40)}; });
    Entrainment entrainment;
    entrainment.erosion = "growth";
    entrainment.of<GrowthErosion>().growth_rate = 0.02;
    entrainment.erodible_depth = 0.5;
    entrainment.detrainment = true;
    entrainment.of<ForestDetrainment>().detrainment_coefficient = 500;
    FiniteVolumeFlow flow(bed, std::nullopt, seeds, dry_friction(10), volumes(Boundary::open), 1, {}, entrainment);
    const double start = flow.volume();
    flow.advance_to(8);
    const BedBudget budget = flow.bed_budget();
    EXPECT_GT(budget.deposited, 0.02 * start);
    EXPECT_GT(budget.eroded, 0.02 * start);
    EXPECT_NEAR(flow.volume() + flow.volume_left(), start + budget.eroded - budget.deposited, 1e-12 * start);
}

// Free fall from the highest surface and the front of a dam break bound every speed.
TEST(FiniteVolumes, NoCellIsFasterThanItsFall) {
    for (const unsigned seed : {1U, 2U, 3U}) {
        std::mt19937 random(seed);
        std::normal_distribution<double> noise(0, 1.5);
        const GridSpec grid = bench::plain_grid(120, 60, 5);
        const Raster bed = bench::sample_raster(grid, [&](Point p) {
            return 0.7 * std::max(0.0, 500 - p.x) + 0.01 * (p.y - 150) * (p.y - 150) + noise(random);
        });
        const ParticleSet seeds = bench::fill_lattice(
            grid, 1, 0, [](Point p) { return bench::Seed{std::hypot(p.x - 60, p.y - 150) < 40 ? 3.0 : 0.0}; });
        FiniteVolumeFlow flow = flow_on(bed, seeds, dry_friction(15), volumes(Boundary::open));
        double fastest = 0;
        while (flow.time() < 30) fastest = std::max(fastest, flow.step(1).max_speed);
        EXPECT_LT(fastest, std::sqrt(2 * k_gravity * (0.7 * 500 + 10)));
        EXPECT_GT(fastest, 20);
    }
}

// What leaves the ground of a slope of 30 degrees on cells of 5 m, of the whole volume: over a cliff and of noise.
struct Thrown {
    double by_cells = 0, by_particles = 0;
};
Thrown thrown(double cliff, double roughness) {
    const GridSpec grid = bench::plain_grid(160, 40, 5);
    std::mt19937 random(7);
    std::normal_distribution<double> noise(0, roughness);
    const Raster bed = bench::sample_raster(
        grid, [&](Point p) { return std::tan(M_PI / 6) * (800 - p.x) + (p.x < 400 ? cliff : 0) + noise(random); });
    const ParticleSet seeds = bench::fill_lattice(
        grid, 2, 0, [](Point p) { return bench::Seed{4 - 0.1 * std::hypot(p.x - 100, p.y - 100)}; });
    Material material = dry_friction(15);
    material.of<TurbulentFriction>().turbulence = 1000;
    Flow particles(bed, seeds, material, numerics(Scheme::standard, SlopeCorrection::normal, Boundary::open), 2);
    particles.advance_to(50);
    FiniteVolumeFlow cells = flow_on(bed, seeds, material, volumes(Boundary::open), 2);
    const double volume = cells.volume();
    cells.advance_to(50);
    return {cells.state().jumps.volume / volume, particles.flights().statistics().volume / volume};
}

TEST(FiniteVolumes, TellOfAboutAsMuchAsACliffThrowsOfParticles) {
    for (const double cliff : {20.0, 40.0, 60.0, 100.0}) {
        const Thrown volume = thrown(cliff, 0);
        EXPECT_GT(volume.by_particles, 0.1) << cliff;
        EXPECT_NEAR(volume.by_cells, volume.by_particles, 0.2 * volume.by_particles) << cliff;
    }
}

TEST(FiniteVolumes, TellOfNothingOnSlopesThatThrowNothing) {
    EXPECT_EQ(thrown(0, 0).by_cells, 0);
    EXPECT_LT(thrown(12, 0).by_cells, 0.01);
    const Thrown rough = thrown(0, 0.3);
    EXPECT_LT(rough.by_cells, 0.01);
    EXPECT_LT(rough.by_particles, 0.01);
}

struct Slid {
    double fastest = 0, front = 0;  // [m/s], [m]
};
// A pile of 30 m on a plane of 33.3 degrees with friction of 34 slumps, and stops where its surface is no steeper.
template <class Model>
Slid slide(Model& flow, double end) {
    Slid slid;
    while (flow.time() < end) slid.fastest = std::max(slid.fastest, flow.step(1).max_speed);
    const Raster depth = flow.snapshot().depth;
    for (std::int64_t c = 0; c < depth.grid.columns; ++c)
        if (depth.at(4, c) > 0.1) slid.front = depth.grid.cell_size * static_cast<double>(c);
    return slid;
}

// The other method's front and speed, for steps of any length. What is held and yet pulled by the predictor creeps on
// for ten minutes; the weight g / n of a steep front gives 12 m/s; friction of the mass after a step 8.1 m/s in long
// steps.
TEST(FiniteVolumes, APileOnASlopeAboutAsSteepAsItsFrictionSlumpsAndStops) {
    const Raster bed = bench::sample_raster(bench::plain_grid(170, 8, 10),
                                            [](Point p) { return std::tan(33.3 * M_PI / 180) * (1700 - p.x); });
    const ParticleSet seeds = bench::fill_lattice(bed.grid, 2, 0, [](Point p) {
        const double x = (p.x - 450) / 200;
        return bench::Seed{std::max(0.0, 30 * (1 - x * x))};
    });
    Material material = dry_friction(34);
    material.of<TurbulentFriction>().turbulence = 200;
    Flow particles(bed, seeds, material, numerics(Scheme::standard, SlopeCorrection::normal, Boundary::wall), 1);
    const Slid reference = slide(particles, 220);
    for (const double cfl : {0.8, 0.2}) {
        Numerics numerics = volumes(Boundary::wall);
        numerics.cfl = cfl;
        FiniteVolumeFlow flow = flow_on(bed, seeds, material, numerics);
        const Slid slid = slide(flow, 220);
        EXPECT_NEAR(slid.front, reference.front, 20) << cfl;  // two cells
        EXPECT_NEAR(slid.fastest, reference.fastest, 0.03 * reference.fastest) << cfl;
        EXPECT_LT(greatest_speed(flow), 0.1) << cfl;
    }
}

// Over waves of 6 cells in both directions a flow loses energy by friction and gains none.
TEST(FiniteVolumes, RoughGroundGivesNoEnergy) {
    const Raster bed = bench::sample_raster(bench::plain_grid(150, 80, 10), [](Point p) {
        const double k = 2 * M_PI / 60;
        return std::tan(33.3 * M_PI / 180) * (1500 - p.x) + std::sin(k * p.x) * std::sin(k * p.y);
    });
    const ParticleSet seeds = bench::fill_lattice(bed.grid, 1, 0, [](Point p) {
        const double x = (p.x - 450) / 200, y = (p.y - 400) / 130;
        return bench::Seed{std::max(0.0, 30 * (1 - x * x - y * y))};
    });
    FiniteVolumeFlow flow = flow_on(bed, seeds, dry_friction(34), volumes(Boundary::open));
    EnergyWatch watch;
    while (flow.time() < 60) watch.add(flow.step(1));
    ASSERT_TRUE(watch.error());
    EXPECT_LT(*watch.error(), 1e-3);
}

// On a slope that becomes gentle the rim of a deposit lies where the ground is steeper than its friction. Each step
// gives it a speed, and waves carry back what passes its faces: its friction, at that speed, would be 5 % of the
// energy.
TEST(FiniteVolumes, FrictionWorksOnWhatPassesOnly) {
    const double steep = std::tan(M_PI / 6), gentle = 0.05;
    const Raster bed = bench::sample_raster(bench::plain_grid(100, 30, 10), [&](Point p) {
        const double bend = std::clamp(p.x - 500, 0.0, 300.0), beyond = std::max(p.x - 800, 0.0);
        return 600 - steep * std::min(p.x, 800.0) + (steep - gentle) * bend * bend / 600 - gentle * beyond;
    });
    const ParticleSet seeds = bench::fill_lattice(bed.grid, 1, 0, [](Point p) {
        return bench::Seed{std::hypot((p.x - 200) / 40, (p.y - 150) / 60) < 1 ? 1.0 : 0.0};
    });
    Material material = water();
    material.of<CoulombFriction>().friction_coefficient = 0.15;
    material.of<TurbulentFriction>().turbulence = 1400;
    FiniteVolumeFlow flow = flow_on(bed, seeds, material, volumes(Boundary::open));
    flow.set_moving_speed(0.1);
    EnergyWatch watch;
    StepStatistics last;
    for (; flow.time() < 600; watch.add(last)) last = flow.step(10);
    ASSERT_TRUE(watch.error());
    EXPECT_LT(*watch.error(), 0.01);
    EXPECT_LT(last.moving, 0.08 * last.volume);
}

// Between two times the potential energy lost is what is gained in motion and lost to friction, but for what the ends
// of the slab lose; none is gained.
TEST(FiniteVolumes, EnergiesOfASlabAreInBalance) {
    const GridSpec grid = bench::plain_grid(200, 6, 5);
    const Raster bed = bench::sample_raster(grid, [](Point p) { return 0.5 * (1000 - p.x); });
    const ParticleSet seeds =
        bench::fill_lattice(grid, 1, 0, [](Point p) { return bench::Seed{p.x > 100 && p.x < 500 ? 1.0 : 0.0}; });
    Material material = dry_friction(10);
    material.of<TurbulentFriction>().turbulence = 500;
    FiniteVolumeFlow flow = flow_on(bed, seeds, material, volumes(Boundary::wall));
    EnergyWatch watch;
    StepStatistics first = flow.step(10), last = first;
    double dissipated = 0.5 * first.energy_dissipated;
    for (watch.add(first); flow.time() < 8; watch.add(last)) {
        dissipated += 0.5 * last.energy_dissipated;
        last = flow.step(10);
        dissipated += 0.5 * last.energy_dissipated;
    }
    dissipated -= 0.5 * first.energy_dissipated;
    const double fallen = first.energy - first.energy_moving - (last.energy - last.energy_moving);
    EXPECT_GT(last.energy_moving, 0.2 * fallen);
    EXPECT_NEAR(last.energy_moving - first.energy_moving + dissipated, fallen, 0.005 * fallen);
    ASSERT_TRUE(watch.error());
    EXPECT_LT(*watch.error(), 1e-3);
}

}  // namespace
}  // namespace frana::test
