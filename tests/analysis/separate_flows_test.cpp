// SPDX-License-Identifier: Apache-2.0
#include "analysis/separate_flows.h"

#include <gtest/gtest.h>

#include <random>
#include <string>

#include "analysis/runout.h"
#include "core/error.h"

namespace frana {
namespace {

GridSpec grid_of(std::int64_t rows, std::int64_t columns) {
    GridSpec grid;
    grid.west = 1000;
    grid.north = 2000;
    grid.cell_size = 10;
    grid.rows = rows;
    grid.columns = columns;
    return grid;
}

/// One letter per cell: any letter is 1, a dot 0.
Raster drawn(const std::vector<std::string>& rows) {
    Raster raster(grid_of(static_cast<std::int64_t>(rows.size()), static_cast<std::int64_t>(rows[0].size())));
    for (std::size_t row = 0; row < rows.size(); ++row)
        for (std::size_t column = 0; column < rows[row].size(); ++column)
            raster.at(static_cast<std::int64_t>(row), static_cast<std::int64_t>(column)) = rows[row][column] != '.';
    return raster;
}

/// The flows of all cells, as a drawing.
std::vector<std::string> numbers(const SeparateFlows& flows, const Raster& raster) {
    std::vector<std::string> rows(static_cast<std::size_t>(raster.grid.rows));
    for (std::size_t cell = 0; cell < raster.values.size(); ++cell) {
        const std::size_t flow = flows.flow_of(cell);
        rows[cell / static_cast<std::size_t>(raster.grid.columns)] +=
            flow == flows.count() ? '.' : static_cast<char>('0' + flow);
    }
    return rows;
}

TEST(SeparateFlows, WhatLeapedBelongsToTheNearestFlow) {
    const Raster release = drawn({"r.........r", "...........", "..........."});
    const Raster reached = drawn({"x.........x", "...x..x....", "..........."});
    EXPECT_EQ(numbers(SeparateFlows(release, reached), reached),
              (std::vector<std::string>{"0.........1", "...0..1....", "..........."}));
    // An inflow there is a flow of its own.
    EXPECT_EQ(numbers(SeparateFlows(release, reached, {{1035, 1985}}), reached),
              (std::vector<std::string>{"0.........1", "...2..2....", "..........."}));
}

TEST(SeparateFlows, ReleasesInOneFlowAreOne) {
    const Raster release = drawn({"r....r", "......"});
    EXPECT_EQ(SeparateFlows(release, drawn({"xx..xx", "..xx.."})).count(), 1);
    EXPECT_EQ(SeparateFlows(release, drawn({"xx..xx", "......"})).count(), 2);
}

/// Against a flood fill of every cell, on random maps of both kinds of storage.
TEST(SeparateFlows, AreThoseOfAFloodFill) {
    std::mt19937 random(5);
    for (int trial = 0; trial < 200; ++trial) {
        const auto rows = static_cast<std::int64_t>(1 + random() % 90),
                   columns = static_cast<std::int64_t>(1 + random() % 90);
        Raster reached(grid_of(rows, columns));
        if (trial % 2 == 1) reached.values = CellValues::tiled(rows, columns, 0);
        const double fraction = 0.1 + 0.005 * trial / 2;
        for (std::size_t cell = 0; cell < reached.values.size(); ++cell)
            if (std::uniform_real_distribution<>()(random) < fraction) reached.values[cell] = 1;
        const SeparateFlows flows(Raster(reached.grid), reached);
        std::vector<std::size_t> expected(reached.values.size(), reached.values.size());
        std::size_t count = 0;
        for (std::size_t start = 0; start < expected.size(); ++start) {
            if (!(reached.values[start] > 0) || expected[start] < expected.size()) continue;
            std::vector<std::size_t> open{start};
            expected[start] = count;
            while (!open.empty()) {
                const auto at = static_cast<std::int64_t>(open.back());
                open.pop_back();
                for (std::int64_t r = std::max<std::int64_t>(0, at / columns - 1); r < std::min(rows, at / columns + 2);
                     ++r)
                    for (std::int64_t c = std::max<std::int64_t>(0, at % columns - 1);
                         c < std::min(columns, at % columns + 2); ++c) {
                        const auto next = static_cast<std::size_t>(r * columns + c);
                        if (!(reached.values[next] > 0) || expected[next] < expected.size()) continue;
                        expected[next] = count;
                        open.push_back(next);
                    }
            }
            ++count;
        }
        ASSERT_EQ(flows.count(), count) << trial;
        for (std::size_t cell = 0; cell < expected.size(); ++cell)
            ASSERT_EQ(flows.flow_of(cell), reached.values[cell] > 0 ? expected[cell] : count) << trial << " " << cell;
    }
}

TEST(SeparateFlows, DifferentGridsAreRefused) {
    GridSpec moved = grid_of(2, 3);
    moved.west += 10;
    EXPECT_THROW(SeparateFlows(Raster(moved), Raster(grid_of(2, 3))), Error);
}

/// A bed that falls 1 m per cell of 10 m to the east; releases of 2 m at its west and 300 m east of it.
TEST(Runouts, AreThoseOfEachFlowTheLongestFirst) {
    const GridSpec grid = grid_of(3, 40);
    Raster bed(grid), release(grid), reached(grid);
    for (std::int64_t row = 0; row < 3; ++row)
        for (std::int64_t column = 0; column < 40; ++column) bed.at(row, column) = 100 - static_cast<double>(column);
    release.at(1, 0) = release.at(1, 30) = 2;
    for (std::int64_t column = 0; column < 5; ++column) reached.at(1, column) = 1;
    for (std::int64_t column = 30; column < 38; ++column) reached.at(1, column) = 1;
    const std::vector<Runout> all = runouts(SeparateFlows(release, reached), bed, release, reached);
    ASSERT_EQ(all.size(), 2);
    EXPECT_EQ(all[0].horizontal_m, 70);  // columns 30 to 37
    EXPECT_EQ(all[0].drop_m, 9);         // 7 m of bed and 2 m of mass
    EXPECT_EQ(all[0].top.x, 1305);
    EXPECT_EQ(all[0].tip.x, 1375);
    EXPECT_EQ(all[0].covered_area_m2, 800);
    EXPECT_EQ(all[1].horizontal_m, 40);
    EXPECT_EQ(all[1].drop_m, 6);
    // atan(6/40) = 8.5308 degrees, from tables, to the digits written
    EXPECT_NEAR(all[1].reach_angle_deg, 8.5308, 1e-4);

    // Where they meet, they are one, from the highest release to the farthest cell.
    for (std::int64_t column = 5; column < 30; ++column) reached.at(1, column) = 1;
    const std::vector<Runout> met = runouts(SeparateFlows(release, reached), bed, release, reached);
    ASSERT_EQ(met.size(), 1);
    EXPECT_EQ(met[0].horizontal_m, 370);
    EXPECT_EQ(met[0].drop_m, 39);
}

TEST(Runouts, AFlowWithoutTraceIsNotListed) {
    const Raster release = drawn({"r.....r"}), reached = drawn({"xx....x"}), trace = drawn({"xx....."});
    const Raster bed(release.grid, 10);
    EXPECT_EQ(runouts(SeparateFlows(release, reached), bed, release, trace).size(), 1);
    EXPECT_EQ(runouts(SeparateFlows(release, reached), bed, release, Raster(bed.grid)).size(), 2);
}

TEST(Runouts, ADepositThatLeftItsReleaseIsThatOfItsFlow) {
    // The deposit of the upper flow lies nearer to the other release.
    const Raster release = drawn({"r......", ".......", "......r"}), reached = drawn({"xxxxxx.", ".......", "......x"}),
                 deposit = drawn({".....x.", ".......", "......x"});
    const Raster bed(release.grid, 10);
    const std::vector<Runout> all = runouts(SeparateFlows(release, reached), bed, release, deposit);
    EXPECT_EQ(all[0].horizontal_m, 50);
    EXPECT_EQ(all[1].horizontal_m, 0);
}

}  // namespace
}  // namespace frana
