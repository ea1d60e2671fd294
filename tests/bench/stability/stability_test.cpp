// SPDX-License-Identifier: Apache-2.0
#include "bench/stability/stability.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace frana::bench {
namespace {

TEST(HardCases, AreAtLeastThirtyWithUniqueNames) {
    const auto cases = hard_cases();
    EXPECT_GE(cases.size(), 30u);
    std::set<std::string> names;
    for (const HardCase& one : cases) {
        EXPECT_TRUE(names.insert(one.name).second) << one.name;
        EXPECT_TRUE(static_cast<bool>(one.make) != static_cast<bool>(one.compare)) << one.name;
    }
}

TEST(Stability, WritesOneLinePerCase) {
    StabilityOptions options;
    options.only = {"step-down", "film-1um"};
    const auto rows = run_stability(options);
    ASSERT_EQ(rows.size(), 4u);
    for (const StabilityRow& row : rows) {
        EXPECT_TRUE(row.passed) << row.case_name;
        EXPECT_GT(row.sound.steps, 0);
    }
    const std::string csv = stability_csv(rows);
    EXPECT_EQ(csv.substr(0, csv.find('\n')), "case,scheme,passed,figure,limit");
    EXPECT_NE(csv.find("\nstep-down,finite-volume,true,"), std::string::npos);
}

TEST(Soundness, DetectsNonFiniteValues) {
    bench::Setup setup = usual_slide();
    ParticleRow row = setup.seeds.row(5);
    get(row, Field::u) = std::nan("");
    setup.seeds.set_row(5, row);
    TimedFlow run(setup);
    EXPECT_GT(watch(run, setup, 1).non_finite, 0);
}

TEST(Soundness, DetectsSpeedsAboveThatOfAFall) {
    // The bound includes the initial speed; here that is hidden from it, so the speed must exceed the bound.
    const bench::Setup setup = usual_slide();
    bench::Setup fast = setup;
    fast.seeds = fill_lattice(fast.bed.grid, 2, 0, [](Point p) { return Seed{usual_cap(p), 500, 0}; });
    TimedFlow run(fast);
    EXPECT_GT(watch(run, setup, 0.1).speed_ratio, 1);
}

}  // namespace
}  // namespace frana::bench
