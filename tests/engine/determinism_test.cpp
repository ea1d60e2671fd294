// SPDX-License-Identifier: Apache-2.0
// The same flow gives the same bits for any number of threads, and on a second run.
#include <gtest/gtest.h>

#include <cstring>

#include "cases.h"

namespace frana::test {
namespace {

// A flow that spreads, splits, merges, meets a slope and leaves through an edge.
Flow::NodalFields end_state(int threads, std::size_t& particles) {
    const GridSpec grid = bench::plain_grid(120, 90, 2);
    const Raster bed =
        bench::sample_raster(grid, [](Point p) { return 0.3 * (240 - p.x) + 2 * std::sin(0.1 * p.y); });
    const ParticleSet seeds = bench::fill_lattice(
        grid, 2, 0.5, [](Point p) { return bench::Seed{8 - 0.2 * std::hypot(p.x - 60, p.y - 80)}; });
    Material material = dry_friction(10);
    material.turbulence = 500;
    material.viscosity = 500;
    material.yield_stress = 50;
    Flow flow(bed, seeds, material, numerics(Scheme::standard, SlopeCorrection::normal, Boundary::open),
              threads);
    flow.advance_to(12);
    particles = flow.particles().size();
    return flow.nodal_fields();
}

TEST(Determinism, SameBitsForAnyNumberOfThreads) {
    std::size_t count = 0;
    const Flow::NodalFields one = end_state(1, count);
    for (const int threads : {1, 2, 3, 7}) {
        std::size_t n = 0;
        const Flow::NodalFields many = end_state(threads, n);
        EXPECT_EQ(n, count);
        const auto same = [](const Raster& a, const Raster& b) {
            return std::memcmp(a.values.data(), b.values.data(), a.values.size() * sizeof(double)) == 0;
        };
        EXPECT_TRUE(same(one.depth, many.depth)) << threads << " threads";
        EXPECT_TRUE(same(one.momentum_x, many.momentum_x)) << threads << " threads";
        EXPECT_TRUE(same(one.momentum_y, many.momentum_y)) << threads << " threads";
    }
}

}  // namespace
}  // namespace frana::test
