// SPDX-License-Identifier: Apache-2.0
// Material at rest is not computed, with the same bits.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "solid_cases.h"

namespace frana::structured::test {
namespace {

// What rests is not computed again, and that takes not a bit off anything: a block that slides towards two at rest, one
// of which it hits, with water on part of them.
TEST(Rest, SleepsToTheSameBits) {
    ThreadPool pool(1);
    std::int64_t slept = 0;
    const auto run = [&](bool sleeps) {
        Case c(2);
        c.material.solid_fraction = 0.5;
        c.material.grain_density = 2400;
        c.material.cohesion = 2e4;
        c.material.bed_friction = std::tan(12 * k_degree);
        c.laws.solid.skips_rest = sleeps;
        c.laws.solid.elastic = Elasticity::from_young_and_bulk(5e6, 5e6 / 1.5);
        c.laws.fluid.wall = true;
        c.fill(10, 20, 18, 12, [](Point) { return bench::Seed{3, 8, 0}; });
        c.fill(32, 20, 24, 12, [](Point) { return bench::Seed{3}; });
        c.fill(60, 20, 24, 12, [](Point) { return bench::Seed{3}; });
        State state = c.start(flat(60, 24, 2), pool, true);
        std::vector<FluidSource> water;
        for (std::int64_t i = 28; i < 32; ++i) water.push_back({state.grid.index(i, 12), 0.2, 0, 0});
        receive(water, *state.fluid, state.grid, c.laws.fluid);
        slept = 0;
        for (int i = 0; i < 60; ++i) slept += step(state, c.laws, 0.05, pool).solids.skipped;
        return state;
    };
    const State awake = run(false);
    EXPECT_EQ(slept, 0);
    const State sleeping = run(true);
    EXPECT_GT(slept, 10000);
    const ParticleSet &a = awake.solid->particles, &b = sleeping.solid->particles;
    ASSERT_EQ(a.size(), b.size());
    double lost = 0;
    for (std::size_t f = 0; f < k_fields; ++f) {
        const auto field = static_cast<Field>(f);
        if (!a.mask().has(field)) continue;
        EXPECT_EQ(std::memcmp(a[field], b[field], a.size() * sizeof(double)), 0) << k_field_table[f].name;
    }
    for (std::size_t i = 0; i < a.size(); ++i) lost += 1 - a[Field::cohesion_ratio][i];
    EXPECT_GT(lost, 1);
}

// Broken material that has come to rest sleeps through whole steps: two heaps of it, one at rest from the start, one
// that slides towards it, hits it and stops, with and without water that flows past.
TEST(Rest, BrokenMaterialSleepsThroughStepsToTheSameBits) {
    ThreadPool pool(2);
    for (const bool wet : {false, true}) {
        std::int64_t slept = 0, last_slept = 0, last_all = 0, first_slept = 0;
        const auto run = [&](bool sleeps) {
            Case c(2);
            c.material.solid_fraction = wet ? 0.5 : 1;
            c.material.cohesion = 1e4;
            c.laws.solid.skips_rest = sleeps;
            c.laws.fluid.wall = true;
            c.fill(10, 20, 18, 12, [](Point) { return bench::Seed{0.5, 9, 0}; });
            c.fill(36, 10, 60, 60, [](Point) { return bench::Seed{0.5}; });
            State state = c.start(flat(60, 35, 2), pool, wet);
            double *const ratio = state.solid->particles[Field::cohesion_ratio];
            std::fill_n(ratio, state.solid->particles.size(), 0);
            prepare(state, c.laws, pool);
            if (wet) {
                std::vector<FluidSource> water;
                for (std::int64_t i = 30; i < 40; ++i) water.push_back({state.grid.index(i, 12), 0.4, 0.4, 0});
                receive(water, *state.fluid, state.grid, c.laws.fluid);
            }
            slept = 0;
            for (int i = 0; i < 150; ++i) {
                const StepReport report = step(state, c.laws, 0.05, pool);
                slept += report.solids.skipped;
                last_slept = report.solids.skipped;
                last_all = report.substeps * static_cast<std::int64_t>(state.solid->particles.size());
                if (i == 0) first_slept = report.solids.skipped;
            }
            return state;
        };
        const State awake = run(false);
        EXPECT_EQ(slept, 0);
        const State sleeping = run(true);
        EXPECT_GT(first_slept, 1000);  // from the first substep of the first step on
        EXPECT_EQ(last_slept, last_all);
        const ParticleSet &a = awake.solid->particles, &b = sleeping.solid->particles;
        ASSERT_EQ(a.size(), b.size());
        double moved = 0;
        for (std::size_t f = 0; f < k_fields; ++f) {
            const auto field = static_cast<Field>(f);
            if (!a.mask().has(field)) continue;
            EXPECT_EQ(std::memcmp(a[field], b[field], a.size() * sizeof(double)), 0) << k_field_table[f].name;
        }
        for (std::size_t i = 0; i < a.size(); ++i) moved += std::abs(a[Field::e_xx][i]) > 0.01;
        EXPECT_GT(moved, 100);
        const ZeroArray<double> &depth = awake.solid->nodes.depth, &same = sleeping.solid->nodes.depth;
        EXPECT_EQ(std::memcmp(depth.data(), same.data(), depth.size() * sizeof(double)), 0);
    }
}

}  // namespace
}  // namespace frana::structured::test
