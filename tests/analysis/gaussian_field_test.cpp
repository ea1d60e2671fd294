// SPDX-License-Identifier: Apache-2.0
#include "analysis/gaussian_field.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace frana {
namespace {

GridSpec grid_of(std::int64_t columns, std::int64_t rows, double cell_size) {
    GridSpec grid;
    grid.west = 527000;
    grid.north = 5094150;
    grid.cell_size = cell_size;
    grid.columns = columns;
    grid.rows = rows;
    return grid;
}

std::vector<double> field(const GridSpec& grid, const CellWindow& window, double range, std::int64_t seed) {
    std::vector<double> values(static_cast<std::size_t>(window.rows * window.columns));
    add_field({2, range, seed}, grid, window, values.data());
    return values;
}

// 400 fields: the variance of a point is known to 7 %, three times its standard error sqrt(2 / 400) is 21 %; the mean
// of all of a map's many independent places is known better.
TEST(GaussianField, HasTheVarianceAndTheCorrelationOfItsFormula) {
    const GridSpec grid = grid_of(24, 3, 5);
    for (const double range : {1.0, 50.0, 2000.0}) {  // less than a cell, ten cells, coarse lattice
        double square = 0, mean = 0;
        std::vector<double> product(24);
        constexpr int k_fields = 400;
        for (int seed = 0; seed < k_fields; ++seed) {
            const std::vector<double> z = field(grid, {0, 0, 3, 24}, range, seed);
            mean += z[30] / k_fields;
            square += z[30] * z[30] / k_fields;
            for (std::size_t k = 0; k < 24; ++k) product[k] += z[0] * z[k] / k_fields;
        }
        EXPECT_NEAR(mean, 0, 3 * 2 / 20.0) << range;
        EXPECT_NEAR(square, 4, 0.21 * 4) << range;
        for (const std::size_t k : {1U, 4U, 10U, 20U}) {
            const double distance = 5.0 * static_cast<double>(k),
                         exact = 4 * std::exp(-3 * distance * distance / (range * range));
            EXPECT_NEAR(product[k], exact, 0.21 * 4) << range << " m, " << distance << " m apart";
        }
    }
}

TEST(GaussianField, OfAPartIsThatPartOfTheField) {
    const GridSpec grid = grid_of(60, 40, 5);
    for (const double range : {8.0, 60.0, 900.0}) {
        const std::vector<double> all = field(grid, {0, 0, 40, 60}, range, 3),
                                  part = field(grid, {7, 11, 20, 30}, range, 3);
        // the same field on a grid that begins elsewhere
        GridSpec later = grid;
        later.west += 11 * 5;
        later.north -= 7 * 5;
        const std::vector<double> other = field(later, {0, 0, 20, 30}, range, 3);
        for (std::size_t row = 0; row < 20; ++row)
            for (std::size_t column = 0; column < 30; ++column) {
                ASSERT_EQ(part[row * 30 + column], all[(row + 7) * 60 + column + 11]) << range;
                ASSERT_EQ(part[row * 30 + column], other[row * 30 + column]) << range;
            }
    }
}

// Cells of 30 m and of 10 m have every ninth centre in common.
TEST(GaussianField, OfOneSeedIsTheSameOnEveryCellSize) {
    const GridSpec coarse = grid_of(20, 15, 30), fine = grid_of(60, 45, 10);
    for (const double range : {30.0, 200.0, 5000.0}) {
        const std::vector<double> of_coarse = field(coarse, {0, 0, 15, 20}, range, 3),
                                  of_fine = field(fine, {0, 0, 45, 60}, range, 3);
        for (std::size_t row = 0; row < 15; ++row)
            for (std::size_t column = 0; column < 20; ++column)  // sums of 324 products in another order: rounding
                ASSERT_NEAR(of_coarse[row * 20 + column], of_fine[(3 * row + 1) * 60 + 3 * column + 1], 1e-9) << range;
    }
}

TEST(GaussianField, AddsToValuesAndKeepsGaps) {
    const GridSpec grid = grid_of(3, 1, 5);
    std::vector<double> values{100, std::nan(""), 100};
    add_field({0.5, 20, 1}, grid, {0, 0, 1, 3}, values.data());
    EXPECT_NE(values[0], 100);
    EXPECT_NEAR(values[0], 100, 3);
    EXPECT_TRUE(std::isnan(values[1]));
}

}  // namespace
}  // namespace frana
