// SPDX-License-Identifier: Apache-2.0
// The depth that rasters show of a cell: free of the particles' unevenness, and never far from the volume it
// holds.
#include <gtest/gtest.h>

#include "mpm/node_grid.h"

namespace frana {
namespace {

constexpr double k_cell = 25, k_filled = 1;  // [m2]; supported all round

TEST(ShownDepth, IsTheParticlesMeanWhereTheyLieUnevenly) {
    // A layer of 2 m, of which the arrangement puts 5 % more or less into this cell.
    for (const double share : {0.95, 1.0, 1.05}) {
        const double area = share * k_cell;
        EXPECT_DOUBLE_EQ(shown_depth(2 * area, area, k_filled, 1 / k_cell), 2);
    }
}

TEST(ShownDepth, IsTheVolumesWhereParticlesCrowd) {
    // Each 2 m deep, and twice as many as the cell has room for: 4 m, less the tenth that may be unevenness.
    EXPECT_DOUBLE_EQ(shown_depth(2 * 2 * k_cell, 2 * k_cell, k_filled, 1 / k_cell), 4 / k_crowded_share);
    // It does not jump where crowding begins.
    const double limit = k_crowded_share * k_cell;
    EXPECT_NEAR(shown_depth(2 * limit, limit, k_filled, 1 / k_cell),
                shown_depth(2 * limit, limit * (1 + 1e-12), k_filled, 1 / k_cell), 1e-9);
}

TEST(ShownDepth, IsTheVolumesAtAFront) {
    EXPECT_DOUBLE_EQ(shown_depth(2 * 0.3 * k_cell, 0.3 * k_cell, 0, 1 / k_cell), 0.6);
    EXPECT_EQ(shown_depth(0, 0, 0, 1 / k_cell), 0);
}

}  // namespace
}  // namespace frana
