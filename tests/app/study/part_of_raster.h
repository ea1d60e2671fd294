// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <cmath>

#include "core/raster.h"

namespace frana::test {

/// Expects the values of a part of a raster's ground, and 0 outside it.
inline void expect_part(const Raster& part, const Raster& whole) {
    const auto left = std::llround((part.grid.west - whole.grid.west) / whole.grid.cell_size),
               top = std::llround((whole.grid.north - part.grid.north) / whole.grid.cell_size);
    for (std::int64_t row = 0; row < whole.grid.rows; ++row)
        for (std::int64_t column = 0; column < whole.grid.columns; ++column) {
            const std::int64_t r = row - top, c = column - left;
            const bool inside = r >= 0 && c >= 0 && r < part.grid.rows && c < part.grid.columns;
            EXPECT_EQ(whole.at(row, column), inside ? part.at(r, c) : 0.0) << row << " " << column;
        }
}

}  // namespace frana::test
