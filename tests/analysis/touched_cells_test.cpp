// SPDX-License-Identifier: Apache-2.0
#include "analysis/touched_cells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace frana {
namespace {

/// 4 x 3 cells of 10 m; the cell in row r and column c has the number 4 r + c.
GridSpec grid() {
    GridSpec grid;
    grid.west = 100;
    grid.north = 230;
    grid.cell_size = 10;
    grid.columns = 4;
    grid.rows = 3;
    return grid;
}
using Cells = std::vector<std::size_t>;

Polygon box(double west, double south, double east, double north) {
    return {{{west, south}, {east, south}, {east, north}, {west, north}}, {}};
}

TEST(TouchedCells, PointIsInOneCell) {
    EXPECT_EQ(touched_cells({{}, {}, {{105, 225}}}, grid()), (Cells{0}));
    EXPECT_EQ(touched_cells({{}, {}, {{110, 220}}}, grid()), (Cells{5})) << "on a corner: the south-eastern one";
    EXPECT_TRUE(touched_cells({{}, {}, {{99, 225}}}, grid()).empty());
}

TEST(TouchedCells, AreaTouchesCellsOfWhichItCoversAPart) {
    EXPECT_EQ(touched_cells({{box(101, 221, 109, 229)}, {}, {}}, grid()), (Cells{0}));
    EXPECT_EQ(touched_cells({{box(109.9, 219.9, 110.1, 220.1)}, {}, {}}, grid()), (Cells{0, 1, 4, 5}));
    EXPECT_EQ(touched_cells({{box(110, 210, 120, 220)}, {}, {}}, grid()), (Cells{5})) << "exactly one cell";
    EXPECT_EQ(touched_cells({{box(0, 0, 1000, 1000)}, {}, {}}, grid()).size(), 12U);
    Polygon ring = box(101, 201, 139, 229);
    ring.holes = {box(110, 210, 130, 220).outer};
    EXPECT_EQ(touched_cells({{ring}, {}, {}}, grid()), (Cells{0, 1, 2, 3, 4, 7, 8, 9, 10, 11})) << "hole";
}

TEST(TouchedCells, LineTouchesCellsThroughWhichItRuns) {
    EXPECT_EQ(touched_cells({{}, {{{102, 228}, {138, 228}}}, {}}, grid()), (Cells{0, 1, 2, 3}));
    EXPECT_EQ(touched_cells({{}, {{{100, 230}, {130, 200}}}, {}}, grid()), (Cells{0, 5, 10})) << "diagonal";
    EXPECT_EQ(touched_cells({{}, {{{100, 220}, {140, 220}}}, {}}, grid()), (Cells{4, 5, 6, 7})) << "along a border";
    EXPECT_EQ(touched_cells({{}, {{{-900, 215}, {1100, 215}}}, {}}, grid()), (Cells{4, 5, 6, 7})) << "from outside";
}

// Against a search of a thousand places: no cell in which the area has a place is missing, none is added whose distance
// from all of them is great.
TEST(TouchedCells, AgreesWithASearchOfPlaces) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> x(95, 145), y(195, 235);
    for (int trial = 0; trial < 50; ++trial) {
        const Polygon triangle{{{x(random), y(random)}, {x(random), y(random)}, {x(random), y(random)}}, {}};
        const Cells cells = touched_cells({{triangle}, {}, {}}, grid());
        for (std::size_t cell = 0; cell < 12; ++cell) {
            bool found = false;
            constexpr int k_places = 40;
            for (int i = 0; i < k_places * k_places && !found; ++i) {
                const Point p{100 + 10 * static_cast<double>(cell % 4) + 10 * (i % k_places + 0.5) / k_places,
                              230 - 10 * static_cast<double>(cell / 4) - 10 * (i / k_places + 0.5) / k_places};
                found = contains(triangle, p);
            }
            if (found) {
                EXPECT_TRUE(std::find(cells.begin(), cells.end(), cell) != cells.end()) << trial << ' ' << cell;
            }
        }
    }
}

TEST(TouchedCells, PlaceOnTheMap) {
    const Bounds map = grid().bounds();
    EXPECT_EQ(place_of({{box(101, 201, 109, 209)}, {}, {}}, map), MapPlace::inside);
    EXPECT_EQ(place_of({{box(90, 201, 109, 209)}, {}, {}}, map), MapPlace::partly);
    EXPECT_EQ(place_of({{box(0, 0, 1000, 1000)}, {}, {}}, map), MapPlace::partly) << "round the map";
    EXPECT_EQ(place_of({{box(0, 0, 10, 10)}, {}, {}}, map), MapPlace::outside);
    EXPECT_EQ(place_of({{}, {}, {{500, 500}}}, map), MapPlace::outside);
}

}  // namespace
}  // namespace frana
