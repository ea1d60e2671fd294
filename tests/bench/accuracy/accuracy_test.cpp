// SPDX-License-Identifier: Apache-2.0
#include "bench/accuracy/accuracy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/error.h"

namespace frana::bench {
namespace {

TEST(AccuracyCases, IncludeEveryNameOfTheContractAtFourResolutions) {
    const Raster terrain = sample_raster(plain_grid(16, 16, 5), [](Point p) { return p.x; });
    std::set<std::string> names;
    for (const AccuracyCase& one : accuracy_cases(terrain)) {
        EXPECT_TRUE(names.insert(one.name).second) << one.name << " stands twice";
        EXPECT_GE(one.cell_sizes.size(), 4u) << one.name;
        EXPECT_TRUE(std::is_sorted(one.cell_sizes.rbegin(), one.cell_sizes.rend())) << one.name;
    }
    for (const char* name : {"lake-z1", "lake-z2", "lake-island", "lake-dtm", "stoker", "stoker-weak", "stoker-thin",
                             "ritter", "ritter-rotated", "radial-wet", "radial-dry", "granular-slope", "similarity",
                             "thacker", "voellmy-plane", "bingham-slump", "sliding-block", "conservation"})
        EXPECT_EQ(names.count(name), 1u) << name;
}

TEST(Accuracy, RefusesUnknownCases) {
    AccuracyOptions options;
    options.only = {"stoker", "stokr"};
    try {
        run_accuracy(options);
        FAIL() << "an unknown case must be refused";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::input);
        EXPECT_NE(std::string(error.what()).find("stokr"), std::string::npos);
    }
}

std::vector<AccuracyRow> quick(const std::vector<std::string>& names) {
    AccuracyOptions options;
    options.quick = true;
    options.only = names;
    return run_accuracy(options);
}

TEST(Accuracy, RunsEverySchemeAtTwoResolutionsWhenQuick) {
    const auto rows = quick({"granular-slope", "sliding-block"});
    ASSERT_EQ(rows.size(), 12u);
    for (const AccuracyRow& row : rows) {
        EXPECT_TRUE(row.statistics.error.empty()) << row.case_name;
        EXPECT_EQ(row.statistics.particles > 0, row.scheme != Scheme::finite_volume);
        EXPECT_GT(row.statistics.steps, 0);
        EXPECT_GT(row.statistics.wall_seconds, 0);
        EXPECT_GT(row.statistics.cpu_seconds, 0);
        EXPECT_TRUE(std::isfinite(row.statistics.l1_depth) && row.statistics.l1_depth >= 0);
        EXPECT_TRUE(std::isfinite(row.statistics.l1_momentum) && row.statistics.l1_momentum >= 0);
    }
    EXPECT_TRUE(std::isnan(rows[0].observed_order)) << "the coarsest has nothing to be compared with";
    EXPECT_NEAR(rows[1].observed_order,
                std::log(rows[0].statistics.l1_depth / rows[1].statistics.l1_depth) / std::log(2.0), 1e-12);
    // The undisturbed block of the default scheme: the mark of the bench.
    const auto block = std::find_if(rows[1].statistics.own.begin(), rows[1].statistics.own.end(),
                                    [](const CaseStatistic& f) { return f.name == "block speed, relative error"; });
    ASSERT_NE(block, rows[1].statistics.own.end());
    EXPECT_TRUE(block->met()) << block->value;
}

// The measure itself: a flow that starts with the exact state has no error, and one compared with another state has
// exactly the difference.
TEST(CompareWithExact, MeasuresTheErrors) {
    bench::Setup setup;
    setup.bed = Raster(plain_grid(20, 10, 1), 0.0);
    setup.seeds = fill_lattice(setup.bed.grid, 2, 0, [](Point) { return Seed{2, 3, 0}; });
    setup.material = water();
    setup.numerics = numerics_of(Scheme::standard, SlopeCorrection::none, Boundary::wall);
    TimedFlow run(setup);
    const auto middle = [](Point p) { return std::abs(p.x - 10) < 5; };  // walls absorb the momentum at the ends
    const CaseStatistics none = compare_with_exact(
        run,
        [](Point) {
            return ExactState{2, 6, 0};
        },
        middle);
    EXPECT_NEAR(none.l1_depth, 0, 1e-14);
    EXPECT_NEAR(none.l1_momentum, 0, 1e-14);
    const CaseStatistics some = compare_with_exact(
        run,
        [](Point) {
            return ExactState{2.5, 6, 8};
        },
        middle);
    EXPECT_NEAR(some.l1_depth, 0.2, 1e-13);
    EXPECT_NEAR(some.l2_depth, 0.2, 1e-13);
    EXPECT_NEAR(some.linf_depth, 0.5, 1e-13);
    EXPECT_NEAR(some.mean_depth_error, 0.5, 1e-13);
    EXPECT_NEAR(some.l1_momentum, 0.8, 1e-13);  // |(6, 0) - (6, 8)| over |(6, 8)|
}

}  // namespace
}  // namespace frana::bench
