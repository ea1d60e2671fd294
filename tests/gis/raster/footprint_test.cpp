// SPDX-License-Identifier: Apache-2.0
#include "gis/raster/footprint.h"

#include <gtest/gtest.h>

#include <cmath>

namespace frana::gis::test {
namespace {

const GridSpec k_grid{1000, 2100, 5, 20, 20, ""};

Raster cells_of(const MultiPolygon& outline, Cover cover, bool& thin) {
    Raster mask(k_grid);
    thin =
        visit_cells(outline, k_grid, cover, [&](std::int64_t row, std::int64_t column) { mask.at(row, column) += 1; });
    return mask;
}

double count(const Raster& mask) {
    double sum = 0;
    for (const double value : mask.values) sum += value;
    return sum;
}

MultiPolygon box(double west, double south, double east, double north) {
    return {{{{west, south}, {east, south}, {east, north}, {west, north}}, {}}};
}

TEST(Footprint, CoversCellsByTheirCentres) {
    bool thin = true;
    // Columns 2 to 5 and rows from the south 4 to 5 have their centres inside.
    const Raster mask = cells_of(box(1011, 2021, 1029, 2029), Cover::closed, thin);
    EXPECT_FALSE(thin);
    EXPECT_EQ(count(mask), 4 * 2);
    EXPECT_EQ(mask.at(19 - 4, 2), 1);
    EXPECT_EQ(mask.at(19 - 5, 5), 1);
}

TEST(Footprint, PartsThatOverlapCountOnceAndPartsFarApartCostOnlyTheirCells) {
    bool thin = true;
    MultiPolygon parts = box(1010, 2020, 1030, 2030);
    parts.push_back(box(1020, 2020, 1040, 2030).front());
    const Raster mask = cells_of(parts, Cover::centres, thin);
    EXPECT_EQ(count(mask), 6 * 2);
    EXPECT_EQ(mask.at(19 - 4, 4), 1);
    // 200 km apart on cells of 5 m: one window would have 1.6 thousand million cells.
    const GridSpec wide{0, 200'000, 5, 40'000, 40'000, ""};
    MultiPolygon corners = box(0, 199'990, 10, 200'000);
    corners.push_back(box(199'990, 0, 200'000, 10).front());
    std::vector<std::int64_t> cells;
    visit_cells(corners, wide, Cover::centres,
                [&](std::int64_t row, std::int64_t column) { cells.push_back(row * wide.columns + column); });
    EXPECT_EQ(cells,
              (std::vector<std::int64_t>{0, 1, 40'000, 40'001, 39'998 * 40'000 + 39'998, 39'998 * 40'000 + 39'999,
                                         39'999 * 40'000 + 39'998, 39'999 * 40'000 + 39'999}));
}

// An oblique dam one metre wide: every row of cells has one, and each touches the next by a side.
TEST(Footprint, LeavesNoGapInAThinDam) {
    const MultiPolygon dam{{{{1011, 2001}, {1012, 2001}, {1082, 2099}, {1081, 2099}}, {}}};
    bool thin = false;
    EXPECT_LT(count(cells_of(dam, Cover::centres, thin)), 20) << "by centres alone it has gaps";
    EXPECT_FALSE(thin);
    const Raster mask = cells_of(dam, Cover::closed, thin);
    EXPECT_TRUE(thin);
    for (std::int64_t row = 0; row < 20; ++row) {
        bool any = false, joined = row == 0;
        for (std::int64_t column = 0; column < 20; ++column) {
            any = any || mask.at(row, column) == 1;
            joined = joined || (mask.at(row, column) == 1 && mask.at(row - 1, column) == 1);
        }
        EXPECT_TRUE(any) << row;
        EXPECT_TRUE(joined) << row;
    }
}

TEST(Footprint, LeavesOutPartsBeyondTheGrid) {
    bool thin = false;
    EXPECT_EQ(count(cells_of(box(1090, 2090, 1500, 2500), Cover::centres, thin)), 4);
    EXPECT_EQ(count(cells_of(box(3000, 2090, 3500, 2500), Cover::centres, thin)), 0);
}

}  // namespace
}  // namespace frana::gis::test
