// SPDX-License-Identifier: Apache-2.0
#include "bench/stability/usual_slide.h"

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
        EXPECT_TRUE(static_cast<bool>(one.make)) << one.name;
    }
}

TEST(HardCases, TryEveryModel) {
    unsigned variants = 0;
    for (const HardCase& one : hard_cases()) variants |= one.variants;
    EXPECT_EQ(variants, k_particles | k_volumes | k_structured);
}

TEST(Stability, WritesOneLinePerCase) {
    StabilityOptions options;
    options.only = {"step-down", "film-1um"};
    const auto rows = run_stability(options);
    ASSERT_EQ(rows.size(), 4u);
    for (const StabilityRow& row : rows) {
        EXPECT_TRUE(row.passed) << row.case_name;
        EXPECT_GT(row.sound.steps, 0);
        EXPECT_GE(row.figures.size(), 2u);
    }
    const std::string csv = stability_csv(rows);
    EXPECT_EQ(csv.substr(0, csv.find('\n')), "case,scheme,passed,figure,limit,second_name,second_figure,second_limit");
    EXPECT_NE(csv.find("\nstep-down,finite-volume,true,"), std::string::npos);
}

// The usual slide whose friction follows from the size of the cells, as a wrong scheme's would.
TEST(Stability, FailsAFlowThatDependsOnItsCells) {
    HardCase wrong{"wrong", "friction from the cells", 8, [](const Variant& variant) {
                       bench::Setup setup = usual_slide(variant);
                       if (variant.cells < 1) setup.material = dry_friction(2);
                       return setup;
                   }};
    const StabilityRow row = run_case(wrong, {}, 1);
    EXPECT_FALSE(row.passed);
    EXPECT_GT(row.nearest().used(), 1);
    const std::string table = stability_table({row});
    EXPECT_NE(table.find("FAILED"), std::string::npos);
    EXPECT_NE(table.find("    " + row.nearest().name), std::string::npos) << table;
    EXPECT_NE(stability_csv({row}).find("\nwrong,default,false,"), std::string::npos);
}

TEST(Stability, FailsWhatLeavesThroughWalls) {
    bench::Setup closed = usual_slide();
    seeded([](Point p) { return Seed{usual_cap(p), 0, 80}; })(closed);
    TimedFlow leaving(closed);
    EXPECT_LT(watch(leaving, closed, 8).volume_error, 1e-12);
    TimedFlow open(closed);  // whose sides are not walls
    closed.numerics.boundary = Boundary::wall;
    EXPECT_GT(watch(open, closed, 8).volume_error, 0.1);
}

TEST(Figures, OfALimitOfZero) {
    EXPECT_EQ((Figure{"", 0, 0}).used(), 0);
    EXPECT_TRUE((Figure{"", 0, 0}).within());
    EXPECT_GT((Figure{"", 1e-300, 0}).used(), 1);
    EXPECT_FALSE((Figure{"", std::nan(""), 1}).within());
    EXPECT_GT((Figure{"", std::nan(""), 1}).used(), 1);
    StabilityRow row;
    row.figures = {{"own", 0.5, 1}, {"nearer", 0.9, 1}, {"far", 1, 10}};
    EXPECT_TRUE(row.good());
    EXPECT_EQ(row.nearest().name, "nearer");
    EXPECT_EQ(row.second().name, "nearer");
    row.figures[0].value = 1.5;
    EXPECT_FALSE(row.good());
    EXPECT_EQ(row.nearest().name, "own");
}

TEST(Mirror, OfAMirrorIsTheSame) {
    const bench::Setup setup = usual_slide();
    for (const bool west : {false, true}) {
        const bench::Setup twice = mirrored(mirrored(setup, west), west);
        EXPECT_TRUE(twice.bed.values == setup.bed.values);
        EXPECT_EQ(elsewhere(mirrored(mirrored(setup.bed, west), west), setup.bed), 0);
        EXPECT_NEAR(twice.seeds[Field::x][7], setup.seeds[Field::x][7], 1e-12);
    }
    EXPECT_GT(elsewhere(mirrored(setup.bed, true), setup.bed), 0.1);
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
