// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "mpm/node_grid.h"

namespace frana::test {
namespace {

TEST(NodePhase, RecordsAreReadOnlyInTheirPhase) {
    GridSpec grid;
    grid.cell_size = 5;
    grid.columns = grid.rows = 4;
    grid.north = 20;
    NodeGrid nodes{Raster(grid, 0.0)};
    nodes.sums()->mass = 3;
    EXPECT_DEBUG_DEATH((void)nodes.motion(), "phase");  // only builds with assertions abort
    nodes.phase = NodePhase::motion;
    EXPECT_EQ(nodes.motion()->mass, 3);
    EXPECT_EQ(nodes.mass(0), 3);
    EXPECT_DEBUG_DEATH((void)nodes.sums(), "phase");
}

}  // namespace
}  // namespace frana::test
