// SPDX-License-Identifier: Apache-2.0
// Pore pressure as a value of the cells: consolidation, carrying, and what it does to friction.
#include <gtest/gtest.h>

#include <cmath>

#include "physics/laws.h"
#include "simulation/finite_volume_flow.h"
#include "support/cases.h"

namespace frana::test {
namespace {

Numerics cells_within(Boundary boundary) {
    return numerics(Scheme::finite_volume, SlopeCorrection::normal, boundary);
}

Material debris(double ratio) {
    Material m = dry_friction(20);
    m.density = 2000;
    m.of<CoulombFriction>().pore_pressure_ratio = ratio;
    return m;
}

struct Ratios {
    double least = 1, greatest = 0;
    double carried = 0;  ///< sum of V r [m3]
};
Ratios ratios(const FiniteVolumeFlow& flow) {
    Ratios all;
    flow.for_each_active_node([&](std::size_t k) {
        if (!(flow.state().depth[k] > 0)) return;
        const double r = flow.state().carried[0][k] / flow.state().depth[k];
        all.least = std::min(all.least, r);
        all.greatest = std::max(all.greatest, r);
        all.carried += flow.state().carried[0][k] * flow.state().cell_area();
    });
    return all;
}

// The first mode of Terzaghi's consolidation, exact for any steps: some hundred of them round 1e-16 each.
TEST(PorePressureByFiniteVolumes, ConsolidatesWithTheSquareOfTheThickness) {
    Material m = debris(0.9);
    m.of<CoulombFriction>().pore_fluid_density = 1000;
    m.of<CoulombFriction>().hydraulic_diffusivity = 0.05;
    const GridSpec grid = bench::plain_grid(20, 20, 1);
    for (const double depth : {0.5, 2.0}) {
        const ParticleSet seeds = bench::fill_lattice(grid, 1, 0, [&](Point) { return bench::Seed{depth}; });
        FiniteVolumeFlow flow(Raster(grid), std::nullopt, seeds, m, cells_within(Boundary::wall), 1);
        flow.advance_to(7.3);
        const double exact = 0.5 + 0.4 * std::exp(-M_PI * M_PI * 0.05 * 7.3 / (4 * depth * depth));
        EXPECT_NEAR(ratios(flow).least, exact, 1e-12) << depth;
        EXPECT_NEAR(ratios(flow).greatest, exact, 1e-12) << depth;
        EXPECT_EQ(flow.momentum(), 0);
    }
}

// Seeds whose ratio depends on the place.
ParticleSet with_ratios(const ParticleSet& plain, const std::function<double(Point)>& ratio) {
    ParticleSet seeds(plain.mask() | FieldMask{Field::pore_pressure});
    for (std::size_t p = 0; p < plain.size(); ++p) {
        ParticleRow row = plain.row(p);
        get(row, Field::pore_pressure) = ratio({get(row, Field::x), get(row, Field::y)});
        seeds.push_back(row);
    }
    return seeds;
}

// A pile that collapses on a slope carries the sum of V r with it, and no cell has another ratio than was released.
TEST(PorePressureByFiniteVolumes, IsCarriedByVolume) {
    const GridSpec grid = bench::plain_grid(120, 90, 2);
    const Raster bed = bench::sample_raster(
        grid, [](Point p) { return 0.3 * (240 - p.x) + std::sin(0.2 * p.x) * std::cos(0.3 * p.y); });
    const ParticleSet seeds = with_ratios(
        bench::fill_lattice(grid, 1, 0, [](Point p) { return bench::Seed{8 - 0.2 * std::hypot(p.x - 60, p.y - 80)}; }),
        [](Point p) { return p.x < 60 ? 0.2 : 0.8; });
    for (const int threads : {1, 2}) {
        FiniteVolumeFlow flow(bed, std::nullopt, seeds, debris(0.5), cells_within(Boundary::wall), threads);
        const double before = ratios(flow).carried;
        flow.advance_to(12);
        EXPECT_NEAR(ratios(flow).carried, before, 1e-12 * before);
        EXPECT_GE(ratios(flow).least, 0.2 - 1e-12);
        EXPECT_LE(ratios(flow).greatest, 0.8 + 1e-12);
    }
}

// The middle of a slab on a plane whose pressure dissipates: v' = g (sin - mu (1 - r) cos), r = r_0 exp(-t / T), by
// both schemes.
TEST(PorePressureByFiniteVolumes, SlidesABlockAsWithParticles) {
    constexpr double k_steep = 25 * M_PI / 180, k_friction = 0.4, k_ratio = 0.7, k_dissipation = 3, k_end = 5;
    const GridSpec grid = bench::plain_grid(200, 6, 2);
    const Raster bed = bench::sample_raster(grid, [](Point p) { return (400 - p.x) * std::tan(k_steep); });
    const ParticleSet seeds =
        bench::fill_lattice(grid, 2, 0, [](Point p) { return bench::Seed{p.x > 20 && p.x < 240 ? 1.0 : 0.0}; });
    Material m = debris(k_ratio);
    m.of<CoulombFriction>().friction_coefficient = k_friction;
    m.of<CoulombFriction>().pore_dissipation_time = k_dissipation;
    const double exact = k_gravity * (std::sin(k_steep) * k_end -
                                      k_friction * std::cos(k_steep) *
                                          (k_end - k_ratio * k_dissipation * (1 - std::exp(-k_end / k_dissipation))));
    FiniteVolumeFlow flow(bed, std::nullopt, seeds, m, cells_within(Boundary::wall), 1);
    flow.advance_to(k_end);
    const double by_cells = flow.motion_of(flow.nodes().index(90, 3)).speed;
    EXPECT_NEAR(by_cells, exact, 2e-3 * exact);
    Flow particles(bed, seeds, m, numerics(Scheme::standard, SlopeCorrection::normal, Boundary::wall), 1);
    particles.advance_to(k_end);
    double sum = 0;
    int count = 0;
    for (std::size_t p = 0; p < particles.particles().size(); ++p) {
        if (std::abs(particles.particles()[Field::x][p] - 180) > 10) continue;
        sum += particles.map_velocity(p).x / std::cos(k_steep);
        ++count;
    }
    EXPECT_NEAR(by_cells, sum / count, 5e-3 * exact);
}

// What is eroded brings the pore pressure of the bed: the sum of V r grows by it alone.
TEST(PorePressureByFiniteVolumes, IsMixedWithThatOfErodedMaterial) {
    Entrainment e;
    e.erosion = "growth";
    e.of<GrowthErosion>().growth_rate = 0.01;
    e.erodible_depth = 5;
    e.of<MechanicalErosion>().bed_pore_pressure_ratio = 0.3;
    const GridSpec grid = bench::plain_grid(120, 20, 1);
    const Raster bed = bench::sample_raster(grid, [](Point p) { return 0.4 * (120 - p.x); });
    const ParticleSet seeds = bench::fill_lattice(
        grid, 1, 0, [](Point p) { return bench::Seed{p.x > 20 && p.x < 40 && p.y > 5 && p.y < 15 ? 1.0 : 0}; });
    FiniteVolumeFlow flow(bed, std::nullopt, seeds, debris(0.8), cells_within(Boundary::wall), 1, {}, e);
    const double before = ratios(flow).carried;
    flow.advance_to(4);
    const double eroded = flow.bed_budget().eroded;
    ASSERT_GT(eroded, 0.05 * flow.volume());
    EXPECT_NEAR(ratios(flow).carried, before + 0.3 * eroded, 1e-12 * before);
}

}  // namespace
}  // namespace frana::test
