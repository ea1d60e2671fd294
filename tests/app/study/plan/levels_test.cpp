// SPDX-License-Identifier: Apache-2.0
#include "app/study/plan/levels.h"

#include <cmath>
#include <set>

#include "app/study/statistics/study_maps.h"
#include "study/records.h"

namespace frana::app::study::test {
namespace {

class Levels : public Records {
  protected:
    /// Adds a member: 1 m deep in the first cell if each of its runs reaches it.
    void add_member(std::size_t level, double weight, bool fine, bool coarse = false) {
        add_run(level, weight, fine);
        if (level > 0) add_run(level, -weight, coarse);
    }

  private:
    void add_run(std::size_t level, double weight, bool reaches) {
        add(record(0, reaches ? std::vector<float>{1} : std::vector<float>{}));
        weights_.push_back(weight);
        members_.weights = weights_;
        members_.levels.push_back(level);
    }
    std::vector<double> weights_;
};

// A number even in 0..9: the fine run reaches the cell from 3 on, with probability 0.7, the coarse one from 5 on. With
// every number once on both levels the estimate is exact.
TEST_F(Levels, TheirDifferencesAddUpToTheProbabilityOnTheFinestCells) {
    for (int u = 0; u < 10; ++u) add_member(0, 0.1, u >= 5);
    for (int u = 0; u < 10; ++u) add_member(1, 0.1, u >= 3, u >= 5);
    const QuantityMaps maps = quantity_maps(members_, Quantity::depth, grid_, {0.5});
    EXPECT_DOUBLE_EQ(maps.probability[0].at(0, 0), 0.7);
    // a = 1 and b = 2 / 5; the coarsest p of 0.5 has the variance 1 / 40, b as (2 + 0) of 6 pairs 2 / 9 / 6.
    EXPECT_DOUBLE_EQ(maps.errors.largest(), std::sqrt(0.36 / 40 + 0.25 * 2 / 54));
    EXPECT_DOUBLE_EQ(maps.mean.at(0, 0), 0.7);
    const LevelVariances variances = level_variances(members_, Quantity::depth, grid_, {0.5, 2}, 2);
    EXPECT_DOUBLE_EQ(variances.differences[0], 2.5 / 9);
    EXPECT_DOUBLE_EQ(variances.differences[1], 1.6 / 9);
    EXPECT_DOUBLE_EQ(variances.own, 2.1 / 9);
}

// The sum of differences is 5 / 4.
TEST_F(Levels, WhereAllCoarsestRunsReachItIsNoMoreThanOne) {
    for (int u = 0; u < 4; ++u) add_member(0, 0.25, true);
    for (int u = 0; u < 4; ++u) add_member(1, 0.25, true, u > 0);
    const QuantityMaps maps = quantity_maps(members_, Quantity::depth, grid_, {0.5});
    EXPECT_EQ(maps.probability[0].at(0, 0), 1);
    EXPECT_GT(maps.margin[0].at(0, 0), 0);
}

TEST_F(Levels, OneMemberTellsNoError) {
    add_member(0, 0.5, true);
    add_member(0, 0.5, false);
    add_member(1, 1, true, true);
    const QuantityMaps maps = quantity_maps(members_, Quantity::depth, grid_, {0.5});
    EXPECT_EQ(maps.probability[0].at(0, 0), 0.5);
    EXPECT_EQ(maps.errors.largest(), 0.5);
}

// A cell of 20 m covers four of 10 m.
TEST_F(Levels, ACoarseRunHasOneValueForAllCellsWithinItsOwn) {
    MemberRecord coarse = record(1, {3});
    coarse.cell_size = 20;
    coarse.columns = 2;
    coarse.rows = 1;
    const Raster depth = coarse.raster(Quantity::depth, grid_);
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 4; ++column)
            EXPECT_EQ(depth.at(row, column) == 3, row < 2 && column >= 2) << row << ", " << column;
    coarse.west = 5;
    EXPECT_THROW((void)coarse.place_in(grid_), Error);
    coarse.west = 0;
    coarse.cell_size = 15;
    EXPECT_THROW((void)coarse.place_in(grid_), Error);
}

// Members in proportion to sqrt(V / C): 2 : 1/2 of a budget of 40, level 0 costs 1, level 1 costs 4.
TEST(Allocation, IsThatOfGiles) {
    EXPECT_EQ(allocate_members({{0, 4, 1}, {0, 1, 4}}, 40), (std::vector<std::size_t>{20, 5}));
    // A level that has more than its part keeps its members; the others share the rest: 40 - 8 * 4 = 8.
    EXPECT_EQ(allocate_members({{0, 4, 1}, {8, 1, 4}}, 40), (std::vector<std::size_t>{8, 8}));
    EXPECT_EQ(allocate_members({{3, 0, 1}, {5, 0, 4}}, 40), (std::vector<std::size_t>{3, 5}));
    EXPECT_EQ(allocate_members({{30, 4, 1}, {8, 1, 4}}, 40), (std::vector<std::size_t>{30, 8}));
}

// With the best allocation the variance is (sum sqrt(V C))^2 / budget; any other of the same cost has more.
TEST(Allocation, HasTheLeastVarianceOfItsCost) {
    const std::vector<LevelStatistics> levels{{0, 9, 1}, {0, 4, 10}, {0, 1, 90}};
    const double budget = 1e6, root = 3 + std::sqrt(40.0) + std::sqrt(90.0);
    const auto members = allocate_members(levels, budget);
    double variance = 0, cost = 0;
    for (std::size_t l = 0; l < 3; ++l) {
        variance += levels[l].variance / static_cast<double>(members[l]);
        cost += levels[l].cost * static_cast<double>(members[l]);
    }
    EXPECT_LE(cost, budget);
    EXPECT_NEAR(variance, root * root / budget, 1e-3 * variance);  // whole members
}

TEST(Draws, OfALevelAreIndependentOfOthersAndOfTheNumberTaken) {
    StudySpec study;
    study.samples = 10;
    study.levels = 3;
    study.sampling = Sampling::random;
    study.vary.push_back({"material.friction-coefficient", {Law::uniform, {0.1, 0.3}, {}, {}, "uniform(0.1, 0.3)"}});
    Problems problems;
    const auto draws = draw_levels(study, "study.ini", problems);
    ASSERT_TRUE(problems.empty());
    ASSERT_EQ(draws.size(), 3U);
    EXPECT_EQ(draws[2].size(), 10U);
    EXPECT_EQ(draws[1].size(), 80U);
    EXPECT_EQ(draws[0].size(), 640U);
    std::set<std::string> first;
    for (const SampleTable& level : draws) first.insert(level.values[0][0]);
    EXPECT_EQ(first.size(), 3U);

    SampleTable table;
    append_members(draws[0], 0, 0, 2, 20, table);
    append_members(draws[2], 2, 3, 4, 5, table);
    ASSERT_EQ(table.size(), 4U);
    EXPECT_EQ(table.overrides(1).back(), "terrain.cell-size=20");
    EXPECT_EQ(table.overrides(2).back(), "terrain.cell-size=5");
    EXPECT_EQ(table.overrides(3).back(), "terrain.cell-size=10");
    EXPECT_EQ(table.values[2], table.values[3]);  // the same draw on both cells of a difference
    EXPECT_EQ(table.values[2], draws[2].values[3]);
    EXPECT_EQ(pilot_members(200, 3), (std::vector<std::size_t>{48, 24, 12}));
}

}  // namespace
}  // namespace frana::app::study::test
