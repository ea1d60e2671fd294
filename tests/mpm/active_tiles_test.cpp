// SPDX-License-Identifier: Apache-2.0
// What rests costs nothing, and nothing else changes by it: the same bits as when all is computed.
#include <gtest/gtest.h>

#include <cstring>

#include "support/cases.h"

namespace frana::test {
namespace {

// A wide low mound that rests, and a steep heap 4 m high beside it that collapses.
struct MoundAndHeap {
    double heap_x;
    GridSpec grid = bench::plain_grid(270, 120, 1);

    [[nodiscard]] Flow flow(double friction_deg) const {
        const Raster bed = bench::sample_raster(grid, [](Point p) { return 0.01 * p.y; });
        const ParticleSet seeds = bench::fill_lattice(grid, 2, 0.3, [this](Point p) {
            const double mound = 1.5 - 0.03 * std::hypot(p.x - 80, p.y - 60);
            const double heap = 4 - 1.0 * std::hypot(p.x - heap_x, p.y - 60);
            return bench::Seed{std::max(mound, heap)};
        });
        return Flow(bed, seeds, dry_friction(friction_deg),
                    numerics(Scheme::standard, SlopeCorrection::normal, Boundary::open), 1);
    }
};

void expect_equal_bits(const Flow& a, const Flow& b) {
    ASSERT_EQ(a.particles().size(), b.particles().size());
    for (const Field field : {Field::x, Field::y, Field::u, Field::v, Field::area, Field::volume, Field::q_xx}) {
        EXPECT_EQ(std::memcmp(a.particles()[field], b.particles()[field], a.particles().size() * sizeof(double)), 0)
            << "field " << static_cast<int>(field);
    }
    EXPECT_EQ(std::memcmp(a.maxima().depth.data(), b.maxima().depth.data(), a.maxima().depth.size() * sizeof(double)),
              0);
}

TEST(ActiveTiles, MaterialAtRestCostsNothingAndChangesNothing) {
    const MoundAndHeap scene{240};
    Flow one = scene.flow(12), all = scene.flow(12);
    all.compute_what_rests();
    bool slept = false;
    while (one.time() < 4) {
        const std::size_t particles = one.particles().size();
        const auto a = one.advance(1e9), b = all.advance(1e9);
        ASSERT_EQ(a.dt, b.dt);
        EXPECT_EQ(a.particles.kinetic, b.particles.kinetic);
        EXPECT_EQ(a.nodes.covered, b.nodes.covered);
        EXPECT_EQ(b.moved, particles);
        slept = slept || a.moved < particles / 3;
    }
    EXPECT_TRUE(slept) << "of the particles nine tenths lie in the mound";
    expect_equal_bits(one, all);
    one.advance_to(60);
    for (int i = 0; i < 3; ++i) one.advance(1);  // looking at it woke it
    EXPECT_EQ(one.advance(1).moved, 0U) << "all has come to rest";
}

TEST(ActiveTiles, MaterialAtRestIsReactivatedByAFlow) {
    const MoundAndHeap scene{150};
    Flow one = scene.flow(3.0), all = scene.flow(3.0);
    all.compute_what_rests();
    one.advance_to(8);
    all.advance_to(8);
    expect_equal_bits(one, all);
}

}  // namespace
}  // namespace frana::test
