// SPDX-License-Identifier: Apache-2.0
// Values in tiles are those that lie side by side; tiles exist where something was written or asked of a source.
#include "core/cell_values.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/archive.h"
#include "core/raster.h"
#include "core/zero_array.h"

namespace frana {
namespace {

constexpr std::int64_t k_rows = 300, k_columns = 517;

double numbered(std::int64_t row, std::int64_t column) {
    return static_cast<double>(row * 1000 + column);
}

TEST(CellValues, HoldsWhatWasWrittenAndElseTheFillValue) {
    CellValues values = CellValues::tiled(k_rows, k_columns, -1);
    EXPECT_EQ(values.size(), static_cast<std::size_t>(k_rows * k_columns));
    EXPECT_EQ(values.stored_cells(), 0);
    const std::size_t places[] = {0, 63, 64, 516, 517, 517 * 64 + 65, 517 * 299 + 516};
    for (const std::size_t place : places) values[place] = static_cast<double>(place) + 0.5;
    EXPECT_EQ(values.stored_cells(), 5 * 64 * 64);
    std::size_t found = 0, before = 0;
    values.for_each_stored([&](std::size_t cell, double value) {
        EXPECT_TRUE(found == 0 || cell > before);
        before = cell;
        if (value == -1) return;
        EXPECT_EQ(value, static_cast<double>(places[found++]) + 0.5);
    });
    EXPECT_EQ(found, std::size(places));
    const CellValues copy = values;
    EXPECT_EQ(copy[1], -1);
    EXPECT_EQ(copy[63], 63.5);
    EXPECT_EQ(copy.stored_cells(), values.stored_cells());
    const std::vector<double> all = copy.dense();
    for (std::size_t cell = 0; cell < all.size(); ++cell) ASSERT_EQ(all[cell], std::as_const(values)[cell]) << cell;
}

TEST(CellValues, AsksItsSourceOnceForEveryTile) {
    std::vector<int> asked(k_rows * k_columns, 0);
    CellValues values = CellValues::tiled(k_rows, k_columns, 0, [&](const CellWindow& w, double* to) {
        for (std::int64_t row = w.row; row < w.row + w.rows; ++row) {
            for (std::int64_t column = w.column; column < w.column + w.columns; ++column) {
                ++asked[static_cast<std::size_t>(row * k_columns + column)];
                *to++ = numbered(row, column);
            }
        }
    });
    EXPECT_EQ(std::as_const(values)[517 * 10 + 500], numbered(10, 500));
    EXPECT_LT(values.stored_cells(), k_rows * k_columns);
    values[3] = 7;
    for (std::int64_t row = 0; row < k_rows; ++row)
        for (std::int64_t column = 0; column < k_columns; ++column)
            ASSERT_EQ(std::as_const(values)[static_cast<std::size_t>(row * k_columns + column)],
                      row == 0 && column == 3 ? 7 : numbered(row, column));
    for (const int count : asked) ASSERT_EQ(count, 1);
}

TEST(CellValues, AreTiledOnLargeMapsOnly) {
    GridSpec grid;
    grid.rows = 1000;
    grid.columns = 10'000;
    EXPECT_FALSE(Raster(grid).values.is_tiled());
    grid.rows = 20'000;
    grid.columns = 20'000;
    const Raster large(grid, k_no_data);
    EXPECT_TRUE(large.values.is_tiled());
    EXPECT_TRUE(std::isnan(large.at(19'999, 19'999)));
    EXPECT_EQ(large.values.stored_cells(), 0);
}

TEST(CellValues, TellsWindowsRoundWhatIsStored) {
    CellValues values = CellValues::tiled(k_rows, k_columns, 0);
    values[0] = values[517 * 70 + 70] = 1;  // tiles that touch at a corner
    values[517 * 290 + 400] = 1;
    const std::vector<CellWindow> windows = values.stored_windows(k_columns);
    ASSERT_EQ(windows.size(), 2U);
    EXPECT_EQ(windows[0].rows, 128);
    EXPECT_EQ(windows[0].columns, 128);
    EXPECT_EQ(windows[1].row, 256);
    EXPECT_EQ(windows[1].rows, 44);
    EXPECT_EQ(windows[1].column, 384);
    EXPECT_TRUE(values.stores_any({100, 100, 5, 5}));
    EXPECT_FALSE(values.stores_any({100, 200, 100, 100}));
}

// Ten gigabytes of zeros, of which three numbers differ, are saved and read in kilobytes and without touching them.
TEST(ZeroArray, IsSavedWhereItWasTouched) {
    constexpr std::size_t k_size = 10'000'000'000 / sizeof(double);
    ZeroArray<double> array(k_size);
    const std::size_t places[] = {5, 777'777'777, k_size - 1};
    for (const std::size_t place : places) array[place] = static_cast<double>(place);
    std::vector<std::byte> bytes;
    StateWriter writer([&](const void* from, std::size_t count) {
        const auto* const begin = static_cast<const std::byte*>(from);
        bytes.insert(bytes.end(), begin, begin + count);
    });
    writer(array);
    EXPECT_LT(bytes.size(), 50'000U);
    std::size_t at = 0;
    StateReader reader(
        [&](void* to, std::size_t count) {
            std::memcpy(to, bytes.data() + at, count);
            at += count;
        },
        bytes.size());
    ZeroArray<double> read(k_size);
    reader(read);
    for (const std::size_t place : places) EXPECT_EQ(read[place], static_cast<double>(place));
    EXPECT_EQ(read[6], 0);
    EXPECT_EQ(reader.left(), 0U);
}

TEST(CellValues, CopiesShareWhatTheyHaveUntilOneIsChanged) {
    CellValues values(30, 40, 1.5);
    const CellValues copy = values, another = copy;
    const CellValues& same = values;
    EXPECT_EQ(copy.data(), same.data());
    EXPECT_EQ(another.data(), same.data());
    values[7] = 2;
    EXPECT_EQ(copy.data(), another.data());
    EXPECT_NE(copy.data(), same.data());
    EXPECT_EQ(copy[7], 1.5);
    EXPECT_EQ(same[7], 2);
    const double* const place = same.data();
    values[8] = 3;  // nobody shares it any more
    EXPECT_EQ(same.data(), place);
    CellValues changed = copy;
    changed.change_each_stored([](std::size_t, double& value) { value += 1; });
    EXPECT_EQ(changed[0], 2.5);
    EXPECT_EQ(copy[0], 1.5);
    EXPECT_EQ(CellValues().size(), 0U);
    CellValues none, grown = none;
    grown.push_back(4);
    EXPECT_EQ(none.size(), 0U);
    EXPECT_EQ(grown.size(), 1U);
}

}  // namespace
}  // namespace frana
