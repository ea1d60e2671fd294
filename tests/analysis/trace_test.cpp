// SPDX-License-Identifier: Apache-2.0
#include "analysis/trace.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace frana {
namespace {

Raster two_by_two(std::vector<double> values) {
    GridSpec grid;
    grid.west = 100;
    grid.north = 220;
    grid.cell_size = 10;
    grid.columns = 2;
    grid.rows = 2;
    Raster raster(grid);
    raster.values = std::move(values);
    return raster;
}

TEST(Trace, MaskAndArea) {
    const Raster mask = trace_mask(two_by_two({0.5, 0.1, k_no_data, 2}), 0.1);
    EXPECT_EQ(mask.values, (std::vector<double>{1, 0, 0, 1}));
    EXPECT_EQ(masked_area(mask), 200);
    EXPECT_EQ(masked_area(two_by_two({k_no_data, 0, 3, 1})), 200);
}

// Against the nearest cell of the other side, searched one by one, on random maps of 9 x 7 cells.
TEST(Trace, DistancesFromTheRimAreThoseToTheNearestCell) {
    constexpr std::size_t columns = 9, rows = 7;
    std::mt19937 random(5);
    for (int map = 0; map < 50; ++map) {
        std::vector<char> inside(columns * rows);
        for (char& one : inside) one = random() % 50 < static_cast<unsigned>(map) ? 1 : 0;
        const std::vector<double> distances = distances_from_rim(inside, columns);
        for (std::size_t i = 0; i < inside.size(); ++i) {
            double nearest = std::hypot(9.0, 7.0) + 0.5;  // there is no other side
            for (std::size_t k = 0; k < inside.size(); ++k)
                if (inside[k] != inside[i])
                    nearest = std::min(nearest,
                                       std::hypot(static_cast<double>(i % columns) - static_cast<double>(k % columns),
                                                  static_cast<double>(i / columns) - static_cast<double>(k / columns)));
            EXPECT_DOUBLE_EQ(distances[i], inside[i] != 0 ? nearest - 0.5 : 0.5 - nearest) << map << ", " << i;
        }
    }
}

TEST(Trace, MaximumIgnoresNoData) {
    EXPECT_EQ(maximum(two_by_two({k_no_data, -3, k_no_data, -1})), -1);
    EXPECT_TRUE(std::isnan(maximum(two_by_two({k_no_data, k_no_data, k_no_data, k_no_data}))));
}

TEST(Trace, PaddingKeepsCellsInPlace) {
    const Raster raster = two_by_two({1, 2, 3, 4});
    const Raster padded = padded_to(raster, {85, 195, 121, 221}, -1);
    EXPECT_EQ(padded.grid.west, 80);
    EXPECT_EQ(padded.grid.north, 230);
    EXPECT_EQ(padded.grid.columns, 5);
    EXPECT_EQ(padded.grid.rows, 4);
    for (std::int64_t row = 0; row < 2; ++row)
        for (std::int64_t column = 0; column < 2; ++column)
            EXPECT_EQ(padded.at(row + 1, column + 2), raster.at(row, column));
    EXPECT_EQ(padded.at(0, 0), -1);
    EXPECT_EQ(padded.at(3, 4), -1);
}

TEST(Trace, NoPaddingInside) {
    const Raster raster = two_by_two({1, 2, 3, 4});
    EXPECT_EQ(padded_to(raster, {105, 205, 120, 220}, -1).values, raster.values);
}

}  // namespace
}  // namespace frana
