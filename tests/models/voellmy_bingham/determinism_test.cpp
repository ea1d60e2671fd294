// SPDX-License-Identifier: Apache-2.0
// The same flow gives the same bits for any number of threads, and on a second run.
#include <gtest/gtest.h>

#include <cstring>

#include "physics/laws.h"
#include "support/cases.h"

namespace frana::test {
namespace {

struct EndState {
    Flow::NodalFields nodes;
    ParticleSet particles;
};

enum class Kind { slide, mud, debris };

// A flow that spreads, splits, merges, meets a slope and leaves through an edge; with stress in the plane, or pore
// pressure.
EndState end_state(int threads, Kind kind) {
    const GridSpec grid = bench::plain_grid(120, 90, 2);
    const Raster bed = bench::sample_raster(grid, [](Point p) { return 0.3 * (240 - p.x) + 2 * std::sin(0.1 * p.y); });
    const ParticleSet seeds = bench::fill_lattice(
        grid, 2, 0.5, [](Point p) { return bench::Seed{8 - 0.2 * std::hypot(p.x - 60, p.y - 80)}; });
    Material material = dry_friction(10);
    material.of<TurbulentFriction>().turbulence = 500;
    if (kind == Kind::debris) {
        material.of<CoulombFriction>().pore_pressure_ratio = 0.7;
        material.of<CoulombFriction>().pore_fluid_density = 400;
        material.of<CoulombFriction>().hydraulic_diffusivity = 0.2;
        material.of<CoulombFriction>().solid_fraction = 0.59;
        material.of<CoulombFriction>().critical_solid_fraction = 0.6;
        material.of<CoulombFriction>().compressibility = 1e-5;
    }
    if (kind == Kind::mud) {
        material.of<BinghamStress>().viscosity = 500;
        material.of<BinghamStress>().yield_stress = 50;
    }
    Flow flow(bed, seeds, material, numerics(Scheme::standard, SlopeCorrection::normal, Boundary::open), threads);
    flow.advance_to(12);
    return {flow.nodal_fields(), flow.particles()};
}

class Determinism : public testing::TestWithParam<Kind> {};

TEST_P(Determinism, SameBitsForAnyNumberOfThreads) {
    const EndState one = end_state(1, GetParam());
    for (const int threads : {1, 2, 3, 7}) {
        const EndState many = end_state(threads, GetParam());
        const auto same = [](const Raster& a, const Raster& b) {
            return std::memcmp(a.values.data(), b.values.data(), a.values.size() * sizeof(double)) == 0;
        };
        EXPECT_TRUE(same(one.nodes.depth, many.nodes.depth)) << threads << " threads";
        EXPECT_TRUE(same(one.nodes.momentum_x, many.nodes.momentum_x)) << threads << " threads";
        EXPECT_TRUE(same(one.nodes.momentum_y, many.nodes.momentum_y)) << threads << " threads";
        ASSERT_EQ(one.particles.size(), many.particles.size());
        for (std::size_t f = 0; f < k_fields; ++f) {
            const auto field = static_cast<Field>(f);
            if (!one.particles.mask().has(field)) continue;
            const std::size_t bytes = one.particles.size() * sizeof(double);
            EXPECT_EQ(std::memcmp(one.particles[field], many.particles[field], bytes), 0)
                << k_field_table[f].name << ", " << threads << " threads";
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Flows, Determinism, testing::Values(Kind::slide, Kind::mud, Kind::debris),
                         [](const auto& tested) {
                             return tested.param == Kind::slide ? "Slide"
                                    : tested.param == Kind::mud ? "Mud"
                                                                : "Debris";
                         });

}  // namespace
}  // namespace frana::test
